/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Report and restart of the fixes that break bonds.
------------------------------------------------------------------------- */

#include "fix_tmsph_break.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "tmsph_report.h"
#include "tmsph_restart.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 4.0;

// A crack through bonds that break takes 15 sigma^2 dx/(2 E) per area, with sigma the tensile
// strength and dx the spacing (examples/quench/in.toughness, doc/report/quench.md)

static constexpr double CRACK_ENERGY = 15.0 / 2.0;

// strength over Young's modulus: 1/1000 to 1/100 in rock (Deere, Miller, AFWL-TR-65-116, 1966),
// 1/10 if there were no flaws

static constexpr double STRONGEST = 1.0 / 20.0, WEAKEST = 1.0e-6;

// of the bonds, on the first step

static constexpr double HOT_START = 0.01;

/* ---------------------------------------------------------------------- */

FixTMSPHBreak::FixTMSPHBreak(LAMMPS *lmp, int narg, char **arg,
                             std::unique_ptr<TMSPH::Criterion> law) :
    Fix(lmp, narg, arg),
    pair(nullptr), bonds(nullptr), list(nullptr), ghosts(lmp, this), debris(lmp),
    rock(lmp, std::move(law)), opening(lmp, rock), events(lmp), armed(false), fresh(true),
    relative(0.0)
{
  scalar_flag = vector_flag = local_flag = 1;
  size_vector = 11;
  global_freq = 1;
  extscalar = extvector = 0;
  size_local_rows = 0;
  size_local_cols = TMSPHBreakEvents::COLUMNS;
  local_freq = 1;
  restart_global = 1;
  comm_forward = 1;
  if (igroup != 0)
    error->all(FLERR, "Fix {} works on all particles: use group all and give each type its rock",
               style);
  rock.read(style, arg + 3, arg + narg);
}

/* ----------------------------------------------------------------------
   One row for each type, again when it has changed. The toughness is that of the crack energy G,
   sqrt(E G).
------------------------------------------------------------------------- */

void FixTMSPHBreak::tell()
{
  using namespace TMSPH;
  opening.check(style);
  const UnitNames unit(update->unit_style);
  const std::string strength = rock.criterion().strength_name();
  std::vector<std::string> columns = {"type",
                                      heading(strength, unit.pressure),
                                      heading("tensile", unit.pressure),
                                      strength + "/E",
                                      heading("crack_energy", unit.area_energy),
                                      heading("toughness", unit.toughness)};
  if (openings()) columns.emplace_back("spacing/length");
  TextTable table(columns);
  for (int type = 1; type <= atom->ntypes; type++) table.add(described(type, type));
  for (int type = 1; type <= atom->ntypes; type++)
    for (int other = type + 1; other <= atom->ntypes; other++)
      if (rock.of_pair(type, other)) table.add(described(type, other));
  const std::string rows = table.text();
  if (!pair->news(rows)) return;
  if (comm->me == 0)
    utils::logmesg(lmp,
                   "TMSPH breaking: {}, a crack takes {} tensile^2 spacing/E, its "
                   "characteristic length is {} spacings{}\n{}",
                   rock.criterion().title(), CRACK_ENERGY, CRACK_ENERGY,
                   openings() ? "; where bonds open, the given energy" : "", rows);
  for (int type = 1; type <= atom->ntypes; type++) {
    const double ratio = rock.of(type).strength / pair->material(type).young;
    if (!pair->plausible(type) || (ratio >= WEAKEST && ratio <= STRONGEST)) continue;
    pair->warn_once(fmt::format(
        "Strength {} of type {} is {:.3g} of its Young's modulus, {}, in rock it is 1e-3 to 1e-2: "
        "give both in {}{}",
        rock.of(type).strength, type, ratio, pair->material(type).young,
        unit.pressure.empty() ? "the same unit" : unit.pressure,
        ratio > STRONGEST ? "; a type with a 25th of the modulus does not break either" : ""));
    return;
  }
}

/* ----------------------------------------------------------------------
   a row of the table: of a type, or of the bonds between two
------------------------------------------------------------------------- */

std::vector<std::string> FixTMSPHBreak::described(int type, int other)
{
  using TMSPH::digits;
  const bool one = type == other, opens = rock.opens(type, other);
  const double young = 0.5 * (pair->material(type).young + pair->material(other).young);
  const double tensile = rock.tensile_strength(type, other);
  const double strength =
      0.5 * rock.strength_factor(type, other) * (rock.of(type).strength + rock.of(other).strength);
  const double spacing = std::max(pair->spacing_of(type), pair->spacing_of(other));
  const double energy = opens ? rock.crack_energy(type, other)
                              : CRACK_ENERGY * tensile * tensile * spacing / young;
  const double modulus = opens ? rock.crack_modulus(type, other) : young;
  std::vector<std::string> row = {one ? std::to_string(type) : fmt::format("{}-{}", type, other),
                                  digits(strength),
                                  digits(tensile),
                                  digits(strength / young),
                                  energy > 0.0 ? digits(energy) : "-",
                                  energy > 0.0 ? digits(std::sqrt(modulus * energy)) : "-"};
  if (openings())
    row.push_back(opens ? digits(spacing / rock.characteristic_length(type, other)) : "-");
  return row;
}

/* ----------------------------------------------------------------------
   on the first step of all, before the bonds go that are due
------------------------------------------------------------------------- */

void FixTMSPHBreak::warn_of_hot_start()
{
  double mine[2] = {0.5 * due_bonds.size(), 0.0}, all[2];
  for (int i = 0; i < atom->nlocal; i++)
    mine[1] = std::max(mine[1], std::fabs(pair->thermal_strain(i)));
  MPI_Allreduce(&mine[0], &all[0], 1, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(&mine[1], &all[1], 1, MPI_DOUBLE, MPI_MAX, world);
  const double part = all[0] / std::max<bigint>(bonds->count_bonds(FixTMSPHBond::INTACT), 1);
  if (part <= HOT_START || pair->warned()) return;    // that may be the reason
  pair->warn_once(fmt::format(
      "{:.0f} % of the bonds break on the first step, which is not near equilibrium: {}give "
      "'minimize' before the run",
      100.0 * part,
      all[1] > 0.0 ? "in pair_coeff give the 'reference' temperature without stress, or " : ""));
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::write_restart(FILE *fp)
{
  const double tension = events.total(TMSPHBreakEvents::TENSION),
               shear = events.total(TMSPHBreakEvents::SHEAR);
  std::vector<double> list = {RESTART_FORMAT, tension, shear, (double) comm->nprocs};
  TMSPHOpeningBalance::Figures all{}, mine = opening.finished();
  MPI_Allreduce(mine.data(), all.data(), all.size(), MPI_DOUBLE, MPI_SUM, world);
  list.insert(list.end(), all.begin(), all.end());
  events.gather(list);
  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::restart(char *buf)
{
  double head[4];
  memcpy(head, buf, sizeof(double));
  check_restart_format(error, fmt::format("fix {}", style), head[0], RESTART_FORMAT);
  memcpy(head, buf, sizeof(head));
  TMSPHOpeningBalance::Figures sums;
  memcpy(sums.data(), buf += sizeof(head), sizeof(sums));
  opening.resume(sums);
  events.restart(head + 1, (int) head[3], buf + sizeof(sums));
  list_events();
  fresh = false;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::memory_usage()
{
  return rock.bytes() + suspects.bytes() + events.bytes() + opening.bytes() +
      due_bonds.capacity() * sizeof(Due);
}
