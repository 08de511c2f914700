/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of particles that walls or contacts press.
------------------------------------------------------------------------- */

#include "tmsph_pressed_surfaces.h"

#include "domain.h"
#include "fix.h"
#include "modify.h"
#include "tmsph_surface_contact.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// particles report the average in full when their surface makes this part of their stress, or that
// of one of their family: with an eighth single ones beside a closed cut are off by 12 %, with this
// by less than 10 % (unittest/verification/test_closed_cut.py)

static constexpr double PRESSED = 0.04;

// rounds of averaging: in equilibrium, with hourglass 0.1 to 0.5, the stresses of all rows of a
// square, hexagonal or simple cubic lattice along a wall are then within 1.3 % of p, with one round
// 6 %; of rows along diagonals, whose particles stand in front of each other, 4 %
// (unittest/verification/test_wall_stress.py)

static constexpr int ROUNDS = 3;

// rounds where contacts alone press: with one, single particles beside a closed cut are off by 11 %
// (unittest/verification/test_closed_cut.py)

static constexpr int CONTACT_ROUNDS = 2;

// a surface that is pressed is taken to be so for this many calls: then nobody needs to ask (the
// example uniaxial makes 7895 reductions in place of 12955)

static constexpr int TRUSTED = 50;

/// columns of a row that is sent: how forces on the outermost particles press, the norms of the
/// stress by contacts and by bonds, and what is to be spread over the sum of V_k W_ik; without
/// forces on the outermost the stress of who is pressed
namespace {
enum { BY_SURFACE, BY_CONTACT, BY_BONDS, SPREAD };
}

/// how much of the average is reported, by the norms of the stress of surfaces and of bonds
static double part_of(double surface, double bonded)
{
  return std::min(1.0, surface / (PRESSED * (surface + bonded)));
}

/* ---------------------------------------------------------------------- */

void TMSPHPressedSurfaces::init()
{
  size = stress_row(domain->dimension);
  rows.set_columns(SPREAD + size);
  layout.forget();
}

/* ----------------------------------------------------------------------
   after an exchange of particles all is found anew
------------------------------------------------------------------------- */

void TMSPHPressedSurfaces::lay_out()
{
  if (!layout.laid_out_anew(*bonds)) return;
  layout.see(*bonds);
  const int nlocal = atom->nlocal;
  rows.fill(nlocal + atom->nghost, 0.0);
  near_ones.clear();
  spans.assign(nlocal, Span());
  listed.assign(nlocal, 0);
  across.clear();
  for (int i = 0; i < nlocal; i++)
    for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE))
      if (bond.j >= nlocal && atom->type[bond.j] == atom->type[i])
        across.push_back({i, bond.k, bond.j});
}

/* ---------------------------------------------------------------------- */

void TMSPHPressedSurfaces::follow(const FixTMSPHBond &present, const std::vector<int> &touched)
{
  if (layout.laid_out_anew(present)) return;
  for (const int i : touched) spans[i] = Span();
}

/* ----------------------------------------------------------------------
   those near a local particle: itself first, then its bonds to the own material by ascending ids
------------------------------------------------------------------------- */

TMSPHPressedSurfaces::Span TMSPHPressedSurfaces::near(int i)
{
  Span &span = spans[i];
  if (span.last > 0) return span;
  const auto add = [this, i](int j) {
    const double V_W = bonds->kernel_mass(i, j, materials.horizon(atom->type[i], atom->type[i]));
    near_ones.push_back({j, V_W / bonds->body_thickness()});
  };
  span.first = near_ones.size();
  add(i);
  for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE))
    if (atom->type[bond.j] == atom->type[i]) add(bond.j);
  span.last = near_ones.size();
  return span;
}

/* ----------------------------------------------------------------------
   forces of walls, and of contact at outlines
------------------------------------------------------------------------- */

static bool reaches_outermost(Fix *fix)
{
  const auto *pairs = dynamic_cast<TMSPHSurfaceContact *>(fix);
  return !pairs || !pairs->over_horizon();
}

/* ---------------------------------------------------------------------- */

int TMSPHPressedSurfaces::doubles_per_ghost() const
{
  int most = 0;
  for (Fix *fix : modify->get_fix_list())
    if (dynamic_cast<TMSPHPresses *>(fix))
      most = std::max(most,
                      reaches_outermost(fix) ? rows.columns() + ROUNDS * size
                                             : CONTACT_ROUNDS * (rows.columns() - BY_CONTACT));
  return most;
}

/* ----------------------------------------------------------------------
   of a stress row
------------------------------------------------------------------------- */

static double norm(const double *s, int size)
{
  const int dimension = size == 3 ? 2 : 3;
  double square = 0.0;
  for (int k = 0; k < size; k++) square += (k < dimension ? 1.0 : 2.0) * s[k] * s[k];
  return std::sqrt(square);
}

/* ----------------------------------------------------------------------
   Forces on the outermost particles are spread with the kernel, which keeps the sum of their stress
   over volumes. All who get some, or have a partner who has, report
     S_i + p_i sum_j V_j W_ij (S_j - S_i), round after round.
   Pairs of contact are over the horizon as they are: with p of the smaller stress by contact and
   the larger one by bonds of i and j for p_i, so that particles which nothing presses, as those at
   the tip of a crack whose faces touch, keep their own, and a pair that hardly presses changes
   hardly anything, even where bonds do not either. Where nothing else presses only their stresses are sent, and fewer times.
------------------------------------------------------------------------- */

void TMSPHPressedSurfaces::add_stress(const FixTMSPHBond &present, double *stresses)
{
  std::vector<TMSPHPresses::Load> loads;
  bool possible = false, by_surfaces = false;    // the same on all processors
  for (Fix *fix : modify->get_fix_list())
    if (auto *one = dynamic_cast<TMSPHPresses *>(fix)) {
      one->add_loads(loads);
      if (!one->may_press()) continue;
      possible = true;
      by_surfaces = by_surfaces || reaches_outermost(fix);
    }
  if (!possible || !pressed(!loads.empty())) return;
  bonds = &present;
  stress = stresses;
  lay_out();
  take_loads(loads);
  if (by_surfaces)
    average_surfaces();
  else
    average_pairs();
  for (const auto *some : {&outermost, &touching})
    for (const int i : *some) std::fill_n(rows[i], rows.columns(), 0.0);
}

/* ----------------------------------------------------------------------
   @param here some surface of this processor (collective)
   @return     some surface anywhere; perhaps no more
------------------------------------------------------------------------- */

bool TMSPHPressedSurfaces::pressed(bool here)
{
  if (trusted > 0) {
    trusted--;
    return true;
  }
  int mine = here, any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (any) trusted = TRUSTED;
  return any;
}

/* ----------------------------------------------------------------------
   rows of local particles, and those that have one
------------------------------------------------------------------------- */

void TMSPHPressedSurfaces::take_loads(const std::vector<TMSPHPresses::Load> &loads)
{
  outermost.clear();
  touching.clear();
  for (const auto &load : loads) {
    const int i = load.i;
    const double flat[3] = {load.stress[0], load.stress[1], load.stress[3]};
    const double *s = size == 3 ? flat : load.stress;
    double *own = stress + (size_t) size * i;
    const double surface = norm(s, size), bonded = norm(own, size);
    if (surface == 0.0) continue;
    double &pressed_by = rows[i][load.outermost ? BY_SURFACE : BY_CONTACT];
    if (pressed_by == 0.0) (load.outermost ? outermost : touching).push_back(i);
    pressed_by = std::max(pressed_by, load.outermost ? part_of(surface, bonded) : surface);
    if (!load.outermost) rows[i][BY_BONDS] = bonded;
    double sum = load.outermost ? 0.0 : 1.0;
    if (load.outermost) {
      const Span span = near(i);
      for (int n = span.first; n < span.last; n++) sum += near_ones[n].mass;
    }
    double *to = load.outermost ? rows[i] + SPREAD : own;
    for (int k = 0; k < size; k++) to[k] += s[k] / sum;
  }
}

/* ----------------------------------------------------------------------
   local particles that are pressed, or on whose family forces on the outermost press
------------------------------------------------------------------------- */

void TMSPHPressedSurfaces::find_members()
{
  members.clear();
  const auto add = [&](int i) {
    if (!listed[i]) members.push_back({i, 0.0});
    listed[i] = 1;
  };
  for (const int i : touching) add(i);
  for (const int i : outermost) {
    const Span span = near(i);
    for (int n = span.first; n < span.last; n++)
      if (near_ones[n].j < atom->nlocal) add(near_ones[n].j);
  }
  for (const auto &bond : across)
    if (rows[bond.ghost][BY_SURFACE] > 0.0 &&
        bonds->bond_state(bond.i, bond.k) == FixTMSPHBond::INTACT)
      add(bond.i);
  for (const Member &m : members) listed[m.i] = 0;
}

/* ---------------------------------------------------------------------- */

void TMSPHPressedSurfaces::average_surfaces()
{
  ghosts.send(rows, 0, rows.columns());
  find_members();
  changes.assign(members.size() * size, 0.0);
  double *change = changes.data();
  for (Member &m : members) {
    const Span span = near(m.i);
    for (int n = span.first; n < span.last; n++) {
      const Near &one = near_ones[n];
      const double *his = rows[one.j];
      m.part = std::max(m.part, his[BY_SURFACE]);
      for (int k = 0; k < size; k++) change[k] += one.mass * his[SPREAD + k];
    }
    change += size;
  }
  add_changes();
  for (int round = 0; round < ROUNDS; round++) {
    ghosts.send(stress, size, size);
    average(stress, size, round < CONTACT_ROUNDS);
  }
}

/* ----------------------------------------------------------------------
   of those that are pressed the stresses come along
------------------------------------------------------------------------- */

void TMSPHPressedSurfaces::average_pairs()
{
  members.clear();
  for (const int i : touching) members.push_back({i, 0.0});
  for (int round = 0; round < CONTACT_ROUNDS; round++) {
    for (const int i : touching) std::copy_n(stress + (size_t) size * i, size, rows[i] + SPREAD);
    ghosts.send(rows, BY_CONTACT, rows.columns() - BY_CONTACT);
    average(rows[0] + SPREAD, rows.columns(), true);
  }
}

/* ----------------------------------------------------------------------
   one round
   @param stresses,stride of local and ghost particles, those that take part
   @param pairs           with the averages over pairs of contact
------------------------------------------------------------------------- */

void TMSPHPressedSurfaces::average(const double *stresses, int stride, bool pairs)
{
  changes.assign(members.size() * size, 0.0);
  for (size_t number = 0; number < members.size(); number++) {
    const Member &m = members[number];
    double *change = changes.data() + number * size;
    const double *mine = stresses + (size_t) stride * m.i;
    const double *here = rows[m.i];
    if (!(mine[0] < UNBEARABLE)) continue;
    const Span span = near(m.i);
    for (int n = span.first; n < span.last; n++) {
      const Near &one = near_ones[n];
      const double *there = rows[one.j];
      const double touched = pairs ? std::min(here[BY_CONTACT], there[BY_CONTACT]) : 0.0;
      const double most = touched == 0.0
          ? m.part
          : std::max(m.part, part_of(touched, std::max(here[BY_BONDS], there[BY_BONDS])));
      const double *his = stresses + (size_t) stride * one.j;
      if (most == 0.0 || !(his[0] < UNBEARABLE)) continue;
      const double part = most * one.mass;
      for (int k = 0; k < size; k++) change[k] += part * (his[k] - mine[k]);
    }
  }
  add_changes();
}

/* ---------------------------------------------------------------------- */

void TMSPHPressedSurfaces::add_changes()
{
  const double *change = changes.data();
  for (const Member &m : members)
    for (int k = 0; k < size; k++) stress[(size_t) size * m.i + k] += *change++;
}

/* ---------------------------------------------------------------------- */

double TMSPHPressedSurfaces::bytes() const
{
  return rows.bytes() + near_ones.capacity() * sizeof(Near) + spans.capacity() * sizeof(Span) +
      across.capacity() * sizeof(Across);
}
