/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Principal values of a symmetric stress, tension positive, largest first.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PRINCIPAL_H
#define LMP_TMSPH_PRINCIPAL_H

#include <Eigen/Eigenvalues>

#include <cmath>

namespace TMSPH {

struct Principals {
  double largest, middle, smallest;
};

/// In the plane, from xx yy xy; the middle one is their mean.
inline Principals principals_2d(const double *s)
{
  const double mean = 0.5 * (s[0] + s[1]), half = 0.5 * (s[0] - s[1]);
  const double radius = std::sqrt(half * half + s[2] * s[2]);
  return {mean + radius, mean, mean - radius};
}

/** Mean and deviation of a stress, to bound its principal values: in the plane deviation2 is
    (S1 - S3)^2/4, in 3-D J2, where (S1 - S3)^2 <= 4 J2. */
struct Invariants {
  double mean, deviation2;
};

/// (S1 - mean)/sqrt(deviation2) is at most that: 1 in the plane, in 3-D where S2 = S3
const double REACH_3D = 2.0 / std::sqrt(3.0);

/// for a bound that must hold in spite of round-off
constexpr double BELOW_ROUNDING = 1.0 - 1.0e-12;

inline Invariants invariants_2d(const double *s)
{
  const double half = 0.5 * (s[0] - s[1]);
  return {0.5 * (s[0] + s[1]), half * half + s[2] * s[2]};
}

/// Mean and J2.
inline Invariants invariants_3d(const double *s)
{
  const double mean = (s[0] + s[1] + s[2]) / 3.0;
  const double x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
  return {mean, 0.5 * (x * x + y * y + z * z) + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]};
}

/// All three, ascending, from xx yy zz xy xz yz. Not in closed form: that loses half of the digits
/// where two of them are equal, as in each uniaxial state.
inline Eigen::Vector3d principal_values(const double *s)
{
  Eigen::Matrix3d A;
  A << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

inline Principals principals_3d(const double *s)
{
  const Eigen::Vector3d value = principal_values(s);
  return {value[2], value[1], value[0]};
}

}    // namespace TMSPH
#endif
