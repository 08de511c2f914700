/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The words of pair_style tmsph, in an input and in restart files.
------------------------------------------------------------------------- */

#include "tmsph_settings.h"

#include "comm.h"
#include "error.h"
#include "tmsph_restart.h"
#include "tmsph_version.h"
#include "tmsph_words.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace TMSPH;

// grows when what restart files hold of the pair style changes

static constexpr int RESTART_FORMAT = 3;

// with the zeros behind it

static constexpr int VERSION_LENGTH = 16;
static_assert(sizeof(VERSION) <= VERSION_LENGTH, "the version fits into restart files");

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

  TMSPHWords(
      lmp, "pair_style tmsph",
      {{"kernel", "name", [this](TMSPHValues &v) { kernel = v.one_of(kernels()); }},
       {"plane", "strain/stress",
        [this](TMSPHValues &v) {
          plane = v.one_of<Plane>({{"strain", Plane::STRAIN}, {"stress", Plane::STRESS}});
        }},
       {"law", "name", [this](TMSPHValues &v) { law = v.one_of(alternatives<ElasticLaw>()); }},
       {"hourglass", "zeta",
        [this](TMSPHValues &v) {
          hourglass = v.number(TMSPHRule::not_negative, "must not be negative: 0.1 is usual");
        }},
       {"viscosity", "alpha1 alpha2",
        [this](TMSPHValues &v) {
          alpha1 = v.number();
          alpha2 = v.number();
          if (alpha1 < 0.0 || alpha2 < 0.0)
            v.reject(fmt::format("{} {}", v.rest()[-2], v.rest()[-1]),
                     "must not be negative: 1 2 is usual");
        }},
       {"thermal", "bond/strain",
        [this](TMSPHValues &v) {
          thermal = v.one_of<ThermalStrain>(
              {{"bond", ThermalStrain::BOND}, {"strain", ThermalStrain::CONSTITUTIVE}});
        }},
       {"dilatation", "auto/plain/averaged",
        [this](TMSPHValues &v) {
          dilatation = v.one_of<Dilatation>({{"auto", Dilatation::AUTO},
                                             {"plain", Dilatation::PLAIN},
                                             {"averaged", Dilatation::AVERAGED}});
        }}})
      .read_all(arg + 1, arg + narg);
}

/* ---------------------------------------------------------------------- */

void TMSPHSettings::write_restart(FILE *fp) const
{
  const double list[8] = {
      horizon, (double) kernel.index(), (double) plane, (double) thermal, hourglass, alpha1,
      alpha2,  (double) dilatation};
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
