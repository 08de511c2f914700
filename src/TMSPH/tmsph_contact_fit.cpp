/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface between the two particles of a contact pair.
------------------------------------------------------------------------- */

#include "tmsph_contact_fit.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Member = TMSPHContactList::Member;
using Pairing = TMSPHContactList::Pairing;
using Meeting = TMSPHContactList::Meeting;

// pairs that are shorter than this many particle spacings mark the surface between them: sides and
// diagonals of squares, 1.41, not second neighbors in hexagonal lattices, 1.73; for both the cuts
// of test_closed_cut are as stiff as the intact body

static constexpr double SHORT = 1.6;

// bodies whose nearest particles are farther apart than this many spacings do not touch: between
// rows of lattices, 0.7 to 1, and those with one row missing, 1.4 to 2; for a warning only

static constexpr double APART = 1.3;

// moment of inertia, in squared spacings, that marks need to overrule the direction of a bond:
// those of a straight cut have 1 and more; from 0.01 to 1 jumps and stresses of test_closed_cut in
// 2-D change by less than 1e-4

static constexpr double SCATTER = 0.1;

/* ---------------------------------------------------------------------- */

void TMSPHContactFit::fit(TMSPHContactList &list)
{
  if (domain->dimension == 2)
    fit_pairs<2>(list);
  else
    fit_pairs<3>(list);
}

/* ----------------------------------------------------------------------
   @param nearest distance of the nearest particles of bodies that are not bonded,
                  in spacings
------------------------------------------------------------------------- */

void TMSPHContactFit::warn_if_apart(double nearest)
{
  if (distance_checked) return;
  distance_checked = true;
  double nearest_of_all;
  MPI_Allreduce(&nearest, &nearest_of_all, 1, MPI_DOUBLE, MPI_MIN, world);
  if (nearest_of_all < APART || nearest_of_all == HUGE_VAL || comm->me) return;
  error->warning(FLERR,
                 "Bodies that are not bonded have their nearest particles {:.3g} spacings "
                 "apart: fix tmsph/contact {} takes their surfaces to touch there, so let "
                 "them touch in the reference positions, or stand farther apart than the "
                 "horizon",
                 nearest_of_all, scene.id);
}

/* ----------------------------------------------------------------------
   tangential coordinates of the high end in the reference
------------------------------------------------------------------------- */

template <int D> void TMSPHContactFit::set_origin(Pairing &pairing) const
{
  ContactPair &p = pairing.pair;
  double X[3], tangent[D - 1][D];
  scene.bonds->reference_vector(pairing.low, pairing.high, X);
  reference_tangents<D>(p, tangent);
  for (int t = 0; t < D - 1; t++) {
    p.origin[t] = 0.0;
    for (int a = 0; a < D; a++) p.origin[t] += tangent[t][a] * X[a];
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactFit::fit_pairs(TMSPHContactList &list)
{
  for (Pairing &pairing : list.pairings) {
    set_stiffness(pairing, scene.bonds->interior_kappa(), SHEAR_CLOSURE<D> / CLOSURE<D>,
                  CLOSURE<D>);
    if (pairing.meeting != Meeting::LATER && pairing.has_surface) set_origin<D>(pairing);
  }
  if (list.new_faces) find_surfaces<D>(list);
}

/* ----------------------------------------------------------------------
   of all pairs of families
------------------------------------------------------------------------- */

template <int D> void TMSPHContactFit::find_surfaces(TMSPHContactList &list)
{
  TMSPHGhostRows rows(2 * Moments<D>::SIZE);
  rows.fill(atom->nlocal + atom->nghost, 0.0);
  const double nearest = mark<D>(list, rows);
  ghosts.send(rows, 0, rows.columns());
  warn_if_apart(nearest);
  gather_marks<D>(list, rows);
  const std::vector<Pairing> before(list.pairings);
  for (Pairing &pairing : list.pairings) {
    if (pairing.meeting == Meeting::LATER) continue;
    fit_surface<D>(pairing, rows);
    set_origin<D>(pairing);
  }
  list.take_surfaces(before);
}

/* ----------------------------------------------------------------------
   marks of each particle, about itself: of interfaces, then of cracks
   @return distance of the nearest particles of bodies that are not bonded, in spacings
------------------------------------------------------------------------- */

template <int D>
double TMSPHContactFit::mark(const TMSPHContactList &list, TMSPHGhostRows &rows) const
{
  constexpr int SIZE = Moments<D>::SIZE;
  const FixTMSPHBond &bonds = *scene.bonds;
  double nearest = HUGE_VAL;
  for (const Member &m : list.members) {
    Moments<D> marks[2];
    for (const auto &[k, j, state] : bonds.family(m.i, scene.states())) {
      const bool interface = state == FixTMSPHBond::UNBONDED;
      double X[3], middle[D], R2 = 0.0;
      bonds.reference_vector(m.i, j, X);
      for (int a = 0; a < D; a++) {
        R2 += X[a] * X[a];
        middle[a] = 0.5 * X[a];
      }
      const double size = 0.5 * (bonds.spacing(m.i) + bonds.spacing(j)), reach = SHORT * size;
      if (R2 < reach * reach) marks[interface ? 0 : 1].add_point(middle);
      if (interface) nearest = std::min(nearest, std::sqrt(R2) / size);
    }
    std::copy_n(marks[0].m, SIZE, rows[m.i]);
    std::copy_n(marks[1].m, SIZE, rows[m.i] + SIZE);
  }
  return nearest;
}

/* ----------------------------------------------------------------------
   those around each particle: its own and its family's, in the order of ids; and once more
------------------------------------------------------------------------- */

template <int D>
void TMSPHContactFit::gather_marks(const TMSPHContactList &list, TMSPHGhostRows &rows)
{
  constexpr int SIZE = Moments<D>::SIZE;
  const FixTMSPHBond &bonds = *scene.bonds;
  const int width = rows.columns();
  const std::vector<Member> &members = list.members;
  std::vector<double> around(members.size() * width);
  for (int round = 0; round < 2; round++) {
    for (size_t n = 0; n < members.size(); n++) {
      const int i = members[n].i;
      Moments<D> sum[2];
      const auto add = [&](int j, const double *X) {
        sum[0].add(rows[j], X);
        sum[1].add(rows[j] + SIZE, X);
      };
      const double here[3] = {0.0, 0.0, 0.0};
      add(i, here);
      for (const auto &bond : bonds.family(i, FixTMSPHBond::ALL)) {
        double X[3];
        bonds.reference_vector(i, bond.j, X);
        add(bond.j, X);
      }
      std::copy_n(sum[0].m, SIZE, around.data() + n * width);
      std::copy_n(sum[1].m, SIZE, around.data() + n * width + SIZE);
    }
    for (size_t n = 0; n < members.size(); n++)
      std::copy_n(around.data() + n * width, width, rows[members[n].i]);
    ghosts.send(rows, 0, width);
  }
}

/* ----------------------------------------------------------------------
   @param rows the marks around each particle
------------------------------------------------------------------------- */

template <int D> void TMSPHContactFit::fit_surface(Pairing &pairing, const TMSPHGhostRows &rows)
{
  constexpr int SIZE = Moments<D>::SIZE;
  const FixTMSPHBond &bonds = *scene.bonds;
  const int low = pairing.low, high = pairing.high;
  const int which = pairing.meeting == Meeting::FACES ? SIZE : 0;
  ContactPair &p = pairing.pair;
  double X[3], direction[D], R2 = 0.0;
  bonds.reference_vector(low, high, X);
  if (pairing.meeting == Meeting::BODIES && surfaces.take_given<D>(low, high, X, p)) return;
  for (int a = 0; a < D; a++) R2 += X[a] * X[a];
  for (int a = 0; a < D; a++) direction[a] = X[a] / std::sqrt(R2);
  Moments<D> marks;
  std::copy_n(rows[low] + which, SIZE, marks.m);
  marks.add(rows[high] + which, X);
  const double size = 0.5 * (bonds.spacing(low) + bonds.spacing(high));
  double normal[D], centre[D], depth = 0.0;
  fit_plane<D>(marks, direction, SCATTER * size * size, normal, centre);

  p.distance = 0.0;
  for (int a = 0; a < D; a++) {
    p.normal_low[a] = p.normal_high[a] = normal[a];
    p.distance += normal[a] * X[a];
    depth += normal[a] * centre[a];
  }
  p.depth = marks.m[0] > 0.0 && p.distance > 0.0 ? std::min(1.0, std::max(0.0, depth / p.distance))
                                                 : 0.5;
}

/* ----------------------------------------------------------------------
   @param ratio   of the constants for shear and for closure
------------------------------------------------------------------------- */

void TMSPHContactFit::set_stiffness(Pairing &pairing, double kappa, double ratio,
                                    double closure) const
{
  const int low = pairing.low, high = pairing.high;
  const int *type = atom->type;
  const Elastic &one = scene.pair->elastic(low), &other = scene.pair->elastic(high);
  const auto mean = [](double a, double b) { return 2.0 * a * b / (a + b); };
  const double modulus = mean(one.lambda + 2.0 * one.shear, other.lambda + 2.0 * other.shear);
  pairing.pair.shear_ratio = ratio * mean(one.shear, other.shear) / modulus;
  pairing.pair.stiffness =
      scene.stiffness * closure * 2.0 * modulus / kappa * atom->vfrac[low] * atom->vfrac[high];
  const bool one_body = scene.pair->bonded(type[low], type[high]);
  pairing.pair.friction = one_body && !scene.rough_faces ? 0.0
                                                         : scene.friction[type[low]][type[high]];
  pairing.pair.horizon = scene.pair->horizon(type[low], type[high]);
}
