/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Coupling of two materials across their interface, where one of them is nearly
   incompressible. Each side has its deformation gradient from its own bonds; the
   bonds across hold the two together by

     U = sum_pairs c W_ij/2 |r_ij|^2,   c = 10 * 2 E_i E_j/(E_i + E_j),
     r_ij = u_ij - (s_i G_i + s_j G_j) X_ij,   s_i = d_i/(d_i + d_j), s_j = 1 - s_i

   with G the whole displacement gradient, that of expansion included, and d the
   distance to the interface: along the bond each side deforms as it does where it is.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_INTERFACE_H
#define LMP_TMSPH_INTERFACE_H

#include "tmsph_kernel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace TMSPH {

/// c in harmonic means of Young's moduli: 3 is too soft, 30 gains nothing and costs time steps
/// (measured with the inclusions of unittest/verification/test_incompressible.py)
inline double coupling_stiffness(double young_i, double young_j)
{
  return 10.0 * 2.0 * (young_i * young_j) / (young_i + young_j);
}

/** Distance to a plane interface from the fraction of the kernel's mass on the own side. */
class InterfaceDepth {
 public:
  InterfaceDepth() = default;
  InterfaceDepth(Kernel kernel, int dimension, double delta) : horizon(delta), below(1, 0.5)
  {
    // mass of the layers between the particle and the distance, midpoint rule
    for (int k = 0; k < STEPS; k++) {
      const double x = (k + 0.5) / STEPS, reach = std::sqrt(1.0 - x * x);
      double layer = 0.0;
      for (int n = 0; n < STEPS; n++) {
        const double y = (n + 0.5) / STEPS * reach;
        layer += (dimension == 2 ? 1.0 : y) * reach *
            kernel_value(kernel, dimension, std::sqrt(x * x + y * y), 1.0);
      }
      below.push_back(below.back() + layer);
    }
    const double half = below.back() - 0.5;
    for (double &part : below) part = 0.5 + 0.5 * (part - 0.5) / half;
  }

  /// @param fraction 0 to 1; the distance is not negative
  double operator()(double fraction) const
  {
    const int k = std::upper_bound(below.begin(), below.end(), fraction) - below.begin();
    if (k == 0) return 0.0;
    if (k > STEPS) return horizon;
    return horizon * (k - 1 + (fraction - below[k - 1]) / (below[k] - below[k - 1])) / STEPS;
  }

 private:
  static constexpr int STEPS = 100;    // layers: depths, half a spacing or more, are 17 of them
  double horizon = 0.0;
  std::vector<double> below;
};

}    // namespace TMSPH
#endif
