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
   S such that forces W_ij S x_ij on the partners exert the couple c together: the skew stress
   S M = [c]/2 has no part in the virial and does no work in a change of shape. Where the bonds are
   crushed flat they turn as if they were rigid, S = [w] with c = (tr M - M) w.
   @param M sum of W_ij x_ij x_ij^T
------------------------------------------------------------------------- */

template <int D> static Square<D> balance(const Square<D> &M, const double *couple)
{
  const auto cross = [](const double *c) {
    Square<D> C = Square<D>::Zero();
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++)
        if (a != b) C(a, b) = (b - a + 3) % 3 == 1 ? -c[3 - a - b] : c[3 - a - b];
    return C;
  };
  const double mean = M.trace() / D, flat = D == 2 ? FLAT * mean * mean : FLAT * mean * mean * mean;
  if (M.determinant() > flat) return 0.5 * cross(couple) * M.inverse();
  const Eigen::Map<const Eigen::Vector3d> c(couple);
  Eigen::Matrix3d inertia = M.trace() * Eigen::Matrix3d::Identity();
  if constexpr (D == 3) inertia -= M;
  const Eigen::Vector3d turn = inertia.inverse() * c;
  return cross(turn.data());
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
    for (int k = 0; k < bonds->count(i) && !bears; k++)
      bears = rows[bonds->partner_index(i, k)] != 0.0 &&
          bonds->bond_state(i, k) == FixTMSPHBond::INTACT;
    if (bears) bearers.push_back({i, rows[i] != 0.0 ? &memories[atom->tag[i]] : nullptr});
  }
}

/* ----------------------------------------------------------------------
   each particle gathers from its bonds, in the order of the partners' ids
------------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::balance_couples()
{
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

  width = D * D;
  rows.assign((size_t) width * (atom->nlocal + atom->nghost), 0.0);
  const auto row = [this](int i) {
    return Eigen::Map<Square<D>>(rows.data() + (size_t) width * i);
  };
  for (const Member &m : members) {
    const double *couple = m.memory->couple;
    if ((couple[0] == 0.0 && couple[1] == 0.0 && couple[2] == 0.0) || !pair->bears_stress<D>(m.i))
      continue;
    Square<D> moment = Square<D>::Zero();
    each_bond(m.i, [&](int, double weight, const Vector<D> &x) {
      moment += weight * x * x.transpose();
    });
    row(m.i) = balance<D>(moment, couple);
  }
  send(0, width);

  for (const Bearer &bearer : bearers) {
    const int i = bearer.i;
    Vector<D> force = Vector<D>::Zero();
    each_bond(i, [&](int j, double weight, const Vector<D> &x) {
      force -= weight * ((row(i) + row(j)) * x);
    });
    for (int a = 0; a < D; a++) atom->f[i][a] += force[a];
    if (bearer.memory) std::copy_n(force.data(), D, bearer.memory->balance);
  }
}

// for fix_tmsph_contact.cpp

template void FixTMSPHContact::balance_couples<2>();
template void FixTMSPHContact::balance_couples<3>();
