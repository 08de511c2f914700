/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Coefficients of RKL2, explicit super-time-stepping of second order whose s
   stages cover about s^2/4 stable steps of the explicit Euler scheme: Meyer,
   Balsara, Aslam, J. Comput. Phys. 257 (2014) 594.

     Y_1 = Y_0 + mu~_1 tau L(Y_0)
     Y_j = mu_j Y_(j-1) + nu_j Y_(j-2) + (1 - mu_j - nu_j) Y_0
         + mu~_j tau L(Y_(j-1)) + gamma~_j tau L(Y_0)
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RKL2_H
#define LMP_TMSPH_RKL2_H

#include <cmath>

namespace TMSPH {

struct Rkl2 {
  struct Stage {
    double mu, nu, mu_rate, gamma_rate;
  };

  int stages;

  /** @param ratio of the step to the largest stable one of explicit Euler, 2/lambda_max.
      Odd numbers of stages damp the highest modes. */
  explicit Rkl2(double ratio) : stages(3)
  {
    const double least = 0.5 * (std::sqrt(9.0 + 16.0 * ratio) - 1.0);
    if (least > 3.0) stages = (int) std::ceil(least);
    if (stages % 2 == 0) stages++;
  }

  /// tau_max/(2/lambda_max)
  double reach() const { return 0.25 * (stages * (stages + 1.0) - 2.0); }

  /// @param j 1 to stages
  Stage stage(int j) const
  {
    const double w = 1.0 / reach();
    if (j == 1) return {1.0, 0.0, b(1) * w, 0.0};
    const double mu = (2.0 * j - 1.0) / j * b(j) / b(j - 1);
    const double nu = -(j - 1.0) / j * b(j) / b(j - 2);
    return {mu, nu, mu * w, -(1.0 - b(j - 1)) * mu * w};
  }

 private:
  static double b(int j)
  {
    return j < 2 ? 1.0 / 3.0 : (j * (j + 1.0) - 2.0) / (2.0 * j * (j + 1.0));
  }
};

}    // namespace TMSPH
#endif
