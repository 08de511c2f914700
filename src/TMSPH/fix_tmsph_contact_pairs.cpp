/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which pairs are in contact, and the surfaces between them.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace LAMMPS_NS;
using namespace TMSPH;

// pairs that are shorter than this many particle spacings mark the surface between them

static constexpr double SHORT = 1.6;

// bodies whose nearest particles are farther apart than this many spacings do not touch

static constexpr double APART = 1.3;

// moment of inertia, in squared spacings, that marks need to overrule the direction of a bond

static constexpr double SCATTER = 0.1;

/* ----------------------------------------------------------------------
   the pairs are listed again after an exchange of particles and when bonds
   have gone; the latter may happen in the midst of a force evaluation
------------------------------------------------------------------------- */

void FixTMSPHContact::follow(bool after_breaks)
{
  int changed = version != bonds->layout_version();    // the same on all processors
  if (!changed && after_breaks && self && pair->bonds_may_break()) {
    int mine = removals != bonds->removals();
    MPI_Allreduce(&mine, &changed, 1, MPI_INT, MPI_MAX, world);
  }
  if (!changed) return;
  std::vector<Pairing> before;    // their particles are still where they were
  if (version == bonds->layout_version()) before = pairings;
  version = bonds->layout_version();
  removals = bonds->removals();
  if (segments) {
    find_outlines();
    if (!segments->measured) measure();
    face();
  }
  list_pairs();
  if (!any_pairs) return;
  if (domain->dimension == 2)
    fit_pairs<2>();
  else
    fit_pairs<3>();
  find_refits(before);
}

/* ----------------------------------------------------------------------
   pairs of crack faces that had other surfaces before bonds broke
------------------------------------------------------------------------- */

void FixTMSPHContact::find_refits(const std::vector<Pairing> &before)
{
  const auto order = [](const Pairing &a, const Pairing &b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  };
  std::vector<Pairing> sorted(before);
  std::sort(sorted.begin(), sorted.end(), order);
  for (size_t n = 0; n < pairings.size() && !sorted.empty(); n++) {
    const Pairing &p = pairings[n];
    const auto old = std::lower_bound(sorted.begin(), sorted.end(), p, order);
    if (p.meeting != Meeting::FACES || old == sorted.end() || order(p, *old)) continue;
    const ContactPair &was = old->pair, &is = p.pair;
    if (was.distance != is.distance ||
        !std::equal(is.normal_low, is.normal_low + domain->dimension, was.normal_low))
      refits.push_back({(int) n, was});
  }
}

/* ----------------------------------------------------------------------
   particles with pairs, and their ends; what is remembered of pairs that are
   still there is kept
   @return largest room that a particle takes in restarts
------------------------------------------------------------------------- */

int FixTMSPHContact::list_members()
{
  write_back();
  std::unordered_map<tagint, Memory> kept;
  members.clear();
  ends.clear();
  int largest = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const auto found = memories.find(atom->tag[i]);
    Memory before;
    if (found != memories.end()) before = std::move(found->second);
    std::vector<Record> records;
    std::vector<int> where;    // local or ghost partner of each record
    for (int k = 0; k < bonds->count(i); k++) {
      if (!counts(bonds->bond_state(i, k))) continue;
      const tagint partner = bonds->partner_tag(i, k);
      const int j = bonds->partner_index(i, k);
      if (j != i && !(atom->mask[j] & groupbit)) continue;
      const auto old = std::lower_bound(
          before.records.begin(), before.records.end(), partner,
          [](const Record &r, tagint id) { return r.partner < id; });
      const bool known = old != before.records.end() && old->partner == partner;
      records.push_back(known ? *old : Record{partner, {}, false});
      records.back().parted = records.back().parted || j == i;
      where.push_back(j);
    }
    const auto image_of = [&](tagint id) { return domain->closest_image(i, atom->map(id)); };
    const auto left_group = [&](const Met &met) {    // whose own memory ends with that
      const int j = image_of(met.partner);
      return j >= 0 && !(atom->mask[j] & groupbit);
    };
    before.met.erase(std::remove_if(before.met.begin(), before.met.end(), left_group),
                     before.met.end());
    if (records.empty() && before.met.empty() && !(segments && faces(i, before))) continue;
    Memory &memory = kept[atom->tag[i]];
    memory = std::move(before);
    memory.records = std::move(records);

    // ends in the order of the partners' ids

    const int first = ends.size();
    for (size_t n = 0; n < where.size(); n++)
      if (!memory.records[n].parted)
        ends.push_back({where[n], -1, atom->tag[i] < memory.records[n].partner,
                        &memory.records[n], nullptr});
    for (Met &met : memory.met) {
      const int j = image_of(met.partner);
      if (j >= 0) ends.push_back({j, -1, atom->tag[i] < met.partner, nullptr, &met});
    }
    std::sort(ends.begin() + first, ends.end(), [this](const End &a, const End &b) {
      return atom->tag[a.j] < atom->tag[b.j];
    });
    members.push_back({i, first, (int) ends.size(), &memory});
    largest = std::max(largest, exchange_size(memory, true));
  }
  memories.swap(kept);
  return largest;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::list_pairs()
{
  const int largest = list_members();

  // the higher end, if both are local, comes back to the pair of the lower one

  const tagint *tag = atom->tag;
  std::vector<int> member_of(atom->nlocal, -1);
  for (size_t n = 0; n < members.size(); n++) member_of[members[n].i] = n;
  pairings.clear();
  refits.clear();
  const auto add = [&](const Member &m, End &e) {
    const int state = e.met ? -1 : bonds->state_with(m.i, tag[e.j]);
    const Meeting meeting = e.met                  ? Meeting::LATER
        : state == FixTMSPHBond::UNBONDED ? Meeting::BODIES
                                          : Meeting::FACES;
    e.pairing = pairings.size();
    ContactPast *past = e.past();
    pairings.push_back({e.low ? m.i : e.j, e.low ? e.j : m.i, meeting, past, nullptr, *past, {}});
    if (e.met) static_cast<PairGeometry &>(pairings.back().pair) = e.met->geometry;
  };
  for (const Member &m : members)
    for (int n = m.first; n < m.last; n++)
      if (ends[n].low || ends[n].j >= atom->nlocal) add(m, ends[n]);
  for (const Member &m : members)
    for (int n = m.first; n < m.last; n++) {
      if (ends[n].pairing >= 0) continue;
      const Member &other = members[member_of[ends[n].j]];
      const auto end = std::lower_bound(
          ends.begin() + other.first, ends.begin() + other.last, tag[m.i],
          [tag](const End &e, tagint id) { return tag[e.j] < id; });
      ends[n].pairing = end->pairing;
      pairings[end->pairing].copy = ends[n].past();
    }

  // restarts are written with one width for all processors

  int mine[2] = {largest, !pairings.empty()};
  int all[2];
  MPI_Allreduce(mine, all, 2, MPI_INT, MPI_MAX, world);
  maxexchange = std::max(all[0], exchange_size(0, 0, 0, 0));
  any_pairs = all[1];
  if (any_pairs || (segments && segments->any)) find_bearers();
}

/* ----------------------------------------------------------------------
   @param nearest distance of the nearest particles of bodies that are not bonded,
                  in spacings
------------------------------------------------------------------------- */

void FixTMSPHContact::warn_if_apart(double nearest)
{
  if (distance_checked) return;
  distance_checked = true;
  double nearest_of_all;
  MPI_Allreduce(&nearest, &nearest_of_all, 1, MPI_DOUBLE, MPI_MIN, world);
  if (nearest_of_all < APART || nearest_of_all == HUGE_VAL || comm->me) return;
  error->warning(FLERR, "Bodies that are not bonded have their nearest particles {:.3g} spacings "
                        "apart: fix tmsph/contact {} takes their surfaces to touch there, so let "
                        "them touch in the reference positions, or stand farther apart than the "
                        "horizon", nearest_of_all, id);
}

/* ----------------------------------------------------------------------
   tangential coordinates of the reference vector X
------------------------------------------------------------------------- */

template <int D> static void set_origin(const double *X, ContactPair &p)
{
  static constexpr double REST[9] = {};
  double normal[D], tangent[D - 1][D], square = 0.0;
  for (int a = 0; a < D; a++) {
    normal[a] = p.normal_low[a] + p.normal_high[a];
    square += normal[a] * normal[a];
  }
  for (int a = 0; a < D; a++) normal[a] /= std::sqrt(square);
  tangents(normal, REST, p.normal_low, tangent);
  for (int t = 0; t < D - 1; t++) {
    p.origin[t] = 0.0;
    for (int a = 0; a < D; a++) p.origin[t] += tangent[t][a] * X[a];
  }
}

/* ----------------------------------------------------------------------
   The surface between two particles is the plane through the middles of the
   short separated pairs around both. Those of body interfaces and of cracks
   count apart: a crack that runs into an interface has another direction.
------------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::fit_pairs()
{
  constexpr int SIZE = Moments<D>::SIZE;
  const auto kind = [](int state) { return state == FixTMSPHBond::UNBONDED ? 0 : 1; };
  const int nlocal = atom->nlocal;
  width = 2 * SIZE;
  rows.assign((size_t) width * (nlocal + atom->nghost), 0.0);
  const auto row = [this](int i) { return rows.data() + (size_t) width * i; };

  // marks of each particle, about itself

  double nearest = HUGE_VAL;

  for (const Member &m : members) {
    Moments<D> marks[2];
    for (const auto &[k, j, state] : bonds->family(m.i, states())) {
      double X[3], middle[D], R2 = 0.0;
      bonds->reference_vector(m.i, j, X);
      for (int a = 0; a < D; a++) {
        R2 += X[a] * X[a];
        middle[a] = 0.5 * X[a];
      }
      const double size = 0.5 * (bonds->spacing(m.i) + bonds->spacing(j)), reach = SHORT * size;
      if (R2 < reach * reach) marks[kind(state)].add_point(middle);
      if (kind(state) == 0) nearest = std::min(nearest, std::sqrt(R2) / size);
    }
    std::copy_n(marks[0].m, SIZE, row(m.i));
    std::copy_n(marks[1].m, SIZE, row(m.i) + SIZE);
  }
  send(0, width);

  warn_if_apart(nearest);

  // those around each particle: its own and its family's, in the order of ids; and once more

  std::vector<double> around(members.size() * width);
  for (int round = 0; round < 2; round++) {
    for (size_t n = 0; n < members.size(); n++) {
      const int i = members[n].i;
      Moments<D> sum[2];
      const auto add = [&](int j, const double *X) {
        sum[0].add(row(j), X);
        sum[1].add(row(j) + SIZE, X);
      };
      const double here[3] = {0.0, 0.0, 0.0};
      add(i, here);
      for (const auto &bond : bonds->family(i, FixTMSPHBond::ALL)) {
        double X[3];
        bonds->reference_vector(i, bond.j, X);
        add(bond.j, X);
      }
      std::copy_n(sum[0].m, SIZE, around.data() + n * width);
      std::copy_n(sum[1].m, SIZE, around.data() + n * width + SIZE);
    }
    for (size_t n = 0; n < members.size(); n++)
      std::copy_n(around.data() + n * width, width, row(members[n].i));
    send(0, width);
  }

  for (Pairing &pairing : pairings) {
    set_stiffness(pairing, bonds->interior_kappa(), SHEAR_CLOSURE<D> / CLOSURE<D>, CLOSURE<D>);
    if (pairing.meeting == Meeting::LATER) continue;
    const int low = pairing.low, high = pairing.high, which = pairing.meeting == Meeting::FACES ? SIZE : 0;
    double X[3], direction[D], R2 = 0.0;
    bonds->reference_vector(low, high, X);
    if (pairing.meeting == Meeting::BODIES && take_given_surfaces<D>(pairing, X, pairing.pair)) {
      set_origin<D>(X, pairing.pair);
      continue;
    }
    for (int a = 0; a < D; a++) R2 += X[a] * X[a];
    for (int a = 0; a < D; a++) direction[a] = X[a] / std::sqrt(R2);
    Moments<D> marks;
    std::copy_n(row(low) + which, SIZE, marks.m);
    marks.add(row(high) + which, X);
    const double size = 0.5 * (bonds->spacing(low) + bonds->spacing(high));
    double normal[D], centre[D], depth = 0.0;
    fit_plane<D>(marks, direction, SCATTER * size * size, normal, centre);

    ContactPair &p = pairing.pair;
    p.distance = 0.0;
    for (int a = 0; a < D; a++) {
      p.normal_low[a] = p.normal_high[a] = normal[a];
      p.distance += normal[a] * X[a];
      depth += normal[a] * centre[a];
    }
    p.share = marks.m[0] > 0.0 && p.distance > 0.0
        ? std::min(1.0, std::max(0.0, depth / p.distance))
        : 0.5;
    set_origin<D>(X, p);
  }
}

/* ----------------------------------------------------------------------
   @param ratio   of the constants for shear and for closure
------------------------------------------------------------------------- */

void FixTMSPHContact::set_stiffness(Pairing &pairing, double kappa, double ratio,
                                    double closure) const
{
  const int low = pairing.low, high = pairing.high;
  const int *type = atom->type;
  const Elastic &one = pair->elastic(low), &other = pair->elastic(high);
  const auto mean = [](double a, double b) { return 2.0 * a * b / (a + b); };
  const double modulus = mean(one.lambda + 2.0 * one.shear, other.lambda + 2.0 * other.shear);
  pairing.pair.shear_ratio = ratio * mean(one.shear, other.shear) / modulus;
  pairing.pair.stiffness =
      stiffness * closure * 2.0 * modulus / kappa * atom->vfrac[low] * atom->vfrac[high];
  pairing.pair.friction = friction[type[low]][type[high]];
  pairing.pair.horizon = pair->horizon(type[low], type[high]);
}

/* ----------------------------------------------------------------------
   pasts of the refitted pairs, from rows as an evaluation fills them
------------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::keep_energy()
{
  const Kernel kernel = pair->kernel_of_bonds();
  const bool expands = pair->expands();
  for (const Refit &r : refits) {
    Pairing &p = pairings[r.pairing];
    const auto low = end_at<D>(p.low, expands), high = end_at<D>(p.high, expands);
    p.now = past_of_refitted(contact_state<D>(r.before, low, high, p.now, kernel, 0.0),
                             contact_state<D>(p.pair, low, high, {}, kernel, 0.0));
  }
  refits.clear();
}

// for fix_tmsph_contact.cpp

template void FixTMSPHContact::keep_energy<2>();
template void FixTMSPHContact::keep_energy<3>();
