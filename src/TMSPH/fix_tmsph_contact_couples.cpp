/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Contact forces off the line between two particles turn the pair. The bonds of
   both ends balance that in the same step, in the present positions, so that
   angular momentum is kept to round-off.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"

#include <Eigen/Dense>
#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

template <int D> using Vector = Eigen::Matrix<double, D, 1>;
template <int D> using Square = Eigen::Matrix<double, D, D>;

// bonds are crushed flat where the determinant of their tensor is a smaller part of the cube (in
// 2-D the square) of its mean eigenvalue

static constexpr double FLAT = 0.01;

/* ----------------------------------------------------------------------
   S such that forces W_ij S x_ij on the partners have the moments S M = T. Where the bonds are crushed
   flat they turn as if they were rigid, S = [w] with the same couple c = (tr M - M) w.
   @param M sum of W_ij x_ij x_ij^T
   @param T sum of f x to be exerted
------------------------------------------------------------------------- */

template <int D> static Square<D> balance(const Square<D> &M, const Square<D> &T)
{
  const double mean = M.trace() / D, flat = D == 2 ? FLAT * mean * mean : FLAT * mean * mean * mean;
  if (M.determinant() > flat) return T * M.inverse();
  Eigen::Matrix3d inertia = M.trace() * Eigen::Matrix3d::Identity();
  if constexpr (D == 3) inertia -= M;
  const Eigen::Matrix<double, D, D, Eigen::RowMajor> moments = T;
  Eigen::Vector3d couple;
  couple_of<D>(moments.data(), couple.data());
  const Eigen::Vector3d w = inertia.inverse() * couple;
  Eigen::Matrix3d turn;
  turn << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
  return turn.topLeftCorner<D, D>();
}

/* ----------------------------------------------------------------------
   local particles with a bond to a particle with contacts, which may be a ghost
------------------------------------------------------------------------- */

void FixTMSPHContact::find_bearers()
{
  width = 1;
  rows.assign(atom->nlocal + atom->nghost, 0.0);
  for (const Member &m : members) rows[m.i] = 1.0;
  send(0, width);
  bearers.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    bool bears = rows[i] != 0.0;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE))
      bears = bears || rows[bond.j] != 0.0;
    if (bears) bearers.push_back(i);
  }
}

/* ----------------------------------------------------------------------
   each particle gathers from its bonds, in the order of the partners' ids
   @param anew the stress of contacts does not know that of these forces yet
------------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::balance_couples(bool anew)
{
  constexpr int TOUCHES = D * D;    // column, behind S
  const Slices &layout = bonds->layout();
  const auto each_bond = [&](int i, auto use) {
    for (int k = 0; k < bonds->count(i); k++) {
      const size_t at = layout.at(i / WIDTH, i % WIDTH, k);
      const double weight = layout.weight[at];
      if (weight == 0.0) continue;
      const int j = layout.partner[at];
      Vector<D> x;
      for (int a = 0; a < D; a++) x[a] = atom->x[j][a] - atom->x[i][a];
      use(j, weight, x);
    }
  };

  width = D * D + 1;
  rows.assign((size_t) width * (atom->nlocal + atom->nghost), 0.0);
  const auto row = [this](int i) { return rows.data() + (size_t) width * i; };
  const auto S = [row](int i) { return Eigen::Map<Square<D>>(row(i)); };
  for (const Member &m : members) {
    row(m.i)[TOUCHES] = 1.0;
    const Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>> tilt(m.memory->tilt);
    if (tilt.isZero(0.0)) continue;
    Square<D> moment = Square<D>::Zero();
    each_bond(m.i, [&](int, double weight, const Vector<D> &x) {
      moment += weight * x * x.transpose();
    });
    S(m.i) = balance<D>(moment, tilt);
  }
  send(0, width);

  for (const int i : bearers) {
    Vector<D> force = Vector<D>::Zero();
    each_bond(i, [&](int j, double weight, const Vector<D> &x) {
      force -= weight * ((S(i) + S(j)) * x);
    });
    for (int a = 0; a < D; a++) atom->f[i][a] += force[a];
  }

  // one half of the virial of a bond to each end that keeps it

  for (const Member &m : members) {
    if (!anew) break;
    Square<D> virial = Square<D>::Zero();
    each_bond(m.i, [&](int j, double weight, const Vector<D> &x) {
      const double own = row(j)[TOUCHES] != 0.0 ? 0.5 : 1.0;
      virial += weight * ((own * S(m.i) + 0.5 * S(j)) * x) * x.transpose();
    });
    const double scale = 0.5 / atom->vfrac[m.i];
    for (int a = 0; a < D; a++)
      for (int b = a; b < D; b++)
        m.memory->stress[a == b ? a : a + b + 2] -= scale * (virial(a, b) + virial(b, a));
  }
}

// for fix_tmsph_contact.cpp

template void FixTMSPHContact::balance_couples<2>(bool);
template void FixTMSPHContact::balance_couples<3>(bool);
