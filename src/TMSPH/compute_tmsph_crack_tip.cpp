/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "compute_tmsph_crack_tip.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_store_global.h"
#include "fix_tmsph_bond.h"
#include "fix_tmsph_break.h"
#include "force.h"
#include "group.h"
#include "math_extra.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

using namespace LAMMPS_NS;

static constexpr int N = 6;        // position, distance, speed, part
static constexpr int WORDS = 5;    // numbers that stand for the words of the input
static constexpr double GRID = 1 << 20;
static constexpr int MOST_EVALUATIONS = 100000;
static constexpr double ROUNDED = 1.01;    // no bond is longer than the horizon but for this

/* ---------------------------------------------------------------------- */

ComputeTMSPHCrackTip::ComputeTMSPHCrackTip(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg)
{
  if (!domain->box_exist)    // it may still get another dimension
    error->all(FLERR, "Compute tmsph/crack/tip before the simulation box is defined");
  TMSPHValues values(lmp, "compute tmsph/crack/tip", "direction", arg + 3, arg + narg);
  read_direction(values);
  TMSPHWords(lmp, "compute tmsph/crack/tip",
             {{"open", "part",
               [this](TMSPHValues &v) {
                 least_part = v.number([](double part) { return part > 0.0 && part <= 1.0; },
                                       "is no part of full opening: it must be above 0 and at "
                                       "most 1, for bonds without traction");
               }},
              {"cut", "yes/no", [this](TMSPHValues &v) { with_cuts = v.logical(); }},
              {"window", "n",
               [this](TMSPHValues &v) {
                 window = v.integer();
                 if (window < 2 || window > MOST_EVALUATIONS)
                   v.reject(std::to_string(window),
                            fmt::format("is too {}: a speed takes 2 to {} evaluations",
                                        window < 2 ? "small" : "large", MOST_EVALUATIONS));
               }}})
      .read_all(values.rest(), arg + narg);
  vector_flag = 1;
  size_vector = N;
  extvector = 0;
  vector = new double[N];
  keep_history();
}

/* ---------------------------------------------------------------------- */

ComputeTMSPHCrackTip::~ComputeTMSPHCrackTip()
{
  if (modify->nfix) modify->delete_fix(store_id);
  delete[] vector;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHCrackTip::read_direction(TMSPHValues &values)
{
  using Vector = std::array<double, 3>;
  const bool numbers = values.number_follows();
  Vector given;
  if (numbers)
    for (double &component : given) component = values.number();
  else
    given = values.one_of<Vector>({{"x", {1, 0, 0}},
                                   {"-x", {-1, 0, 0}},
                                   {"y", {0, 1, 0}},
                                   {"-y", {0, -1, 0}},
                                   {"z", {0, 0, 1}},
                                   {"-z", {0, 0, -1}}});
  const double length = std::hypot(given[0], given[1], given[2]);
  const std::string text = fmt::format("direction {} {} {}", given[0], given[1], given[2]);
  if (!TMSPHRule::positive(length)) values.reject(text, "must have a length");
  if (domain->dimension == 2 && given[2] != 0.0)
    values.reject(text, "leaves the plane: in 2-D its z must be 0");
  for (int c = 0; c < 3; c++) direction[c] = given[c] / length;
}

/* ----------------------------------------------------------------------
   What the speed is found from, in a fix of LAMMPS that restart files keep: first the words, by
   which a history of other ones is known, then how many evaluations, their times and distances.
------------------------------------------------------------------------- */

void ComputeTMSPHCrackTip::keep_history()
{
  const double words[WORDS] = {direction[0], direction[1], direction[2], least_part,
                               with_cuts ? 1.0 : 0.0};
  const int size = WORDS + 1 + 2 * window;
  store_id = id + std::string("_COMPUTE_STORE");
  store = dynamic_cast<FixStoreGlobal *>(modify->add_fix(
      fmt::format("{} {} STORE/GLOBAL {} 1", store_id, group->names[igroup], size)));
  if (store->nrow == size && std::equal(words, words + WORDS, store->vstore)) return;
  if (store->nrow != size) store->reset_global(size, 1);
  std::fill_n(store->vstore, size, 0.0);
  std::copy_n(words, WORDS, store->vstore);
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHCrackTip::init()
{
  if (!dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0)))
    error->all(FLERR, "Compute tmsph/crack/tip needs pair style tmsph");
}

/* ----------------------------------------------------------------------
   a bond is seen from both ends, whose middles differ by a period or by rounding
------------------------------------------------------------------------- */

bool ComputeTMSPHCrackTip::Tip::farther_than(const Tip &other) const
{
  if ((part > 0.0) != (other.part > 0.0)) return part > 0.0;
  return std::tie(other.distance, own_id, partner_id) <
      std::tie(distance, other.own_id, other.partner_id);
}

/* ---------------------------------------------------------------------- */

double ComputeTMSPHCrackTip::part_of(TMSPHOpenings *openings, int i, int k) const
{
  const auto state = bonds->bond_state(i, k);
  if (state == FixTMSPHBond::INTACT)
    return openings ? std::min(1.0, openings->part_open(i, k)) : 0.0;
  return state == FixTMSPHBond::BROKEN || (with_cuts && state == FixTMSPHBond::CUT) ? 1.0 : 0.0;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHCrackTip::take(Tip &best, int i, tagint partner, const double *partner_x0,
                                double part) const
{
  Tip tip;
  double X[3];
  bonds->reference_vector(atom->x0[i], partner_x0, X);
  for (int c = 0; c < 3; c++) tip.X[c] = atom->x0[i][c] + 0.5 * X[c];
  tip.distance = MathExtra::dot3(direction, tip.X);
  tip.own_id = (double) atom->tag[i];
  tip.partner_id = (double) partner;
  tip.part = part;
  if (tip.farther_than(best)) best = tip;
}

/* ----------------------------------------------------------------------
   returns those whose other end this processor does not know
------------------------------------------------------------------------- */

std::vector<ComputeTMSPHCrackTip::OutOfReach> ComputeTMSPHCrackTip::find_at_hand(Tip &best) const
{
  const auto breaking = FixTMSPHBreak::find(lmp);
  TMSPHOpenings *const openings = breaking ? breaking->openings() : nullptr;
  std::vector<OutOfReach> unknown;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (int k = 0; k < bonds->count(i); k++) {
      const double part = part_of(openings, i, k);
      if (part < least_part) continue;
      const int j = bonds->partner_index(i, k);
      if (j == i)
        unknown.push_back({i, bonds->partner_tag(i, k)});
      else if (atom->mask[j] & groupbit)
        take(best, i, bonds->partner_tag(i, k), atom->x0[j], part);
    }
  }
  return unknown;
}

/* ----------------------------------------------------------------------
   Reference positions of particles with these ids, which all processors give, and a 1 for those of
   the group.
------------------------------------------------------------------------- */

std::vector<std::array<double, 4>>
ComputeTMSPHCrackTip::places_of(const std::vector<tagint> &ids) const
{
  std::vector<std::array<double, 4>> mine(ids.size(), {0.0, 0.0, 0.0, 0.0}), all(ids.size());
  for (size_t n = 0; n < ids.size(); n++) {
    const int j = atom->map(ids[n]);
    if (j < 0 || j >= atom->nlocal || !(atom->mask[j] & groupbit)) continue;
    std::copy_n(atom->x0[j], 3, mine[n].begin());
    mine[n][3] = 1.0;
  }
  MPI_Allreduce(mine.data(), all.data(), 4 * ids.size(), MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   Which ends are at hand depends on the number of processors; what is found must not. Asked for are
   those alone that may be farther than the best of all.
------------------------------------------------------------------------- */

void ComputeTMSPHCrackTip::find_out_of_reach(Tip &best,
                                             const std::vector<OutOfReach> &unknown) const
{
  std::vector<OutOfReach> asked;
  for (const OutOfReach &bond : unknown)
    if (best.part == 0.0 ||
        MathExtra::dot3(direction, atom->x0[bond.i]) + 0.5 * ROUNDED * bonds->reach() >
            best.distance)
      asked.push_back(bond);
  std::vector<int> counts(comm->nprocs), starts(comm->nprocs, 0);
  const int n = asked.size();
  MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<tagint> mine, ids(starts.back() + counts.back());
  if (ids.empty()) return;
  for (const OutOfReach &bond : asked) mine.push_back(bond.partner);
  MPI_Allgatherv(mine.data(), n, MPI_LMP_TAGINT, ids.data(), counts.data(), starts.data(),
                 MPI_LMP_TAGINT, world);
  const auto places = places_of(ids);
  for (int k = 0; k < n; k++) {
    const auto &place = places[starts[comm->me] + k];
    if (place[3] > 0.0) take(best, asked[k].i, asked[k].partner, place.data(), 1.0);
  }
}

/* ---------------------------------------------------------------------- */

ComputeTMSPHCrackTip::Tip ComputeTMSPHCrackTip::farthest_of_all(const Tip &mine) const
{
  static_assert(sizeof(Tip) == 7 * sizeof(double));
  std::vector<Tip> all(comm->nprocs);
  MPI_Allgather(&mine, 7, MPI_DOUBLE, all.data(), 7, MPI_DOUBLE, world);
  return *std::max_element(all.begin(), all.end(),
                           [](const Tip &a, const Tip &b) { return b.farther_than(a); });
}

/* ----------------------------------------------------------------------
   The slope of the line of least squares through the last distances. A tip goes from bond to bond,
   by stairs: all distances count here, in a difference only two.
------------------------------------------------------------------------- */

double ComputeTMSPHCrackTip::find_speed(const Tip &tip)
{
  double &stored = store->vstore[WORDS];
  double *const time = &stored + 1, *const distance = time + window;
  // in parts of a step: the same bits however runs and restart files divide the time
  const double sum = update->atime + (update->ntimestep - update->atimestep) * update->dt;
  const double now = std::round(sum / update->dt * GRID) / GRID * update->dt;
  const double rounding = 1e-3 * update->dt;    // between two runs, of the time
  int n = (int) stored;
  if (tip.part == 0.0 || (n && time[n - 1] > now + rounding)) n = 0;
  if (tip.part > 0.0) {
    if (n && time[n - 1] > now - rounding) n--;
    if (n == window) {
      std::copy(time + 1, time + n, time);
      std::copy(distance + 1, distance + n, distance);
      n--;
    }
    time[n] = now;
    distance[n] = tip.distance;
    n++;
  }
  stored = n;
  if (n < 2) return 0.0;
  const double mean_time = std::accumulate(time, time + n, 0.0) / n;
  const double mean_distance = std::accumulate(distance, distance + n, 0.0) / n;
  double both = 0.0, square = 0.0;
  for (int k = 0; k < n; k++) {
    both += (time[k] - mean_time) * (distance[k] - mean_distance);
    square += (time[k] - mean_time) * (time[k] - mean_time);
  }
  return both / square;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHCrackTip::compute_vector()
{
  invoked_vector = update->ntimestep;
  bonds = PairTMSPH::laid_out(lmp, "Compute tmsph/crack/tip")->bonds();
  Tip tip;
  const auto unknown = find_at_hand(tip);
  tip = farthest_of_all(tip);
  find_out_of_reach(tip, unknown);
  tip = farthest_of_all(tip);
  std::copy_n(tip.X, 3, vector);
  vector[3] = tip.distance;
  vector[4] = find_speed(tip);
  vector[5] = tip.part;
}
