/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Particles that meet although they did not face each other in the reference
   state: bodies that collide, surfaces that slip by more than the horizon.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "tmsph_cells.h"
#include "tmsph_region_surface.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// pairs farther apart than this many horizons part

static constexpr double PARTING = 1.1;

// cosine of the angle between the outward normals of surfaces that face each other, at most

static constexpr double FACING = -0.3;

// and of two particles that are certainly on the same side of a surface, at least

static constexpr double SAME_SIDE = 0.9;

static constexpr int LONGEST = 200, WHILE_MINIMIZING = 10;    // steps between searches

// roughness of surfaces in particle spacings: pairs that join a contact start with its penetration
// rather than with a gap below this

static constexpr double ROUGH = 0.5;

// what a search tells of each particle: F - I, its surface, and of its pairs that press the sums of
// the stiffnesses and of stiffness times penetration

template <int D> struct SearchRow {
  static constexpr int H = 0, NORMAL = D * D, DEPTH = NORMAL + 3, EXPOSURE = DEPTH + 1,
                       STIFFNESS = EXPOSURE + 1, PRESSED = STIFFNESS + 1, WIDTH = PRESSED + 1;
};

/* ----------------------------------------------------------------------
   the nearest surface of a region within the horizon of local or ghost particle i
   in the reference positions, or INSIDE
------------------------------------------------------------------------- */

Surface FixTMSPHContact::given_surface(int i) const
{
  Surface s;
  s.depth = pair->horizon();
  for (Region *region : regions) take_nearest_surface(*region, *bonds, i, s);
  return s;
}

/* ----------------------------------------------------------------------
   @param X reference vector of the pair
   @return  false if the two are not on either side of a given surface
------------------------------------------------------------------------- */

template <int D>
bool FixTMSPHContact::take_given_surfaces(const Pairing &p, const double *X,
                                          PairGeometry &geometry)
{
  if (regions.empty()) return false;
  const Surface one = given_surface(p.low), other = given_surface(p.high);
  if (one.exposure != Exposure::GIVEN || other.exposure != Exposure::GIVEN) return false;
  double facing = 0.0, apart = 0.0;
  for (int a = 0; a < D; a++) {
    facing += one.normal[a] * other.normal[a];
    apart += 0.5 * (one.normal[a] - other.normal[a]) * X[a];
  }
  const double square = 0.5 * (1.0 - facing);    // of the length of half the difference: of "lean"
  if (facing > SAME_SIDE && !sides_checked) {
    sides_checked = true;
    error->warning(FLERR,
                   "Particles {} and {} are not bonded but on the same side of the surface of "
                   "fix tmsph/contact: give the region by which they got their types",
                   atom->tag[p.low], atom->tag[p.high]);
  }
  if (facing > FACING || apart <= 0.0) return false;
  for (int a = 0; a < 3; a++) {
    geometry.normal_low[a] = one.normal[a];
    geometry.normal_high[a] = -other.normal[a];
  }
  geometry.distance = apart / square;
  geometry.share = one.depth / (one.depth + other.depth);
  return true;
}

template bool FixTMSPHContact::take_given_surfaces<2>(const Pairing &, const double *,
                                                      PairGeometry &);
template bool FixTMSPHContact::take_given_surfaces<3>(const Pairing &, const double *,
                                                      PairGeometry &);

/* ---------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::find_surfaces()
{
  if (surfaces_version == bonds->layout_version() && surfaces_removals == bonds->removals()) return;
  surfaces_version = bonds->layout_version();
  surfaces_removals = bonds->removals();
  surfaces.assign(atom->nlocal, Surface());
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    surfaces[i] = given_surface(i);
    if (surfaces[i].exposure == Exposure::GIVEN) continue;
    OwnSurface<D> own;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE)) {
      double X[3];
      bonds->reference_vector(i, bond.j, X);
      own.add(X, bonds->weight(i, bond.j));
    }
    surfaces[i] = own.find(bonds->spacing(i));
  }
}

/* ----------------------------------------------------------------------
   @return number of ends at local particles that parted
------------------------------------------------------------------------- */

int FixTMSPHContact::part()
{
  int parted = 0;
  for (const Member &m : members) {
    std::vector<tagint> gone;
    for (int n = m.first; n < m.last; n++) {
      const double *xi = atom->x[m.i], *xj = atom->x[ends[n].j];
      const double reach =
          PARTING * pair->horizon(atom->type[m.i], atom->type[ends[n].j]);
      double r2 = 0.0;
      for (int a = 0; a < 3; a++) r2 += (xj[a] - xi[a]) * (xj[a] - xi[a]);
      if (r2 < reach * reach) continue;
      parted++;
      if (ends[n].record)
        ends[n].record->parted = true;
      else
        gone.push_back(ends[n].met->partner);
    }
    if (gone.empty()) continue;
    std::vector<Met> &met = m.memory->met;
    met.erase(std::remove_if(met.begin(), met.end(), [&gone](const Met &one) {
      return std::find(gone.begin(), gone.end(), one.partner) != gone.end();
    }), met.end());
  }
  return parted;
}

/* ----------------------------------------------------------------------
   true if local particle i and j are no pair yet but could be one
------------------------------------------------------------------------- */

bool FixTMSPHContact::may_meet(int i, int j) const
{
  const bool one_body = pair->bonded(atom->type[i], atom->type[j]);
  if (one_body ? !self : segments != nullptr) return false;
  const tagint partner = atom->tag[j];
  const int state = bonds->state_with(i, partner);
  const auto found = memories.find(atom->tag[i]);
  if (state >= 0) {
    if (!counts(state) || found == memories.end()) return false;
    const std::vector<Record> &records = found->second.records;
    const auto r = std::lower_bound(records.begin(), records.end(), partner,
                                    [](const Record &a, tagint id) { return a.partner < id; });
    if (r == records.end() || r->partner != partner || !r->parted) return false;
  }
  if (found == memories.end()) return true;
  const std::vector<Met> &met = found->second.met;
  return std::none_of(met.begin(), met.end(),
                      [partner](const Met &one) { return one.partner == partner; });
}

/* ----------------------------------------------------------------------
   surfaces that face each other within the horizon become pairs, without a jump
   of force: where others press already with their mean penetration, else with
   none
   @return number of ends at local particles that met
------------------------------------------------------------------------- */

template <int D> int FixTMSPHContact::meet()
{
  using Row = SearchRow<D>;
  const double horizon = pair->horizon();
  const auto row = [this](int i) { return rows.data() + (size_t) width * i; };
  const auto exposed = [&](int i) { return row(i)[Row::EXPOSURE] != (double) Exposure::INSIDE; };
  std::vector<int> candidates;
  for (int i = 0; i < atom->nlocal + atom->nghost; i++)
    if (exposed(i)) candidates.push_back(i);
  const Cells cells(atom->x, candidates, horizon);

  int met = 0;
  static constexpr double REST[3] = {};
  const auto make = [&](int i, int j) {
    double r2 = 0.0;
    for (int a = 0; a < 3; a++) {
      const double d = atom->x[j][a] - atom->x[i][a];
      r2 += d * d;
    }
    const double within = pair->horizon(atom->type[i], atom->type[j]);
    if (j == i || r2 >= within * within || atom->tag[j] == atom->tag[i] || !may_meet(i, j))
      return;
    const bool is_low = atom->tag[i] < atom->tag[j];
    const int low = is_low ? i : j, high = is_low ? j : i;
    const double *one = row(low), *other = row(high);
    const auto end = [&](int p) {
      return ContactEnd<D>{atom->x[p], REST, REST, row(p) + Row::H, pair->thermal_strain(p),
                           true};
    };
    ContactPair pair_of_them = {};
    pair_of_them.horizon = within;
    double n_low[D], n_high[D], facing = 0.0;
    for (int a = 0; a < 3; a++) {
      pair_of_them.normal_low[a] = one[Row::NORMAL + a];
      pair_of_them.normal_high[a] = -other[Row::NORMAL + a];
    }
    carried_normal<D>(one + Row::H, pair_of_them.normal_low, n_low);
    carried_normal<D>(other + Row::H, pair_of_them.normal_high, n_high);
    for (int a = 0; a < D; a++) facing -= n_low[a] * n_high[a];
    const auto are = [&](Exposure e, bool both) {
      const bool is = one[Row::EXPOSURE] == (double) e, too = other[Row::EXPOSURE] == (double) e;
      return both ? is && too : is || too;
    };
    if (!are(Exposure::LOOSE, false) && facing > FACING) return;
    const bool loose = are(Exposure::LOOSE, true);
    pair_of_them.loose = loose;
    for (int a = 0; a < D && loose; a++)
      pair_of_them.normal_low[a] = pair_of_them.normal_high[a] =
          (atom->x[high][a] - atom->x[low][a]) / std::sqrt(r2);

    const ContactState<D> s = contact_state<D>(pair_of_them, end(low), end(high), {},
                                               pair->kernel_of_bonds(), 0.0);
    if (!(s.penetration < 0.0)) return;    // with D = 0: the one behind the other

    const double depths = one[Row::DEPTH] + other[Row::DEPTH];
    const double stiff = one[Row::STIFFNESS] + other[Row::STIFFNESS];
    const double pressed = stiff > 0.0 ? (one[Row::PRESSED] + other[Row::PRESSED]) / stiff : 0.0;
    const double neutral = (pressed - s.penetration) / (s.stretch * s.lean);
    const double size = 0.5 * (bonds->spacing(low) + bonds->spacing(high));
    const bool joins = stiff > 0.0 && neutral < depths + ROUGH * size;
    Met record = {atom->tag[j], {}, pair_of_them};
    record.geometry.distance = are(Exposure::GIVEN, true) ? depths
        : joins                                          ? neutral
                                                         : std::min(depths, neutral);
    record.geometry.share = one[Row::DEPTH] / depths;
    for (int k = 0; k < D - 1; k++) record.past.moved[k] = s.slip[k] / s.stretch;
    memories[atom->tag[i]].met.push_back(record);
    met++;
  };
  for (const int i : candidates)
    if (i < atom->nlocal) cells.near(atom->x[i], [&](int j) { make(i, j); });
  for (auto &[id, memory] : memories)
    std::sort(memory.met.begin(), memory.met.end(),
              [](const Met &a, const Met &b) { return a.partner < b.partner; });
  return met;
}

/* ---------------------------------------------------------------------- */

template <int D>
void FixTMSPHContact::search(const std::vector<ContactState<D>> &states)
{
  using Row = SearchRow<D>;
  write_back();
  find_surfaces<D>();
  width = Row::WIDTH;
  rows.assign((size_t) width * (atom->nlocal + atom->nghost), 0.0);
  const double *gradient = pair->step_gradient();
  for (int i = 0; i < atom->nlocal; i++) {
    double *row = rows.data() + (size_t) width * i;
    const Surface &s = surfaces[i];
    std::copy_n(gradient + (size_t) D * D * i, D * D, row + Row::H);
    std::copy_n(s.normal, 3, row + Row::NORMAL);
    row[Row::DEPTH] = s.depth;
    row[Row::EXPOSURE] = (double) s.exposure;
  }
  for (const Member &m : members) {
    double *row = rows.data() + (size_t) width * m.i;
    for (int n = m.first; n < m.last; n++) {
      const ContactState<D> &s = states[ends[n].pairing];
      if (s.penetration <= 0.0) continue;
      row[Row::STIFFNESS] += s.stiffness;
      row[Row::PRESSED] += s.stiffness * s.penetration;
    }
  }
  send(0, width);

  const int parted = part();
  int mine = parted + meet<D>();
  int changes;
  MPI_Allreduce(&mine, &changes, 1, MPI_INT, MPI_SUM, world);
  plan_search();
  if (segments) face();
  if (!changes && !segments) return;
  list_pairs();
  if (!any_pairs) return;
  fit_pairs<D>();
}

template void FixTMSPHContact::search(const std::vector<ContactState<2>> &);
template void FixTMSPHContact::search(const std::vector<ContactState<3>> &);

/* ----------------------------------------------------------------------
   the next search, before the fastest particles come closer by the margin
   even if they double their velocity until then
------------------------------------------------------------------------- */

void FixTMSPHContact::plan_search()
{
  double square = 0.0, fastest;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    square = std::max(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  MPI_Allreduce(&square, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);
  search_dt = update->dt;
  const double way = 4.0 * std::sqrt(fastest) * update->dt;
  const double margin = SEARCH_MARGIN * pair->horizon();
  const int steps = way * LONGEST > margin ? std::max(1, (int) (margin / way)) : LONGEST;
  last_search = update->ntimestep;
  next_search = last_search + (update->whichflag == 2 ? WHILE_MINIMIZING : steps);
}
