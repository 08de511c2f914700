/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Bonds that open: a particle fits its displacement gradient to what is left
   of the relative displacements without the openings of its bonds. A bond
   that has opened by c along the normal N, fixed in the material, is seen by
   particle i as the jump c R_i N, R_i the rotation of its raw fit:

     F_i    = I + (sum_j W_ij u'_ij X_ij^T) Kbar_i^-1 = R_i U_i
     H_i    = (sum_j W_ij (u'_ij - c_ij R_i N_ij) X_ij^T) Kbar_i^-1
     U_i    = V_i psi(H_i) + chi_i/2 sum_j W_ij |u'_ij - c_ij R_i N_ij - H_i X_ij|^2
     f^i_ij = W_ij {B_i X_ij + chi_i (u'_ij - c_ij R_i N_ij)},  B_i as without openings

   U_i knows no direction of space: turning the body changes nothing, and the
   forces exert no torque. The traction of the bond is the derivative by c of
   both ends, A t = f^i.R_i N + f^j.R_j N. As R_i follows the displacements too,
   the force is that of B_i - R_i [p]x Kbar_i^-1, with
     m = sum_j c_ij R_i N_ij x f^i_ij,  p = (tr U I - U)^-1 R_i^T m
   (from R^T dF - dF^T R = [(tr U I - U) w]x with [w]x = R^T dR).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPEN_BOND_H
#define LMP_TMSPH_OPEN_BOND_H

#include "tmsph_cohesion.h"
#include "tmsph_elastic_law.h"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace TMSPH {

template <int D> using Column = Eigen::Matrix<double, D, 1>;
template <int D> using SquareMatrix = Eigen::Matrix<double, D, D>;

/** What an opening bond remembers: the same numbers at both ends, but for the sign of the normal,
    which points to the partner. Nothing but doubles: it is stored as such. */
struct OpenBond {
  Opening opening;
  double area = 0.0;        ///< A of the crack that the bond stands for
  double patience = 0.0;    ///< updates until leaving the fit is tried again
  double leaves = 0.0;      ///< 1: the next step begins without it
  double settled = 0.0;     ///< largest opening before the present search for equilibrium
  double normal[3] = {};    ///< N
};
constexpr int OPEN_BOND_SIZE = sizeof(OpenBond) / sizeof(double);

/** A bond as the fit of one of its ends sees it. */
template <int D> struct FitBond {
  Column<D> X, u;    ///< u' with the thermal strain taken off
  double weight;
  double open;         ///< c, 0 where nothing opens
  Column<D> normal;    ///< N
  int place;           ///< number in the family
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

  // results of evaluate()

  SquareMatrix<D> rotation;     ///< R
  SquareMatrix<D> seen;         ///< gradient of the displacements with all jumps
  SquareMatrix<D> H, P;         ///< elastic gradient, first Piola-Kirchhoff stress
  SquareMatrix<D> B;            ///< of f^i above
  SquareMatrix<D> B_turning;    ///< and with the derivative of the rotation
  double energy;                ///< U_i

  template <class Law> SquareMatrix<D> piola(Law, const SquareMatrix<D> &gradient) const
  {
    return dense<D>(Law::first_piola(plain<D>(gradient), lambda, shear, thermal));
  }

  template <class Law> void evaluate(Law law)
  {
    const SquareMatrix<D> identity = SquareMatrix<D>::Identity();
    SquareMatrix<D> raw = SquareMatrix<D>::Zero(), jumps = raw;
    for (const auto &b : bonds) raw += b.weight * b.u * b.X.transpose();
    seen = raw * shape_inverse;
    const Polar<D> polar(identity + seen);
    rotation = polar.rotation;
    for (const auto &b : bonds)
      if (b.open != 0.0) jumps += (b.weight * b.open) * (rotation * b.normal) * b.X.transpose();
    H = (raw - jumps) * shape_inverse;
    P = piola(law, H);
    B = volume * P * shape_inverse - chi * H;
    double misfit = 0.0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (const auto &b : bonds) {
      Column<D> left = b.u;
      if (b.open != 0.0) {
        const Column<D> jump = b.open * (rotation * b.normal);
        left -= jump;
        moment += cross<D>(jump, b.weight * (B * b.X + chi * left));
      }
      misfit += b.weight * (left - H * b.X).squaredNorm();
    }
    B_turning = B - polar.of_moment(moment) * shape_inverse;
    energy = volume * Law::energy(plain<D>(H), lambda, shear, thermal) + 0.5 * chi * misfit;
  }
};

/** f^i.R_i N of one end: its part of A t. Both ends of a bond on whatever processors compute both
    parts; compiled once, it rounds the same from both sides.
    @param R, B row-major, of the end
    @param X, u, N, W, c of the bond as this end sees it */
template <int D>
[[gnu::noinline]] double end_traction(const double *R, const double *B, double chi, const double *X,
                                      const double *u, const double *N, double W, double c)
{
  double traction = 0.0;
  for (int i = 0; i < D; i++) {
    double n = 0.0, f = 0.0;
    for (int j = 0; j < D; j++) {
      n += R[D * i + j] * N[j];
      f += B[D * i + j] * X[j];
    }
    traction += n * (f + chi * (u[i] - c * n));
  }
  return W * traction;
}

}    // namespace TMSPH
#endif
