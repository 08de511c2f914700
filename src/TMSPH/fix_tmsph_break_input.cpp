/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words and restart of the fixes that break bonds, and what they tell of them.
------------------------------------------------------------------------- */

#include "fix_tmsph_break.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "tmsph_report.h"
#include "tmsph_restart.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

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
    Fix(lmp, narg, arg), pair(nullptr), bonds(nullptr), list(nullptr), ghosts(lmp, this),
    debris(lmp), criterion(std::move(law)), rocks(atom->ntypes + 1), all_principals(false),
    one_rock(true), armed(false), version(-1), broken{0, 0}, broken_now(0), fresh(true),
    relative(0.0), began(false), looking(false)
{
  scalar_flag = vector_flag = local_flag = 1;
  size_vector = 11;
  global_freq = 1;
  extscalar = extvector = 0;
  size_local_rows = 0;
  size_local_cols = 13;
  local_freq = 1;
  restart_global = 1;
  comm_forward = 1;
  parse(narg, arg);
}

/* ----------------------------------------------------------------------
   words of the criterion, and those that all of them share
------------------------------------------------------------------------- */

void FixTMSPHBreak::parse(int narg, char **arg)
{
  if (igroup != 0)
    error->all(FLERR, "Fix {} works on all particles: use group all and give each type its rock",
               style);
  const auto &constants = criterion->words();
  std::vector<std::vector<double>> values(atom->ntypes + 1);
  for (auto &one : values)
    for (const auto &constant : constants) one.push_back(constant.standard);
  std::vector<TMSPHWord> words;
  for (size_t k = 0; k < constants.size(); k++)
    words.push_back({constants[k].name, "I value", [&values, &constants, k](TMSPHValues &v) {
                       int lo, hi;
                       v.types(lo, hi);
                       const double value =
                           v.number(constants[k].allows,
                                    fmt::format("is out of range: {}", constants[k].rule));
                       for (int type = lo; type <= hi; type++) values[type][k] = value;
                     }});
  const auto opens_with = [this](double Rock::*given, double Rock::*other) {
    return [this, given, other](TMSPHValues &v) {
      int lo, hi;
      v.types(lo, hi);
      const double value = v.number(TMSPHRule::positive, "is out of range: it must be positive");
      for (int type = lo; type <= hi; type++) {
        rocks[type].*given = value;
        rocks[type].*other = 0.0;
      }
    };
  };
  words.push_back({"energy", "I value", opens_with(&Rock::energy, &Rock::toughness)});
  words.push_back({"toughness", "I value", opens_with(&Rock::toughness, &Rock::energy)});
  words.push_back({"weibull", "I modulus seed", [this](TMSPHValues &v) { read_weibull(v); }});
  words.push_back({"principal", "inplane/all", [this](TMSPHValues &v) {
                     all_principals = v.one_of<bool>({{"inplane", false}, {"all", true}});
                   }});
  TMSPHWords(lmp, std::string("fix ") + style, std::move(words)).read_all(arg + 3, arg + narg);

  for (int type = 1; type <= atom->ntypes; type++) {
    for (size_t k = 0; k < constants.size(); k++)
      if (values[type][k] == TMSPH::REQUIRED)
        error->all(FLERR, "Fix {} lacks the {} of type {}: add '{} {} value'", style,
                   constants[k].name, type, constants[k].name, type);
    rocks[type].strength = values[type][0];
    criterion->add(values[type]);
    one_rock = one_rock && criterion->alike(type, 1);
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::read_weibull(TMSPHValues &values)
{
  int lo, hi;
  values.types(lo, hi);
  // (-ln U)^(1/omega) and its square must be numbers for all U of double precision
  const double modulus =
      values.number([](double value) { return value >= 0.1; },
                    "is out of range: the Weibull modulus must be at least 0.1; 10 is usual");
  const int seed = values.integer();
  if (seed <= 0) values.reject(fmt::format("seed {}", seed), "must be a positive integer");
  for (int type = lo; type <= hi; type++) {
    rocks[type].modulus = modulus;
    rocks[type].seed = seed;
  }
}

/* ----------------------------------------------------------------------
   One row for each type, again when it has changed. The toughness is that of the crack energy G,
   sqrt(E G).
------------------------------------------------------------------------- */

void FixTMSPHBreak::tell()
{
  using namespace TMSPH;
  check_openings();
  const UnitNames unit(update->unit_style);
  const std::string strength = criterion->strength_name();
  std::vector<std::string> columns = {
      "type", heading(strength, unit.pressure), heading("tensile", unit.pressure), strength + "/E",
      heading("crack_energy", unit.area_energy), heading("toughness", unit.toughness)};
  if (opening) columns.emplace_back("spacing/length");
  TextTable table(columns);
  for (int type = 1; type <= atom->ntypes; type++) {
    const double young = pair->material(type).young, tensile = tensile_strength(type);
    const double spacing = pair->spacing_of(type);
    const bool opens = opens_type(type);
    const double energy =
        opens ? crack_energy(type) : CRACK_ENERGY * tensile * tensile * spacing / young;
    std::vector<std::string> row = {
        std::to_string(type), digits(rocks[type].strength), digits(tensile),
        digits(rocks[type].strength / young), energy > 0.0 ? digits(energy) : "-",
        energy > 0.0 ? digits(std::sqrt((opens ? crack_modulus(type) : young) * energy)) : "-"};
    if (opening) row.push_back(opens ? digits(spacing / characteristic_length(type)) : "-");
    table.add(row);
  }
  const std::string rows = table.text();
  if (!pair->news(rows)) return;
  if (comm->me == 0)
    utils::logmesg(lmp,
                   "TMSPH breaking: {}, a crack takes {} tensile^2 spacing/E, its "
                   "characteristic length is {} spacings{}\n{}",
                   criterion->title(), CRACK_ENERGY, CRACK_ENERGY,
                   opening ? "; where bonds open, the given energy" : "", rows);
  for (int type = 1; type <= atom->ntypes; type++) {
    const double ratio = rocks[type].strength / pair->material(type).young;
    if (!pair->plausible(type) || (ratio >= WEAKEST && ratio <= STRONGEST)) continue;
    pair->warn_once(fmt::format(
        "Strength {} of type {} is {:.3g} of its Young's modulus, {}, in rock it is 1e-3 to 1e-2: "
        "give both in {}{}",
        rocks[type].strength, type, ratio, pair->material(type).young,
        unit.pressure.empty() ? "the same unit" : unit.pressure,
        ratio > STRONGEST ? "; a type with a 25th of the modulus does not break either" : ""));
    return;
  }
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
      "'minimize' before the run", 100.0 * part,
      all[1] > 0.0 ? "in pair_coeff give the 'reference' temperature without stress, or " : ""));
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::write_restart(FILE *fp)
{
  const double tension = total(0), shear = total(1);
  std::vector<double> list = {RESTART_FORMAT, tension, shear, (double) comm->nprocs};
  TMSPHOpenings::Balance all{}, mine = opening ? opening->finished() : all;
  MPI_Allreduce(mine.data(), all.data(), all.size(), MPI_DOUBLE, MPI_SUM, world);
  list.insert(list.end(), all.begin(), all.end());
  gather_events(list);
  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ----------------------------------------------------------------------
   On processor 0: how many events each processor has, and the events. LAMMPS counts the bytes of a
   record in an int; beyond that, at some 20 million events, the table starts anew.
------------------------------------------------------------------------- */

void FixTMSPHBreak::gather_events(std::vector<double> &list)
{
  const int nprocs = comm->nprocs, width = size_local_cols;
  const int mine = width * events.size();
  std::vector<int> sizes(nprocs), starts(nprocs, 0);
  MPI_Allgather(&mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  const bigint all = std::accumulate(sizes.begin(), sizes.end(), bigint(0));
  const bool fits = (list.size() + nprocs + all) * sizeof(double) < MAXSMALLINT;
  for (const int size : sizes) list.push_back(fits ? size / width : 0);
  if (!fits) return;
  std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
  const size_t head = list.size();
  list.resize(head + (comm->me ? 0 : all));
  MPI_Gatherv(events.data(), mine, MPI_DOUBLE, list.data() + head, sizes.data(), starts.data(),
              MPI_DOUBLE, 0, world);
}

/* ----------------------------------------------------------------------
   events return to the processor that they came from, so that the table keeps its order
------------------------------------------------------------------------- */

void FixTMSPHBreak::restart(char *buf)
{
  double head[4];
  memcpy(head, buf, sizeof(double));
  check_restart_format(error, fmt::format("fix {}", style), head[0], RESTART_FORMAT);
  memcpy(head, buf, sizeof(head));
  for (int mode = 0; mode < 2; mode++)
    broken[mode] = comm->me == 0 ? (bigint) head[1 + mode] : 0;
  buf += sizeof(head);
  memcpy(before.data(), buf, sizeof(before));
  std::vector<double> counts((size_t) head[3]);
  memcpy(counts.data(), buf += sizeof(before), counts.size() * sizeof(double));
  buf += counts.size() * sizeof(double);
  for (size_t proc = 0; proc < counts.size(); proc++) {
    const size_t known = events.size(), more = (size_t) counts[proc];
    if ((int) proc % comm->nprocs == comm->me) {
      events.resize(known + more);
      if (more) memcpy(&events[known], buf, more * sizeof(Event));
    }
    buf += more * sizeof(Event);
  }
  list_events();
  fresh = false;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::memory_usage()
{
  return strengths.capacity() * sizeof(double) + suspect.capacity() + border.capacity() +
      tested.capacity() + events.capacity() * (sizeof(Event) + sizeof(double *)) +
      due_bonds.capacity() * sizeof(Due) +
      damaged.capacity() + watched.capacity() + (opening ? opening->bytes() : 0.0);
}
