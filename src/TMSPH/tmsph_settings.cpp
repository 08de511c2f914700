/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The words of pair_style tmsph, in an input and in restart files.
------------------------------------------------------------------------- */

#include "tmsph_settings.h"

#include "comm.h"
#include "error.h"
#include "tmsph_restart.h"
#include "tmsph_version.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace TMSPH;

// grows when what restart files hold of the pair style changes

static constexpr int RESTART_FORMAT = 3;

// with the zeros behind it

static constexpr int VERSION_LENGTH = 16;
static_assert(sizeof(VERSION) <= VERSION_LENGTH, "the version fits into restart files");

/* ----------------------------------------------------------------------
   looks a word up in a table, or stops with the words that would do
------------------------------------------------------------------------- */

template <class T>
static T one_of(Error *error, const char *keyword, const char *word,
                const std::vector<std::pair<std::string, T>> &table)
{
  std::string known;
  for (const auto &[name, value] : table) {
    if (name == word) return value;
    known += (known.empty() ? "" : " or ") + name;
  }
  error->all(FLERR, "Unknown value '{}' of pair_style tmsph {}: use {}", word, keyword, known);
  return T();
}

/* ---------------------------------------------------------------------- */

void TMSPHSettings::read(LAMMPS *lmp, int narg, char **arg)
{
  Error *const error = lmp->error;
  *this = TMSPHSettings();
  if (narg < 1) utils::missing_cmd_args(FLERR, "pair_style tmsph", error);
  horizon = utils::numeric(FLERR, arg[0], false, lmp);
  if (horizon <= 0.0)
    error->all(FLERR, "Horizon {} of pair_style tmsph must be positive: about 3 particle spacings",
               arg[0]);

  for (int iarg = 1; iarg < narg;) {
    const std::string word = arg[iarg];
    const int values = word == "viscosity" ? 2 : 1;
    const auto known = {"kernel",    "plane",     "law",       "thermal",
                        "hourglass", "viscosity", "dilatation"};
    if (std::find(known.begin(), known.end(), word) == known.end())
      error->all(FLERR,
                 "Unknown pair_style tmsph keyword '{}': use kernel, plane, law, hourglass, "
                 "viscosity, thermal or dilatation",
                 word);
    if (iarg + values >= narg) utils::missing_cmd_args(FLERR, "pair_style tmsph " + word, error);
    const char *value = arg[iarg + 1];
    if (word == "kernel")
      kernel = one_of<Kernel>(error, "kernel", value, kernels());
    else if (word == "plane")
      plane =
          one_of<Plane>(error, "plane", value,
                        {{"strain", Plane::STRAIN}, {"stress", Plane::STRESS}});
    else if (word == "law")
      law = one_of<ElasticLaw>(error, "law", value, alternatives<ElasticLaw>());
    else if (word == "thermal")
      thermal = one_of<ThermalStrain>(
          error, "thermal", value,
          {{"bond", ThermalStrain::BOND}, {"strain", ThermalStrain::CONSTITUTIVE}});
    else if (word == "dilatation")
      dilatation = one_of<Dilatation>(error, "dilatation", value,
                                      {{"auto", Dilatation::AUTO},
                                       {"plain", Dilatation::PLAIN},
                                       {"averaged", Dilatation::AVERAGED}});
    else if (word == "hourglass") {
      hourglass = utils::numeric(FLERR, value, false, lmp);
      if (hourglass < 0.0)
        error->all(FLERR, "Pair_style tmsph hourglass {} must not be negative: 0.1 is usual",
                   value);
    } else {
      alpha1 = utils::numeric(FLERR, value, false, lmp);
      alpha2 = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
      if (alpha1 < 0.0 || alpha2 < 0.0)
        error->all(FLERR, "Pair_style tmsph viscosity {} {} must not be negative: 1 2 is usual",
                   value, arg[iarg + 2]);
    }
    iarg += 1 + values;
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHSettings::write_restart(FILE *fp) const
{
  const double list[8] = {horizon,   (double) kernel.index(), (double) plane, (double) thermal,
                          hourglass, alpha1,                  alpha2,         (double) dilatation};
  const int format_and_law[2] = {RESTART_FORMAT, (int) law.index()};
  char version[VERSION_LENGTH] = {};
  memcpy(version, VERSION, sizeof(VERSION));
  fwrite(format_and_law, sizeof(int), 2, fp);
  fwrite(version, 1, VERSION_LENGTH, fp);
  fwrite(list, sizeof(double), 8, fp);
}

/* ---------------------------------------------------------------------- */

void TMSPHSettings::read_restart(LAMMPS *lmp, FILE *fp)
{
  Error *const error = lmp->error;
  MPI_Comm world = lmp->world;
  double list[8];
  int format_and_law[2];
  const bool reads = lmp->comm->me == 0;
  if (reads) utils::sfread(FLERR, format_and_law, sizeof(int), 2, fp, nullptr, error);
  MPI_Bcast(format_and_law, 2, MPI_INT, 0, world);
  check_restart_format(error, "pair style tmsph", format_and_law[0], RESTART_FORMAT);
  if (reads) {
    char version[VERSION_LENGTH];
    utils::sfread(FLERR, version, 1, VERSION_LENGTH, fp, nullptr, error);
    utils::sfread(FLERR, list, sizeof(double), 8, fp, nullptr, error);
    version[VERSION_LENGTH - 1] = '\0';
    if (strcmp(version, VERSION) != 0)
      utils::logmesg(lmp, "  written by TMSPH {}, read by TMSPH {}\n", version, VERSION);
  }
  MPI_Bcast(list, 8, MPI_DOUBLE, 0, world);
  horizon = list[0];
  kernel = kernels().at((size_t) list[1]).second;
  plane = (Plane) (int) list[2];
  thermal = (ThermalStrain) (int) list[3];
  hourglass = list[4];
  alpha1 = list[5];
  alpha2 = list[6];
  dilatation = (Dilatation) (int) list[7];
  law = alternatives<ElasticLaw>().at(format_and_law[1]).second;
}
