/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Bonds that open: a particle fits its displacement gradient to what is left
   of the relative displacements without the openings of its bonds. A bond
   that has opened by the vector c, fixed in the material, is seen by particle i
   as the jump R_i s_ij, s_ij = c_ij + e_ij, R_i the rotation of its raw fit:

     F_i    = I + (sum_j W_ij u'_ij X_ij^T) Kbar_i^-1 = R_i U_i
     H_i    = (sum_j W_ij (u'_ij - R_i s_ij) X_ij^T) Kbar_i^-1
     U_i    = V_i psi(H_i) + chi_i/2 sum_j W_ij |u'_ij - R_i s_ij - H_i X_ij|^2
     f^i_ij = W_ij {B_i X_ij + chi_i (u'_ij - R_i s_ij)},  B_i as without openings

   The faces of a crack go their own ways, and where they turn apart the jump
   that continues the gradient of one end is not that of the other. So the ends
   see two jumps. Their mean c = c_ij = -c_ji is what opens, against the cohesive
   traction, along the normal of the crack until nothing holds it; half of their difference, e = e_ij = e_ji, takes no energy and is
   where both ends pull alike.

   U_i knows no direction of space: turning the body changes nothing, and the
   forces exert no torque. The traction of the bond is the derivative by c,
   A t = R_i^T f^i_ij - R_j^T f^j_ji; that by e is the sum, which is to be zero.
   As R_i follows the displacements too, the force is that of
   B_i - R_i [p]x Kbar_i^-1, with
     m = sum_j R_i s_ij x f^i_ij,  p = (tr U I - U)^-1 R_i^T m
   (from R^T dF - dF^T R = [(tr U I - U) w]x with [w]x = R^T dR).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPEN_BOND_H
#define LMP_TMSPH_OPEN_BOND_H

#include "tmsph_cohesion.h"
#include "tmsph_elastic_law.h"

#include <Eigen/Dense>

#include <cmath>
#include <optional>
#include <vector>

namespace TMSPH {

template <int D> using Column = Eigen::Matrix<double, D, 1>;
template <int D> using SquareMatrix = Eigen::Matrix<double, D, D>;

/** What an opening bond remembers: the same numbers at both ends, but for the signs of the vectors,
    which are those to the partner. Nothing but doubles: it is stored as such. */
struct OpenBond {
  Opening opening;          ///< of the size |c|
  double area = 0.0;        ///< A of the crack that the bond stands for
  double patience = 0.0;    ///< updates until leaving the fit is tried again
  double leaves = 0.0;      ///< 1: the next step begins without it
  double settled = 0.0;     ///< largest opening before the present step, or search for equilibrium
  double normal[3] = {};    ///< N of the crack, N.X > 0
  double jump[3] = {};      ///< c, N.c >= 0
  double uneven[3] = {};    ///< e, of the same sign at both ends
};
constexpr int OPEN_BOND_SIZE = sizeof(OpenBond) / sizeof(double);

/** A bond as the fit of one of its ends sees it. */
template <int D> struct FitBond {
  Column<D> X, u;    ///< u' with the thermal strain taken off
  double weight;
  Column<D> jump;    ///< s
  int place;         ///< in the family
  int partner;       ///< index of the other end
  int number;        ///< of the opening among those of the particle; -1: it has none, s is 0
  bool open() const { return number >= 0; }
};

/** The rotation R of F = R U, and what its derivative needs. */
template <int D> struct Polar {
  SquareMatrix<D> rotation, stretch;

  explicit Polar(const SquareMatrix<D> &F)
  {
    if constexpr (D == 2) {
      const double c = F(0, 0) + F(1, 1), s = F(1, 0) - F(0, 1), size = std::sqrt(c * c + s * s);
      rotation << c / size, -s / size, s / size, c / size;
    } else {
      const Eigen::JacobiSVD<SquareMatrix<D>> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
      SquareMatrix<D> turned = svd.matrixU();
      if ((turned * svd.matrixV().transpose()).determinant() < 0.0) turned.col(D - 1) *= -1.0;
      rotation = turned * svd.matrixV().transpose();
    }
    stretch = rotation.transpose() * F;
  }

  /// R [p]x of the moment m that acts on the rotation; in the plane only m[2]
  SquareMatrix<D> of_moment(const Eigen::Vector3d &m) const
  {
    SquareMatrix<D> skew;
    if constexpr (D == 2) {
      const double p = m[2] / stretch.trace();
      skew << 0.0, -p, p, 0.0;
    } else {
      const SquareMatrix<D> follows = stretch.trace() * SquareMatrix<D>::Identity() - stretch;
      const Column<D> p = follows.inverse() * (rotation.transpose() * m);
      skew << 0.0, -p[2], p[1], p[2], 0.0, -p[0], -p[1], p[0], 0.0;
    }
    return rotation * skew;
  }
};

template <int D> inline Eigen::Vector3d cross(const Column<D> &a, const Column<D> &b)
{
  if constexpr (D == 3)
    return a.cross(b);
  else
    return {0.0, 0.0, a[0] * b[1] - a[1] * b[0]};
}

template <int D> inline Matrix<D, double> plain(const SquareMatrix<D> &A)
{
  Matrix<D, double> result;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) result[i][j] = A(i, j);
  return result;
}

template <int D> inline SquareMatrix<D> dense(const Matrix<D, double> &A)
{
  SquareMatrix<D> result;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) result(i, j) = A[i][j];
  return result;
}

/** A particle with openings, and what its fit is made of. */
template <int D> struct OpenFit {
  std::vector<FitBond<D>> bonds;
  SquareMatrix<D> shape_inverse;        ///< Kbar^-1; 0: singular
  double volume, lambda, shear, chi;    ///< of this particle
  double heating, thermal;              ///< thermal strain, and what of it the law takes off

  // results of see(): of the displacements alone

  SquareMatrix<D> raw;     ///< sum W u' X^T
  SquareMatrix<D> seen;    ///< gradient of the displacements with all jumps
  std::optional<Polar<D>> polar;

  SquareMatrix<D> jumps;    ///< sum W s X^T, of take_jumps() or of updates

  // of respond(): with these jumps

  SquareMatrix<D> H, P;    ///< elastic gradient, first Piola-Kirchhoff stress
  SquareMatrix<D> B;       ///< of f^i above

  // of complete()

  SquareMatrix<D> B_turning;    ///< B with the derivative of the rotation
  double energy;                ///< U_i

  const SquareMatrix<D> &rotation() const { return polar->rotation; }
  /// T of updates
  SquareMatrix<D> back() const { return rotation().transpose() * B; }

  template <class Law> SquareMatrix<D> piola(Law, const SquareMatrix<D> &gradient) const
  {
    return dense<D>(Law::first_piola(plain<D>(gradient), lambda, shear, thermal));
  }

  void see()
  {
    raw.setZero();
    for (const auto &b : bonds) raw += b.weight * b.u * b.X.transpose();
    seen = raw * shape_inverse;
    polar.emplace(SquareMatrix<D>::Identity() + seen);
  }

  void take_jumps()
  {
    jumps.setZero();
    for (const auto &b : bonds)
      if (b.open()) jumps += b.weight * b.jump * b.X.transpose();
  }

  template <class Law> void respond(Law law)
  {
    H = (raw - rotation() * jumps) * shape_inverse;
    P = piola(law, H);
    B = volume * P * shape_inverse - chi * H;
  }

  template <class Law> void complete(Law)
  {
    double misfit = 0.0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const auto &b : bonds) {
      Column<D> left = b.u;
      if (b.open()) {
        const Column<D> jump = rotation() * b.jump;
        left -= jump;
        moment += cross<D>(jump, b.weight * (B * b.X + chi * left));
      }
      misfit += b.weight * (left - H * b.X).squaredNorm();
    }
    B_turning = B - polar->of_moment(moment) * shape_inverse;
    energy = volume * Law::energy(plain<D>(H), lambda, shear, thermal) + 0.5 * chi * misfit;
  }

  /// all but see(), which the displacements alone change
  template <class Law> void react(Law law)
  {
    respond(law);
    complete(law);
  }

  template <class Law> void evaluate(Law law)
  {
    see();
    take_jumps();
    react(law);
  }
};

}    // namespace TMSPH
#endif
