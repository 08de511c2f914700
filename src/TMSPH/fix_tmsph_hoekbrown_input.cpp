/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words and restart of fix tmsph/hoekbrown.
------------------------------------------------------------------------- */

#include "fix_tmsph_hoekbrown.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "tmsph_restart.h"
#include "tmsph_types.h"

#include <cstring>

using namespace LAMMPS_NS;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 2.0;

/* ---------------------------------------------------------------------- */

FixTMSPHHoekBrown::FixTMSPHHoekBrown(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), bonds(nullptr), list(nullptr), debris(lmp),
    rocks(atom->ntypes + 1), all_principals(false), one_rock(true), armed(false), version(-1),
    broken{0, 0}, broken_now(0), relative(0.0)
{
  scalar_flag = vector_flag = local_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extscalar = extvector = 0;
  size_local_rows = 0;
  size_local_cols = 13;
  local_freq = 1;
  restart_global = 1;
  comm_forward = 2;
  parse(narg, arg);
}

/* ----------------------------------------------------------------------
   keywords: strength mi gsi disturbance TYPES value, weibull TYPES omega seed,
   principal inplane|all
------------------------------------------------------------------------- */

void FixTMSPHHoekBrown::parse(int narg, char **arg)
{
  if (igroup != 0)
    error->all(FLERR, "Fix tmsph/hoekbrown works on all particles: use group all and give each "
                      "type its rock");
  for (int iarg = 3; iarg < narg;) {
    const std::string word = arg[iarg];
    if (word == "principal") {
      if (iarg + 1 >= narg) utils::missing_cmd_args(FLERR, "fix tmsph/hoekbrown principal", error);
      if (strcmp(arg[iarg + 1], "all") != 0 && strcmp(arg[iarg + 1], "inplane") != 0)
        error->all(FLERR, "Unknown value '{}' of fix tmsph/hoekbrown principal: use inplane or all",
                   arg[iarg + 1]);
      all_principals = strcmp(arg[iarg + 1], "all") == 0;
      iarg += 2;
      continue;
    }
    const bool weibull = word == "weibull";
    if (!weibull && word != "strength" && word != "mi" && word != "gsi" && word != "disturbance")
      error->all(FLERR,
                 "Unknown keyword '{}' of fix tmsph/hoekbrown: use strength, mi, gsi, disturbance, "
                 "weibull or principal",
                 word);
    const int words = weibull ? 4 : 3;
    if (iarg + words > narg)
      utils::missing_cmd_args(FLERR, "fix tmsph/hoekbrown " + word, error);
    int lo, hi;
    TMSPH::read_types(lmp, "Fix tmsph/hoekbrown " + word,
                      word + (weibull ? " * modulus seed" : " * value"), arg[iarg + 1], lo, hi);
    const double value = utils::numeric(FLERR, arg[iarg + 2], false, lmp);
    const auto reject = [&](const char *rule) {
      error->all(FLERR, "Fix tmsph/hoekbrown {} {} is out of range: {}", word, arg[iarg + 2], rule);
    };
    if (word == "strength" && value <= 0.0)
      reject("the uniaxial compressive strength must be positive");
    if (word == "mi" && value <= 0.0) reject("it must be positive; 4 to 33 is usual");
    if (word == "gsi" && (value <= 0.0 || value > 100.0))
      reject("it must be above 0 and at most 100 (intact rock)");
    if (word == "disturbance" && (value < 0.0 || value > 1.0)) reject("it must lie in 0 to 1");
    // (-ln U)^(1/omega) and its square must be numbers for all U of double precision
    if (weibull && value < 0.1) reject("the Weibull modulus must be at least 0.1; 10 is usual");
    int seed = 0;
    if (weibull) {
      seed = utils::inumeric(FLERR, arg[iarg + 3], false, lmp);
      if (seed <= 0)
        error->all(FLERR, "Fix tmsph/hoekbrown weibull seed {} must be a positive integer",
                   arg[iarg + 3]);
    }
    for (int type = lo; type <= hi; type++) {
      Rock &rock = rocks[type];
      if (word == "strength") rock.strength = value;
      if (word == "mi") rock.mi = value;
      if (word == "gsi") rock.gsi = value;
      if (word == "disturbance") rock.disturbance = value;
      if (weibull) {
        rock.modulus = value;
        rock.seed = seed;
      }
    }
    iarg += words;
  }
  for (int type = 1; type <= atom->ntypes; type++) {
    Rock &rock = rocks[type];
    for (const auto &[name, value] : {std::make_pair("strength", rock.strength),
                                      std::make_pair("mi", rock.mi)})
      if (value == 0.0)
        error->all(FLERR, "Fix tmsph/hoekbrown lacks the {} of type {}: add '{} {} value'", name,
                   type, name, type);
    rock.constants = TMSPH::hoek_brown(rock.mi, rock.gsi, rock.disturbance);
    one_rock = one_rock && rock.constants == rocks[1].constants;
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::write_restart(FILE *fp)
{
  const double tension = total(0), shear = total(1);
  if (comm->me) return;
  const double counts[3] = {RESTART_FORMAT, tension, shear};
  const int size = sizeof(counts);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(counts, sizeof(double), 3, fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::restart(char *buf)
{
  double counts[3];
  memcpy(counts, buf, sizeof(double));
  check_restart_format(error, "fix tmsph/hoekbrown", counts[0], RESTART_FORMAT);
  memcpy(counts, buf, sizeof(counts));
  for (int mode = 0; mode < 2; mode++)
    broken[mode] = comm->me == 0 ? (bigint) counts[1 + mode] : 0;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::memory_usage()
{
  return strengths.capacity() * sizeof(double) + beyond.capacity() +
      events.capacity() * (sizeof(Event) + sizeof(double *)) + due_bonds.capacity() * sizeof(Due);
}
