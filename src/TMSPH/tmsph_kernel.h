/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Smoothing kernels with support radius delta (the horizon), in 2-D and 3-D.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_KERNEL_H
#define LMP_TMSPH_KERNEL_H

#include <cmath>

namespace TMSPH {

enum class Kernel { WENDLAND, CUBIC, QUINTIC };

/** Support of a kernel in smoothing lengths h: Wendland C2 and cubic spline 2, quintic spline 3. */
inline double support_in_smoothing_lengths(Kernel kernel)
{
  return kernel == Kernel::QUINTIC ? 3.0 : 2.0;
}

/** sigma of W = sigma f(R/h)/h^dimension, f as in kernel_value(). */
inline double kernel_normalization(Kernel kernel, int dimension)
{
  constexpr double PI = 3.14159265358979323846;
  switch (kernel) {
    case Kernel::WENDLAND:
      return dimension == 2 ? 7.0 / (4.0 * PI) : 21.0 / (16.0 * PI);
    case Kernel::CUBIC:
      return dimension == 2 ? 10.0 / (7.0 * PI) : 1.0 / PI;
    default:
      return dimension == 2 ? 7.0 / (478.0 * PI) : 1.0 / (120.0 * PI);
  }
}

/** w(R) = -W'(R)/R >= 0, so that grad_{X_i} W_ij = w (X_j - X_i).

    @param dimension 2 or 3
    @param R         reference distance, 0 < R
    @param delta     support radius, where W vanishes
    @return          w in 1/length^(dimension+2); zero from delta on

    Wendland C2: Wendland, Adv. Comput. Math. 4 (1995) 389; splines: Monaghan, Rep. Prog. Phys. 68
    (2005) 1703. */
inline double kernel_slope(Kernel kernel, int dimension, double R, double delta)
{
  if (R >= delta) return 0.0;
  const double h = delta / support_in_smoothing_lengths(kernel), q = R / h;
  const double length = dimension == 2 ? h * h : h * h * h;
  const double sigma = kernel_normalization(kernel, dimension);
  double slope;    // -f'(q)
  switch (kernel) {
    case Kernel::WENDLAND: {
      const double c = 1.0 - 0.5 * q;
      slope = 5.0 * q * c * c * c;
      break;
    }
    case Kernel::CUBIC:
      slope = q < 1.0 ? 3.0 * q - 2.25 * q * q : 0.75 * (2.0 - q) * (2.0 - q);
      break;
    default: {
      const auto fourth = [](double x) { return x > 0.0 ? x * x * x * x : 0.0; };
      slope = 5.0 * (fourth(3.0 - q) - 6.0 * fourth(2.0 - q) + 15.0 * fourth(1.0 - q));
    }
  }
  return sigma * slope / (length * h * R);
}

/** The kernel W(R) itself, in 1/length^dimension; from the same sources.

    @param R 0 <= R */
inline double kernel_value(Kernel kernel, int dimension, double R, double delta)
{
  if (R >= delta) return 0.0;
  const double h = delta / support_in_smoothing_lengths(kernel), q = R / h;
  const double length = dimension == 2 ? h * h : h * h * h;
  const auto power = [](double x, int n) {
    double p = 1.0;
    for (; n > 0 && x > 0.0; n--) p *= x;
    return x > 0.0 ? p : 0.0;
  };
  const double scale = kernel_normalization(kernel, dimension) / length;
  switch (kernel) {
    case Kernel::WENDLAND:
      return scale * power(1.0 - 0.5 * q, 4) * (1.0 + 2.0 * q);
    case Kernel::CUBIC:
      return scale * 0.25 * (power(2.0 - q, 3) - 4.0 * power(1.0 - q, 3));
    default:
      return scale *
          (power(3.0 - q, 5) - 6.0 * power(2.0 - q, 5) + 15.0 * power(1.0 - q, 5));
  }
}

}    // namespace TMSPH
#endif
