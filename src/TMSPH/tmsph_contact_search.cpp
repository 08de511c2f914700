/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Particles that meet although they did not face each other in the reference
   state.
------------------------------------------------------------------------- */

#include "tmsph_contact_search.h"

#include "atom.h"
#include "tmsph_cells.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Member = TMSPHContactList::Member;
using End = TMSPHContactList::End;
using Record = TMSPHContactMemory::Record;

// pairs farther apart than this many horizons part: beyond 1, where their weight is 0, so that
// pairs at the horizon do not come and go; 1 to 1.3 do the same but for round-off in test_fragments

static constexpr double PARTING = 1.1;

// steps between searches, at most, and where there are no velocities to plan by: 50 to 1000 do the
// same in test_collision, 1 to 50 in the disc of test_quasistatic that touches with friction

static constexpr int LONGEST = 200, WHILE_MINIMIZING = 10;

// roughness of surfaces in particle spacings: pairs that join a contact start with its penetration
// rather than with a gap below this: half of a step, a spacing, of a surface at an angle to its
// lattice; 0.25 to 1 change the work of friction in test_collision by less than 0.1 %

static constexpr double ROUGH = 0.5;

// what a search tells of each particle: F - I, its surface, and of its pairs that press the sums of
// the stiffnesses and of stiffness times penetration

template <int D> struct SearchRow {
  static constexpr int H = 0, NORMAL = D * D, DEPTH = NORMAL + 3, EXPOSURE = DEPTH + 1,
                       STIFFNESS = EXPOSURE + 1, PRESSED = STIFFNESS + 1, SIZE = PRESSED + 1;
};

/* ---------------------------------------------------------------------- */

bool TMSPHContactSearch::due() const
{
  const bigint now = update->ntimestep;    // which reset_timestep may set back
  return now >= next_step || now < last_step || update->dt != step_dt;
}

/* ----------------------------------------------------------------------
   @return number of ends at local particles that parted
------------------------------------------------------------------------- */

int TMSPHContactSearch::part()
{
  int parted = 0;
  for (const Member &m : list.members) {
    TMSPHContactMemory &memory = list.memory(m);
    std::vector<tagint> gone;
    for (int n = m.first; n < m.last; n++) {
      const End &e = list.ends[n];
      const double *xi = atom->x[m.i], *xj = atom->x[e.j];
      const double reach = PARTING * scene.pair->horizon(atom->type[m.i], atom->type[e.j]);
      double r2 = 0.0;
      for (int a = 0; a < 3; a++) r2 += (xj[a] - xi[a]) * (xj[a] - xi[a]);
      if (r2 < reach * reach) continue;
      parted++;
      if (e.later)
        gone.push_back(memory.met[e.place].partner);
      else
        memory.records[e.place].parted = true;
    }
    if (gone.empty()) continue;
    memory.met.erase(std::remove_if(memory.met.begin(), memory.met.end(),
                                    [&](const Record &one) {
                                      return std::find(gone.begin(), gone.end(), one.partner) !=
                                          gone.end();
                                    }),
                     memory.met.end());
  }
  return parted;
}

/* ----------------------------------------------------------------------
   true if local particle i and j are no pair yet but could be one
------------------------------------------------------------------------- */

bool TMSPHContactSearch::may_meet(int i, int j) const
{
  const bool one_body = scene.pair->bonded(atom->type[i], atom->type[j]);
  if (one_body ? !scene.self : scene.segments) return false;
  const tagint partner = atom->tag[j];
  const int state = scene.bonds->state_with(i, partner);
  const TMSPHContactMemory *memory = memories.find(atom->tag[i]);
  if (state >= 0) {
    if (!scene.counts(state) || !memory) return false;
    const TMSPHContactMemory::Record *r = memory->record_of(partner);
    if (!r || !r->parted) return false;
  }
  return !memory || !memory->has_met(partner);
}

/* ----------------------------------------------------------------------
   normals and, of loose particles, the line between them; @return false if the
   surfaces do not face each other
------------------------------------------------------------------------- */

template <int D>
bool TMSPHContactSearch::face(int low, int high, const TMSPHGhostRows &rows,
                              ContactPair &pair) const
{
  using Row = SearchRow<D>;
  const double *one = rows[low], *other = rows[high];
  double n_low[D], n_high[D], facing = 0.0, r2 = 0.0;
  for (int a = 0; a < 3; a++) {
    pair.normal_low[a] = one[Row::NORMAL + a];
    pair.normal_high[a] = -other[Row::NORMAL + a];
  }
  carried_normal<D>(one + Row::H, pair.normal_low, n_low);
  carried_normal<D>(other + Row::H, pair.normal_high, n_high);
  for (int a = 0; a < D; a++) facing -= n_low[a] * n_high[a];
  const bool low_loose = one[Row::EXPOSURE] == (double) Exposure::LOOSE;
  const bool high_loose = other[Row::EXPOSURE] == (double) Exposure::LOOSE;
  if (!low_loose && !high_loose && facing > FACING) return false;
  pair.loose = low_loose && high_loose;
  if (!(low_loose && high_loose)) return true;
  for (int a = 0; a < 3; a++) {
    const double d = atom->x[high][a] - atom->x[low][a];
    r2 += d * d;
  }
  for (int a = 0; a < D; a++)
    pair.normal_low[a] = pair.normal_high[a] = (atom->x[high][a] - atom->x[low][a]) / std::sqrt(r2);
  return true;
}

/* ----------------------------------------------------------------------
   local particle i remembers j if their surfaces face each other within the horizon
------------------------------------------------------------------------- */

template <int D> bool TMSPHContactSearch::meet_pair(int i, int j, const TMSPHGhostRows &rows)
{
  using Row = SearchRow<D>;
  static constexpr double REST[3] = {};
  double r2 = 0.0;
  for (int a = 0; a < 3; a++) {
    const double d = atom->x[j][a] - atom->x[i][a];
    r2 += d * d;
  }
  const double within = scene.pair->horizon(atom->type[i], atom->type[j]);
  if (j == i || r2 >= within * within || atom->tag[j] == atom->tag[i] || !may_meet(i, j))
    return false;
  const bool is_low = atom->tag[i] < atom->tag[j];
  const int low = is_low ? i : j, high = is_low ? j : i;
  const double *one = rows[low], *other = rows[high];
  ContactPair pair = {};
  pair.horizon = within;
  if (!face<D>(low, high, rows, pair)) return false;
  const auto end = [&](int p) {
    return ContactEnd<D>{atom->x[p], REST, REST, rows[p] + Row::H, scene.pair->thermal_strain(p),
                         true};
  };
  const ContactState<D> s =
      contact_state<D>(pair, end(low), end(high), {}, scene.pair->kernel_of_bonds(), 0.0);
  if (!(s.penetration < 0.0)) return false;    // with D = 0: the one behind the other

  const double depths = one[Row::DEPTH] + other[Row::DEPTH];
  const double stiff = one[Row::STIFFNESS] + other[Row::STIFFNESS];
  const double pressed = stiff > 0.0 ? (one[Row::PRESSED] + other[Row::PRESSED]) / stiff : 0.0;
  const double neutral = (pressed - s.penetration) / (s.stretch * s.lean);
  const double size = 0.5 * (scene.bonds->spacing(low) + scene.bonds->spacing(high));
  const bool joins = stiff > 0.0 && neutral < depths + ROUGH * size;
  const bool given = one[Row::EXPOSURE] == (double) Exposure::GIVEN &&
      other[Row::EXPOSURE] == (double) Exposure::GIVEN;
  Record record = {atom->tag[j], {}, pair};
  record.geometry.distance = given ? depths : joins ? neutral : std::min(depths, neutral);
  record.geometry.depth = one[Row::DEPTH] / depths;
  for (int k = 0; k < D - 1; k++) record.past.moved[k] = s.slip[k] / s.stretch;
  memories.of(atom->tag[i]).met.push_back(record);
  return true;
}

/* ----------------------------------------------------------------------
   surfaces that face each other within the horizon become pairs, without a jump
   of force: where others press already with their mean penetration, else with
   none
   @return number of ends at local particles that met
------------------------------------------------------------------------- */

template <int D> int TMSPHContactSearch::meet(const TMSPHGhostRows &rows)
{
  std::vector<int> candidates;
  for (int i = 0; i < atom->nlocal + atom->nghost; i++)
    if (rows[i][SearchRow<D>::EXPOSURE] != (double) Exposure::INSIDE) candidates.push_back(i);
  const Cells cells(atom->x, candidates, scene.pair->horizon());
  int met = 0;
  for (const int i : candidates)
    if (i < atom->nlocal) cells.near(atom->x[i], [&](int j) { met += meet_pair<D>(i, j, rows); });
  for (int n = 0; n < memories.count(); n++)
    std::sort(memories[n].met.begin(), memories[n].met.end(),
              [](const Record &a, const Record &b) { return a.partner < b.partner; });
  return met;
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHContactSearch::fill_rows(const std::vector<ContactState<D>> &states,
                                   TMSPHGhostRows &rows) const
{
  using Row = SearchRow<D>;
  const double *gradient = scene.pair->step_gradient();
  for (int i = 0; i < atom->nlocal; i++) {
    const Surface &s = surfaces[i];
    std::copy_n(gradient + (size_t) D * D * i, D * D, rows[i] + Row::H);
    std::copy_n(s.normal, 3, rows[i] + Row::NORMAL);
    rows[i][Row::DEPTH] = s.depth;
    rows[i][Row::EXPOSURE] = (double) s.exposure;
  }
  for (const Member &m : list.members) {
    double *row = rows[m.i];
    for (int n = m.first; n < m.last; n++) {
      const ContactState<D> &s = states[list.ends[n].pairing];
      if (s.penetration <= 0.0) continue;
      row[Row::STIFFNESS] += s.stiffness;
      row[Row::PRESSED] += s.stiffness * s.penetration;
    }
  }
}

/* ---------------------------------------------------------------------- */

template <int D> bool TMSPHContactSearch::find(const std::vector<ContactState<D>> &states)
{
  list.write_back();
  surfaces.find<D>();
  TMSPHGhostRows rows(SearchRow<D>::SIZE);
  rows.fill(atom->nlocal + atom->nghost, 0.0);
  fill_rows<D>(states, rows);
  ghosts.send(rows, 0, rows.columns());
  const int parted = part();
  int mine = parted + meet<D>(rows);
  int changes;
  MPI_Allreduce(&mine, &changes, 1, MPI_INT, MPI_SUM, world);
  plan_next();
  return changes;
}

template bool TMSPHContactSearch::find(const std::vector<ContactState<2>> &);
template bool TMSPHContactSearch::find(const std::vector<ContactState<3>> &);

/* ----------------------------------------------------------------------
   the next search, before the fastest particles come closer by the margin
   even if they double their velocity until then
------------------------------------------------------------------------- */

void TMSPHContactSearch::plan_next()
{
  double square = 0.0, fastest;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    square = std::max(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  MPI_Allreduce(&square, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);
  step_dt = update->dt;
  const double way = 4.0 * std::sqrt(fastest) * update->dt;
  const double margin = scene.search_margin();
  const int steps = way * LONGEST > margin ? std::max(1, (int) (margin / way)) : LONGEST;
  last_step = update->ntimestep;
  next_step = last_step + (update->whichflag == 2 ? WHILE_MINIMIZING : steps);
}
