/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Conductances of bonds and of surfaces.

   rho c V_i dT_i/dt = sum_j G_ij (T_j - T_i), with W_ij = V_i V_j w_ij and e
   the unit vector of the bond,
     G_ij = (c_i + c_j) W_ij h(k_i(e), k_j(e)),   c = D/sum_j V_j w R^2,
   h the harmonic mean, two half bonds in series, or, across an interface of
   two materials, both parts in series in proportion to the depths below it. A
   linear field on a regular lattice then has the exact flux. Cleary and
   Monaghan, J. Comput. Phys. 148 (1999) 227, have the pair form; c and what
   follows are of this package.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONDUCTION_H
#define LMP_TMSPH_CONDUCTION_H

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace TMSPH {

inline double harmonic_mean(double a, double b)
{
  return a + b > 0.0 ? 2.0 * (a * b) / (a + b) : 0.0;
}

/// Two layers of different conductivity and thickness in series, as one; the same for equal ones.
inline double in_series(double a, double thickness_a, double b, double thickness_b)
{
  return (thickness_a + thickness_b) / (thickness_a / a + thickness_b / b);
}

/** Conductivity of bonds in an anisotropic solid,
      k(e) = (e K^-1 e)^(-(D+2)/2) det(K)^(-1/2).
    Its mean over all directions, D <k(e) e e^T>, is K: with the ellipsoid e K^-1 e = 1 the integral
    is that of a sphere. It is positive for any K, other than the linear form A e K e - B tr K that
    has the same mean: no temperature can leave the range of its neighbors. */
template <int D> class DirectionalConductivity {
 public:
  using Tensor = Eigen::Matrix<double, D, D>;
  using Vector = Eigen::Matrix<double, D, 1>;

  DirectionalConductivity() = default;
  /// @param K symmetric, positive definite
  explicit DirectionalConductivity(const Tensor &K) :
      inverse(K.inverse()), factor(1.0 / std::sqrt(K.determinant()))
  {
  }
  /// @param e of unit length
  double operator()(const Vector &e) const
  {
    const double q = e.dot(inverse * e);
    return factor / (D == 2 ? q * q : q * q * std::sqrt(q));
  }

 private:
  Tensor inverse = Tensor::Identity();
  double factor = 1.0;
};

/** A surface is some way outside the centres of the particles that carry its area A: the exchange
    of a particle d below it with what is outside.
    @return conductance g of the power g (T_outside - T_i) */
inline double surface_conductance(double conductivity, double area, double depth)
{
  return conductivity * area / depth;
}

/// The same with a film coefficient h (power per area and degree) in series.
inline double film_conductance(double conductivity, double area, double depth, double film)
{
  return film > 0.0 ? area / (depth / conductivity + 1.0 / film) : 0.0;
}

/** Radiation as a film: sigma eps (Tout^4 - T^4) = h (Tout - T).
    @param strength sigma eps, power per area and degree^4
    @param zero     the temperature of absolute zero on the scale in use */
inline double radiation_film(double strength, double T, double outside, double zero)
{
  const double a = T - zero, b = outside - zero;
  return strength * (a * a + b * b) * (a + b);
}

}    // namespace TMSPH
#endif
