/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Smoothing kernels with support radius delta (the horizon), in 2-D and 3-D:
   W(R) = scale f(q), q = R/h, scale = norm/h^dimension. A kernel is a struct
     NAME                 the word of pair_style tmsph kernel
     SUPPORT              delta/h
     norm(dimension)      so that the integral of W over all space is 1
     value(scale, q)      scale f(q), 0 <= q < SUPPORT
     slope(scale, q)      -scale f'(q)
     curvature(scale, q)  -scale f''(q)
   and a member of Kernel. Wendland C2: Wendland, Adv. Comput. Math. 4 (1995) 389; splines:
   Monaghan, Rep. Prog. Phys. 68 (2005) 1703.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_KERNEL_H
#define LMP_TMSPH_KERNEL_H

#include "tmsph_alternatives.h"
#include "tmsph_pi.h"

namespace TMSPH {

/// x^n where x > 0, else 0
inline double positive_power(double x, int n)
{
  double p = 1.0;
  for (; n > 0 && x > 0.0; n--) p *= x;
  return x > 0.0 ? p : 0.0;
}

struct WendlandC2 {
  static constexpr const char *NAME = "wendland";
  static constexpr double SUPPORT = 2.0;
  static double norm(int dimension)
  {
    return dimension == 2 ? 7.0 / (4.0 * PI) : 21.0 / (16.0 * PI);
  }
  static double value(double scale, double q)
  {
    return scale * positive_power(1.0 - 0.5 * q, 4) * (1.0 + 2.0 * q);
  }
  static double slope(double scale, double q)
  {
    const double c = 1.0 - 0.5 * q;
    return scale * (5.0 * q * c * c * c);
  }
  static double curvature(double scale, double q)
  {
    const double c = 1.0 - 0.5 * q;
    return scale * (5.0 * c * c * (1.0 - 2.0 * q));
  }
};

struct CubicSpline {
  static constexpr const char *NAME = "cubic";
  static constexpr double SUPPORT = 2.0;
  static double norm(int dimension) { return dimension == 2 ? 10.0 / (7.0 * PI) : 1.0 / PI; }
  static double value(double scale, double q)
  {
    return scale * 0.25 * (positive_power(2.0 - q, 3) - 4.0 * positive_power(1.0 - q, 3));
  }
  static double slope(double scale, double q)
  {
    return scale * (q < 1.0 ? 3.0 * q - 2.25 * q * q : 0.75 * (2.0 - q) * (2.0 - q));
  }
  static double curvature(double scale, double q)
  {
    return scale * (q < 1.0 ? 3.0 - 4.5 * q : 1.5 * (q - 2.0));
  }
};

struct QuinticSpline {
  static constexpr const char *NAME = "quintic";
  static constexpr double SUPPORT = 3.0;
  static double norm(int dimension)
  {
    return dimension == 2 ? 7.0 / (478.0 * PI) : 1.0 / (120.0 * PI);
  }
  static double value(double scale, double q)
  {
    return scale *
        (positive_power(3.0 - q, 5) - 6.0 * positive_power(2.0 - q, 5) +
         15.0 * positive_power(1.0 - q, 5));
  }
  static double slope(double scale, double q)
  {
    return scale *
        (5.0 *
         (positive_power(3.0 - q, 4) - 6.0 * positive_power(2.0 - q, 4) +
          15.0 * positive_power(1.0 - q, 4)));
  }
  static double curvature(double scale, double q)
  {
    return scale *
        (-20.0 *
         (positive_power(3.0 - q, 3) - 6.0 * positive_power(2.0 - q, 3) +
          15.0 * positive_power(1.0 - q, 3)));
  }
};

/// Restart files keep the place of a kernel in this list: new ones go to its end.
using Kernel = std::variant<WendlandC2, CubicSpline, QuinticSpline>;

/// All kernels by their names, in the order of Kernel.
inline std::vector<std::pair<std::string, Kernel>> kernels()
{
  return alternatives<Kernel>();
}

/// Support radius in smoothing lengths h.
inline double support_in_smoothing_lengths(const Kernel &kernel)
{
  return std::visit([](auto shape) { return shape.SUPPORT; }, kernel);
}

/** w(R) = -W'(R)/R >= 0, so that grad_{X_i} W_ij = w (X_j - X_i).

    @param dimension 2 or 3
    @param R         reference distance, 0 < R
    @param delta     support radius, where W vanishes
    @return          w in 1/length^(dimension+2); zero from delta on */
inline double kernel_slope(const Kernel &kernel, int dimension, double R, double delta)
{
  if (R >= delta) return 0.0;
  return std::visit(
      [=](auto shape) {
        const double h = delta / shape.SUPPORT;
        const double length = dimension == 2 ? h * h : h * h * h;
        return shape.slope(shape.norm(dimension), R / h) / (length * h * R);
      },
      kernel);
}

/** dw/dR of this w. */
inline double kernel_slope_rate(const Kernel &kernel, int dimension, double R, double delta)
{
  if (R >= delta) return 0.0;
  return std::visit(
      [=](auto shape) {
        const double h = delta / shape.SUPPORT, norm = shape.norm(dimension);
        const double length = dimension == 2 ? h * h : h * h * h;
        return (shape.curvature(norm, R / h) / h - shape.slope(norm, R / h) / R) / (length * h * R);
      },
      kernel);
}

/** The kernel W(R) itself, in 1/length^dimension.

    @param R 0 <= R */
inline double kernel_value(const Kernel &kernel, int dimension, double R, double delta)
{
  if (R >= delta) return 0.0;
  return std::visit(
      [=](auto shape) {
        const double h = delta / shape.SUPPORT;
        const double length = dimension == 2 ? h * h : h * h * h;
        return shape.value(shape.norm(dimension) / length, R / h);
      },
      kernel);
}

}    // namespace TMSPH
#endif
