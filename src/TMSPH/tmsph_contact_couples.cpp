/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Bonds balance the couples of contact forces.
------------------------------------------------------------------------- */

#include "tmsph_contact_couples.h"

#include "atom.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Member = TMSPHContactList::Member;

template <int D> using Vector = Eigen::Matrix<double, D, 1>;
template <int D> using Square = Eigen::Matrix<double, D, D>;

// bonds are crushed flat where the determinant of their tensor is a smaller part of the cube (in
// 2-D the square) of its norm: a lattice has 1, the side of one that is compressed to a tenth still
// 0.04; 1e-4 to 0.1 do the same in unittest/verification/test_fragments.py

static constexpr double FLAT = 0.01;

/* ----------------------------------------------------------------------
   S such that forces W_ij S X_ij on the partners have the moments sum f x = T. They do the work
   T : dF F^-1 on any motion of the partners, as F = sum W x X^T K^-1 and G = K F^T. Where the bonds
   are crushed flat, or inside out, they turn as if they were rigid: S X is w x (R X) with the
   rotation R of F and the same couple c = (tr R G - R G) w.
   @param G sum of W_ij X_ij x_ij^T
   @param T sum of f x to be exerted
------------------------------------------------------------------------- */

template <int D> static Square<D> solve(const Square<D> &G, const Square<D> &T)
{
  if (G.determinant() > FLAT * std::pow(G.norm() / std::sqrt(D), D)) return T * G.inverse();
  const Eigen::JacobiSVD<Square<D>> svd(G.transpose(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  Square<D> U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0.0) U.col(D - 1) *= -1.0;
  const Square<D> R = U * svd.matrixV().transpose(), A = R * G;
  Eigen::Matrix3d inertia = A.trace() * Eigen::Matrix3d::Identity();
  if constexpr (D == 3) inertia -= A;
  const Eigen::Matrix<double, D, D, Eigen::RowMajor> moments = T;
  Eigen::Vector3d couple;
  couple_of<D>(moments.data(), couple.data());
  const Eigen::Vector3d w = inertia.inverse() * couple;
  Eigen::Matrix3d turn;
  turn << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
  return turn.topLeftCorner<D, D>() * R;
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
  bearers_known = true;
}

/* ----------------------------------------------------------------------
   calls use(j, weight, X) for the bonds of i that hold, in the order of the partners' ids;
   X joins the reference positions
------------------------------------------------------------------------- */

template <int D, class Use> static inline void each_bond(const FixTMSPHBond &bonds, int i, Use use)
{
  const Slices &layout = bonds.layout();
  const double *const here = bonds.reference(i);
  for (int k = 0; k < bonds.count(i); k++) {
    const size_t at = layout.at(i, k);
    const double weight = layout.weight[at];
    if (weight == 0.0) continue;
    const int j = layout.partner[at];
    const double *const there = bonds.reference(j);
    Vector<D> X;
    for (int a = 0; a < D; a++) X[a] = there[a] - here[a];
    use(j, weight, X);
  }
}

template <int D> static Vector<D> between(const double *from, const double *to)
{
  Vector<D> x;
  for (int a = 0; a < D; a++) x[a] = to[a] - from[a];
  return x;
}

/* ----------------------------------------------------------------------
   rows as the sweeps read them
------------------------------------------------------------------------- */

template <int D> class Couples {
 public:
  static constexpr int TOUCHES = D * D, PRESSES = TOUCHES + 1, SIZE = PRESSES + 1;
  explicit Couples(const double *first) : first(first) {}
  Eigen::Map<const Square<D>> S(int i) const
  {
    return Eigen::Map<const Square<D>>(first + (size_t) SIZE * i);
  }
  bool touches(int i) const { return first[(size_t) SIZE * i + TOUCHES] != 0.0; }
  /// else S is 0
  bool presses(int i) const { return first[(size_t) SIZE * i + PRESSES] != 0.0; }

 private:
  const double *const first;
};

/* ---------------------------------------------------------------------- */

static bool is_zero(const double (&tilt)[9])
{
  return std::all_of(tilt, tilt + 9, [](double one) { return one == 0.0; });
}

bool TMSPHContactCouples::any_tilt() const
{
  int mine = 0, any;
  for (const Member &m : list.members) mine = mine || !is_zero(list.memory(m).tilt);
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactCouples::balance(bool anew)
{
  if (!any_tilt()) return;
  if (!bearers_known) find_bearers();
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
    if (is_zero(list.memory(m).tilt)) continue;
    const Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>> tilt(list.memory(m).tilt);
    rows[m.i][Couples<D>::PRESSES] = 1.0;
    Square<D> moment = Square<D>::Zero();
    each_bond<D>(*scene.bonds, m.i, [&](int j, double weight, const Vector<D> &X) {
      moment += weight * X * between<D>(atom->x[m.i], atom->x[j]).transpose();
    });
    Eigen::Map<Square<D>> S(rows[m.i]);
    S = solve<D>(moment, tilt);
  }
}

/* ----------------------------------------------------------------------
   false if no bond of a particle bears anything
------------------------------------------------------------------------- */

template <int D> static bool near_presses(const Couples<D> &all, const FixTMSPHBond &bonds, int i)
{
  if (all.presses(i)) return true;
  const Slices &layout = bonds.layout();
  for (int k = 0; k < bonds.count(i); k++)
    if (all.presses(layout.partner[layout.at(i, k)])) return true;
  return false;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactCouples::add_forces() const
{
  const Couples<D> sent(rows[0]);
  for (const int i : bearers) {
    if (!near_presses(sent, *scene.bonds, i)) continue;
    Vector<D> force = Vector<D>::Zero();
    each_bond<D>(*scene.bonds, i, [&](int j, double weight, const Vector<D> &X) {
      force -= weight * ((sent.S(i) + sent.S(j)) * X);
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
    if (!near_presses(sent, *scene.bonds, m.i)) continue;
    Square<D> virial = Square<D>::Zero();
    each_bond<D>(*scene.bonds, m.i, [&](int j, double weight, const Vector<D> &X) {
      const double own = sent.touches(j) ? 0.5 : 1.0;
      virial += weight * ((own * sent.S(m.i) + 0.5 * sent.S(j)) * X) *
          between<D>(atom->x[m.i], atom->x[j]).transpose();
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
