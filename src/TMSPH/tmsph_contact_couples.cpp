/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Bonds balance the couples of contact forces.
------------------------------------------------------------------------- */

#include "tmsph_contact_couples.h"

#include "atom.h"

#include <Eigen/Dense>
#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Member = TMSPHContactList::Member;

template <int D> using Vector = Eigen::Matrix<double, D, 1>;
template <int D> using Square = Eigen::Matrix<double, D, D>;

// bonds are crushed flat where the determinant of their tensor is a smaller part of the cube (in
// 2-D the square) of its mean eigenvalue: a lattice has 1, the side of one that is compressed to a
// tenth still 0.04; 1e-4 to 0.1 do the same in unittest/verification/test_fragments.py

static constexpr double FLAT = 0.01;

/* ----------------------------------------------------------------------
   S such that forces W_ij S x_ij on the partners have the moments S M = T. Where the bonds are
   crushed flat they turn as if they were rigid, S = [w] with the same couple c = (tr M - M) w.
   @param M sum of W_ij x_ij x_ij^T
   @param T sum of f x to be exerted
------------------------------------------------------------------------- */

template <int D> static Square<D> solve(const Square<D> &M, const Square<D> &T)
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
   a bond to a particle with contacts, which may be a ghost, is enough
------------------------------------------------------------------------- */

void TMSPHContactCouples::find_bearers()
{
  rows.set_columns(1);
  rows.fill(atom->nlocal + atom->nghost, 0.0);
  for (const Member &m : list.members) *rows[m.i] = 1.0;
  ghosts.send(rows, 0, 1);
  bearers.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    bool bears = *rows[i] != 0.0;
    for (const auto &bond : scene.bonds->family(i, FixTMSPHBond::WHOLE))
      bears = bears || *rows[bond.j] != 0.0;
    if (bears) bearers.push_back(i);
  }
}

/* ----------------------------------------------------------------------
   calls use(j, weight, x) for the bonds of i that hold, in the order of the partners' ids
------------------------------------------------------------------------- */

template <int D, class Use>
static inline void each_bond(const FixTMSPHBond &bonds, const double *const *positions, int i,
                             Use use)
{
  const Slices &layout = bonds.layout();
  const double *here = positions[i];
  for (int k = 0; k < bonds.count(i); k++) {
    const size_t at = layout.at(i, k);
    const double weight = layout.weight[at];
    if (weight == 0.0) continue;
    const int j = layout.partner[at];
    Vector<D> x;
    for (int a = 0; a < D; a++) x[a] = positions[j][a] - here[a];
    use(j, weight, x);
  }
}

/* ----------------------------------------------------------------------
   rows as the sweeps read them
------------------------------------------------------------------------- */

template <int D> class Couples {
 public:
  static constexpr int TOUCHES = D * D, SIZE = TOUCHES + 1;    // a column behind S
  explicit Couples(const double *first) : first(first) {}
  Eigen::Map<const Square<D>> S(int i) const
  {
    return Eigen::Map<const Square<D>>(first + (size_t) SIZE * i);
  }
  bool touches(int i) const { return first[(size_t) SIZE * i + TOUCHES] != 0.0; }

 private:
  const double *const first;
};

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactCouples::balance(bool anew)
{
  rows.set_columns(Couples<D>::SIZE);
  rows.fill(atom->nlocal + atom->nghost, 0.0);
  fill_rows<D>();
  ghosts.send(rows, 0, rows.columns());
  add_forces<D>();
  if (anew) add_stress<D>();
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactCouples::fill_rows()
{
  for (const Member &m : list.members) {
    rows[m.i][Couples<D>::TOUCHES] = 1.0;
    const Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>> tilt(list.memory(m).tilt);
    if (tilt.isZero(0.0)) continue;
    Square<D> moment = Square<D>::Zero();
    each_bond<D>(*scene.bonds, atom->x, m.i, [&](int, double weight, const Vector<D> &x) {
      moment += weight * x * x.transpose();
    });
    Eigen::Map<Square<D>> S(rows[m.i]);
    S = solve<D>(moment, tilt);
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactCouples::add_forces() const
{
  const Couples<D> sent(rows[0]);
  for (const int i : bearers) {
    Vector<D> force = Vector<D>::Zero();
    each_bond<D>(*scene.bonds, atom->x, i, [&](int j, double weight, const Vector<D> &x) {
      force -= weight * ((sent.S(i) + sent.S(j)) * x);
    });
    for (int a = 0; a < D; a++) atom->f[i][a] += force[a];
  }
}

/* ----------------------------------------------------------------------
   one half of the virial of a bond to each end that keeps it
------------------------------------------------------------------------- */

template <int D> void TMSPHContactCouples::add_stress()
{
  const Couples<D> sent(rows[0]);
  for (const Member &m : list.members) {
    Square<D> virial = Square<D>::Zero();
    each_bond<D>(*scene.bonds, atom->x, m.i, [&](int j, double weight, const Vector<D> &x) {
      const double own = sent.touches(j) ? 0.5 : 1.0;
      virial += weight * ((own * sent.S(m.i) + 0.5 * sent.S(j)) * x) * x.transpose();
    });
    const double scale = 0.5 / atom->vfrac[m.i];
    double *stress = list.memory(m).stress;
    for (int a = 0; a < D; a++)
      for (int b = a; b < D; b++)
        stress[a == b ? a : a + b + 2] -= scale * (virial(a, b) + virial(b, a));
  }
}

// for fix_tmsph_contact.cpp

template void TMSPHContactCouples::balance<2>(bool);
template void TMSPHContactCouples::balance<3>(bool);
