/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of particles that walls or contacts press, for output and for the
   breaking of bonds.

   A force on the surface reaches the outermost particles, while bonds pass it
   on over the horizon. What bonds carry of a uniform stress p near a wall
   follows from their equilibrium, row by row: 0.71, 0.81, 0.96, 1.02 p in a
   square lattice. Missing is p over half a row: the force on the surface times
   half a row. Meant is the average with the kernel of both (Hardy, J. Chem.
   Phys. 76 (1982) 622). Only bonds to the own material take part.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "fix.h"
#include "modify.h"
#include "tmsph_presses.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// particles report the average in full when their surface makes this part of their stress, or that
// of one of their family: with an eighth single ones beside a closed cut are off by 12 %, with this
// by less than 10 % (unittest/verification/test_closed_cut.py)

static constexpr double PRESSED = 0.04;

// So often: in equilibrium, with hourglass 0.1 to 0.5, the stresses of all rows of a square,
// hexagonal or simple cubic lattice along the wall are then within 1.3 % of p; with one round 6 %.
// Of rows along diagonals, whose particles stand in front of each other, 4 %.

static constexpr int ROUNDS = 3;

// of them where contacts alone press: with one single particles beside a closed cut are off by 11 %

static constexpr int CONTACT_ROUNDS = 2;

// a surface that is pressed is taken to be so for this many calls: then nobody needs to ask

static constexpr int TRUSTED = 50;

/// columns of a row that is sent: how forces on the outermost particles press, how contacts do, and
/// what is to be spread over the sum of V_k W_ik; without such forces the stress of who is pressed
namespace {
enum { BY_SURFACE, BY_CONTACT, SPREAD };
}

/* ----------------------------------------------------------------------
   after an exchange of particles all is found anew
------------------------------------------------------------------------- */

void PairTMSPH::lay_out_surfaces()
{
  if (surfaces.version == bond_fix->layout_version()) return;
  surfaces.version = bond_fix->layout_version();
  const int nlocal = atom->nlocal;
  surfaces.rows.assign((size_t) pressed_width() * (nlocal + atom->nghost), 0.0);
  surfaces.near.clear();
  surfaces.spans.assign(nlocal, Span());
  surfaces.listed.assign(nlocal, 0);
  surfaces.across.clear();
  for (int i = 0; i < nlocal; i++)
    for (const auto &bond : bond_fix->family(i, FixTMSPHBond::WHOLE))
      if (bond.j >= nlocal && atom->type[bond.j] == atom->type[i])
        surfaces.across.push_back({i, bond.k, bond.j});
}

/* ----------------------------------------------------------------------
   @param touched local particles that lost a bond
------------------------------------------------------------------------- */

void PairTMSPH::drop_near(const std::vector<int> &touched)
{
  if (surfaces.version != bond_fix->layout_version()) return;
  for (const int i : touched) surfaces.spans[i] = Span();
}

/* ----------------------------------------------------------------------
   those near a local particle: itself first, then its bonds to the own material by ascending ids
------------------------------------------------------------------------- */

PairTMSPH::Span PairTMSPH::near(int i)
{
  Span &span = surfaces.spans[i];
  if (span.last > 0) return span;
  const auto add = [this, i](int j) {
    const double V_W = bond_fix->kernel_mass(i, j, horizon(atom->type[i], atom->type[i]));
    surfaces.near.push_back({j, V_W / bond_fix->body_thickness()});
  };
  span.first = surfaces.near.size();
  add(i);
  for (const auto &bond : bond_fix->family(i, FixTMSPHBond::WHOLE))
    if (atom->type[bond.j] == atom->type[i]) add(bond.j);
  span.last = surfaces.near.size();
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

/* ----------------------------------------------------------------------
   those of add_surface_stress(), once some surface is pressed; 0 without a fix that could
------------------------------------------------------------------------- */

int PairTMSPH::doubles_of_pressed() const
{
  int most = 0;
  for (Fix *fix : modify->get_fix_list())
    if (dynamic_cast<TMSPHPresses *>(fix))
      most = std::max(most, reaches_outermost(fix) ? pressed_width() + ROUNDS * stress_size()
                                                   : CONTACT_ROUNDS * pressed_width());
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
   Pairs of contact are over the horizon as they are: with the smaller of p_i and p_j for p_i, so
   that particles which nothing presses, as those at the tip of a crack whose faces touch, keep
   their own. Where nothing else presses only their stresses are sent, and fewer times.
------------------------------------------------------------------------- */

void PairTMSPH::add_surface_stress()
{
  std::vector<TMSPHPresses::Share> shares;
  bool possible = false, outermost = false;    // the same on all processors
  for (Fix *fix : modify->get_fix_list())
    if (auto *one = dynamic_cast<TMSPHPresses *>(fix)) {
      one->add_shares(shares);
      if (!one->may_press()) continue;
      possible = true;
      outermost = outermost || reaches_outermost(fix);
    }
  if (!possible || !pressed(!shares.empty())) return;
  lay_out_surfaces();
  take_shares(shares);
  if (outermost)
    average_surfaces();
  else
    average_pairs();
  for (const auto *some : {&surfaces.sharing, &surfaces.touching})
    for (const int i : *some) std::fill_n(pressed_row(i), pressed_width(), 0.0);
}

/* ----------------------------------------------------------------------
   @param mine some surface here (collective)
   @return     some surface anywhere; perhaps no more
------------------------------------------------------------------------- */

bool PairTMSPH::pressed(bool mine)
{
  if (surfaces.trusted > 0) {
    surfaces.trusted--;
    return true;
  }
  int here = mine, any;
  MPI_Allreduce(&here, &any, 1, MPI_INT, MPI_MAX, world);
  if (any) surfaces.trusted = TRUSTED;
  return any;
}

/* ----------------------------------------------------------------------
   rows of local particles, and those that have one
------------------------------------------------------------------------- */

void PairTMSPH::take_shares(const std::vector<TMSPHPresses::Share> &shares)
{
  const int size = stress_size();
  surfaces.sharing.clear();
  surfaces.touching.clear();
  for (const auto &share : shares) {
    const int i = share.i;
    const double flat[3] = {share.stress[0], share.stress[1], share.stress[3]};
    const double *s = size == 3 ? flat : share.stress;
    double *own = stress.data() + (size_t) size * i;
    const double surface = norm(s, size), bonded = norm(own, size);
    if (surface == 0.0) continue;
    double &pressed_by = pressed_row(i)[share.outermost ? BY_SURFACE : BY_CONTACT];
    if (pressed_by == 0.0)
      (share.outermost ? surfaces.sharing : surfaces.touching).push_back(i);
    pressed_by = std::max(pressed_by, std::min(1.0, surface / (PRESSED * (surface + bonded))));
    double sum = share.outermost ? 0.0 : 1.0;
    if (share.outermost) {
      const Span span = near(i);
      for (int n = span.first; n < span.last; n++) sum += surfaces.near[n].mass;
    }
    double *to = share.outermost ? pressed_row(i) + SPREAD : own;
    for (int k = 0; k < size; k++) to[k] += s[k] / sum;
  }
}

/* ----------------------------------------------------------------------
   local particles that have a share, or on whose family forces on the outermost press
------------------------------------------------------------------------- */

void PairTMSPH::find_members()
{
  auto &members = surfaces.members;
  members.clear();
  const auto add = [&](int i) {
    if (!surfaces.listed[i]) members.push_back({i, 0.0});
    surfaces.listed[i] = 1;
  };
  for (const int i : surfaces.touching) add(i);
  for (const int i : surfaces.sharing) {
    const Span span = near(i);
    for (int n = span.first; n < span.last; n++)
      if (surfaces.near[n].j < atom->nlocal) add(surfaces.near[n].j);
  }
  for (const auto &bond : surfaces.across)
    if (pressed_row(bond.ghost)[BY_SURFACE] > 0.0 &&
        bond_fix->bond_state(bond.i, bond.k) == FixTMSPHBond::INTACT)
      add(bond.i);
  for (const Member &m : members) surfaces.listed[m.i] = 0;
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::average_surfaces()
{
  const int size = stress_size(), width = pressed_width();
  send(PRESSES);
  find_members();
  auto &members = surfaces.members;
  surfaces.change.assign(members.size() * size, 0.0);
  double *change = surfaces.change.data();
  for (Member &m : members) {
    const Span span = near(m.i);
    for (int n = span.first; n < span.last; n++) {
      const Near &one = surfaces.near[n];
      const double *his = &surfaces.rows[(size_t) width * one.j];
      m.part = std::max(m.part, his[BY_SURFACE]);
      for (int k = 0; k < size; k++) change[k] += one.mass * his[SPREAD + k];
    }
    change += size;
  }
  add_changes();
  for (int round = 0; round < ROUNDS; round++) {
    send(STRESS);
    average(stress.data(), size, round < CONTACT_ROUNDS);
  }
}

/* ----------------------------------------------------------------------
   of those that are pressed the stresses come along
------------------------------------------------------------------------- */

void PairTMSPH::average_pairs()
{
  const int size = stress_size();
  surfaces.members.clear();
  for (const int i : surfaces.touching) surfaces.members.push_back({i, 0.0});
  for (int round = 0; round < CONTACT_ROUNDS; round++) {
    for (const int i : surfaces.touching)
      std::copy_n(stress.data() + (size_t) size * i, size, pressed_row(i) + SPREAD);
    send(PRESSES);
    average(surfaces.rows.data() + SPREAD, pressed_width(), true);
  }
}

/* ----------------------------------------------------------------------
   one round
   @param stresses,stride of local and ghost particles, those that take part
   @param pairs           with the averages over pairs of contact
------------------------------------------------------------------------- */

void PairTMSPH::average(const double *stresses, int stride, bool pairs)
{
  const int size = stress_size(), width = pressed_width();
  surfaces.change.assign(surfaces.members.size() * size, 0.0);
  for (size_t number = 0; number < surfaces.members.size(); number++) {
    const Member &m = surfaces.members[number];
    double *change = surfaces.change.data() + number * size;
    const double *mine = stresses + (size_t) stride * m.i;
    const double touched = pairs ? pressed_row(m.i)[BY_CONTACT] : 0.0;
    if (!(mine[0] < UNBEARABLE)) continue;
    const Span span = near(m.i);
    for (int n = span.first; n < span.last; n++) {
      const Near &one = surfaces.near[n];
      const double most = touched == 0.0
          ? m.part
          : std::max(m.part,
                     std::min(touched, surfaces.rows[(size_t) width * one.j + BY_CONTACT]));
      const double *his = stresses + (size_t) stride * one.j;
      if (most == 0.0 || !(his[0] < UNBEARABLE)) continue;
      const double part = most * one.mass;
      for (int k = 0; k < size; k++) change[k] += part * (his[k] - mine[k]);
    }
  }
  add_changes();
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::add_changes()
{
  const int size = stress_size();
  const double *change = surfaces.change.data();
  for (const Member &m : surfaces.members)
    for (int k = 0; k < size; k++) stress[(size_t) size * m.i + k] += *change++;
}
