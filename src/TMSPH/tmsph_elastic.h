/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Elastic constants, strains and what laws of elasticity are made of. Templates
   on the dimension and on the scalar (double, or eight lanes).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_ELASTIC_H
#define LMP_TMSPH_ELASTIC_H

namespace TMSPH {

enum class Plane { STRAIN, STRESS };

/** Constants of one isotropic material in the state the body is in.
    In 3-D and plane strain lambda is Lame's constant; in plane stress E nu/(1 - nu^2). */
struct Elastic {
  double young = 0.0, poisson = 0.0;    ///< stress, -
  double lambda = 0.0, shear = 0.0;     ///< stress; lambda is that of the plane state
  double expansion = 0.0;               ///< in-plane thermal strain per degree, alpha*
  double wave_modulus = 0.0;            ///< lambda + 2 mu of 3-D: rho c_p^2
};

/** @param alpha linear expansion coefficient per degree.
    Plane strain: alpha* = (1 + nu) alpha, because the held direction pushes too. */
inline Elastic elastic_constants(int dimension, Plane plane, double young, double poisson,
                                 double alpha)
{
  Elastic m;
  m.young = young;
  m.poisson = poisson;
  m.shear = young / (2.0 * (1.0 + poisson));
  const double lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const bool plane_stress = dimension == 2 && plane == Plane::STRESS;
  m.lambda = plane_stress ? young * poisson / (1.0 - poisson * poisson) : lame;
  m.expansion = dimension == 2 && plane == Plane::STRAIN ? (1.0 + poisson) * alpha : alpha;
  m.wave_modulus = lame + 2.0 * m.shear;
  return m;
}

/// E/(1 - nu^2), of a surface that is pressed evenly
inline double plane_modulus(const Elastic &m)
{
  return m.young / (1.0 - m.poisson * m.poisson);
}

/// Square matrix of scalars T, row-major; only what the laws need.
template <int D, class T> struct Matrix {
  T a[D][D];
  T *operator[](int i) { return a[i]; }
  const T *operator[](int i) const { return a[i]; }
};

/// C = A B
template <int D, class T> inline Matrix<D, T> product(const Matrix<D, T> &A, const Matrix<D, T> &B)
{
  Matrix<D, T> C;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      T sum = A[i][0] * B[0][j];
      for (int k = 1; k < D; k++) sum += A[i][k] * B[k][j];
      C[i][j] = sum;
    }
  return C;
}

/// C = A B^T
template <int D, class T>
inline Matrix<D, T> product_transposed(const Matrix<D, T> &A, const Matrix<D, T> &B)
{
  Matrix<D, T> C;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      T sum = A[i][0] * B[j][0];
      for (int k = 1; k < D; k++) sum += A[i][k] * B[j][k];
      C[i][j] = sum;
    }
  return C;
}

/// F = I + H
template <int D, class T> inline Matrix<D, T> deformation(const Matrix<D, T> &H)
{
  Matrix<D, T> F = H;
  for (int i = 0; i < D; i++) F[i][i] = H[i][i] + 1.0;
  return F;
}

template <class T> inline T determinant(const Matrix<2, T> &A)
{
  return A[0][0] * A[1][1] - A[0][1] * A[1][0];
}

template <class T> inline T determinant(const Matrix<3, T> &A)
{
  return A[0][0] * (A[1][1] * A[2][2] - A[1][2] * A[2][1]) +
      A[0][1] * (A[1][2] * A[2][0] - A[1][0] * A[2][2]) +
      A[0][2] * (A[1][0] * A[2][1] - A[1][1] * A[2][0]);
}

/// Cofactor matrix: det(A) A^-T.
template <class T> inline Matrix<2, T> cofactor(const Matrix<2, T> &A)
{
  return {{{A[1][1], -A[1][0]}, {-A[0][1], A[0][0]}}};
}

template <class T> inline Matrix<3, T> cofactor(const Matrix<3, T> &A)
{
  Matrix<3, T> C;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      C[i][j] = A[i1][j1] * A[i2][j2] - A[i1][j2] * A[i2][j1];
    }
  return C;
}

/// cof(I + H) - I
template <class T> inline Matrix<2, T> cofactor_change(const Matrix<2, T> &H)
{
  return cofactor(H);
}

template <class T> inline Matrix<3, T> cofactor_change(const Matrix<3, T> &H)
{
  Matrix<3, T> C = cofactor(H);
  const T trace = H[0][0] + H[1][1] + H[2][2];
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) C[i][j] -= H[j][i];
    C[i][i] += trace;
  }
  return C;
}

/// det(I + H) - 1
template <class T> inline T volume_change(const Matrix<2, T> &H)
{
  return H[0][0] + H[1][1] + determinant(H);
}

template <class T> inline T volume_change(const Matrix<3, T> &H)
{
  const Matrix<3, T> C = cofactor(H);
  return H[0][0] + H[1][1] + H[2][2] + (C[0][0] + C[1][1] + C[2][2]) + determinant(H);
}

/** Green-Lagrange strain E = (F^T F - I)/2 = (H + H^T + H^T H)/2, minus the thermal strain a I.
    From H, not F: no loss of digits at small strain. */
template <int D, class T> inline Matrix<D, T> green_lagrange(const Matrix<D, T> &H, T thermal)
{
  Matrix<D, T> E;
  for (int i = 0; i < D; i++)
    for (int j = i; j < D; j++) {
      T sum = H[i][j] + H[j][i];
      for (int k = 0; k < D; k++) sum += H[k][i] * H[k][j];
      E[i][j] = E[j][i] = 0.5 * sum;
    }
  for (int i = 0; i < D; i++) E[i][i] -= thermal;
  return E;
}

/** Almansi strain e = (I - F^-T F^-1)/2 = F^-T E F^-1, minus the thermal strain a I. */
template <int D, class T> inline Matrix<D, T> almansi(const Matrix<D, T> &F, T J, T thermal)
{
  const Matrix<D, T> C = cofactor(F);    // F^-T = C/J
  const T scale = 1.0 / (J * J);
  Matrix<D, T> e = product_transposed(C, C);
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) e[i][j] = (i == j ? 0.5 : 0.0) - 0.5 * scale * e[i][j];
  for (int i = 0; i < D; i++) e[i][i] -= thermal;
  return e;
}

/// lambda tr(e) I + 2 mu e
template <int D, class T> inline Matrix<D, T> hooke(const Matrix<D, T> &e, T lambda, T shear)
{
  Matrix<D, T> s;
  T trace = e[0][0];
  for (int i = 1; i < D; i++) trace += e[i][i];
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) s[i][j] = 2.0 * shear * e[i][j];
  for (int i = 0; i < D; i++) s[i][i] += lambda * trace;
  return s;
}

/// lambda/2 tr(e)^2 + mu e:e, the energy density of hooke()
template <int D, class T> inline T hooke_energy(const Matrix<D, T> &e, T lambda, T shear)
{
  T trace = e[0][0], contraction = e[0][0] * e[0][0];
  for (int i = 1; i < D; i++) trace += e[i][i];
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++)
      if (i || j) contraction += e[i][j] * e[i][j];
  return 0.5 * lambda * trace * trace + shear * contraction;
}

/// Cauchy stress P F^T / J
template <int D, class T> inline Matrix<D, T> cauchy(const Matrix<D, T> &P, const Matrix<D, T> &F)
{
  Matrix<D, T> sigma = product_transposed(P, F);
  const T scale = 1.0 / determinant(F);
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) sigma[i][j] *= scale;
  return sigma;
}

}    // namespace TMSPH
#endif
