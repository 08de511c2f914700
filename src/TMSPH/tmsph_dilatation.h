/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Averaged dilatation for nearly incompressible materials. With the dilatation
   theta_i = tr E_i of the elastic strain, the energy density is

     psi_i = mu E_i:E_i + lambda/2 thetabar_i^2,
     thetabar_i = theta_i + (1/V_i) sum_j M_ij (theta_j - theta_i),
     M_ij = V_i V_j W(X_ij)/kappa,

   over intact bonds to the own material, W the kernel and kappa (= tr K/D of the
   interior, close to the integral of W) its normalization. The stress is then

     P_i = F_i (2 mu E_i + q_i I),
     q_j = g_j + (1/V_j) sum_i M_ij (g_i - g_j),   g_i = lambda thetabar_i.

   A mean that divides by the sum of the weights, as is usual in SPH, would not be
   its own transpose: q would then differ from lambda theta at surfaces by up to 18 %
   in a homogeneous state. Here M is symmetric, and what is missing in the sum of
   the weights stays with the particle itself: both steps are the same operation, and
   a homogeneous state has q = lambda theta everywhere.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_DILATATION_H
#define LMP_TMSPH_DILATATION_H

#include "tmsph_sweep.h"

namespace TMSPH {

enum class Dilatation { AUTO, PLAIN, AVERAGED };

/// From this Poisson's ratio on, exclusive, AUTO averages: plain is right and cheaper up to 0.45
/// (doc/report/incompressible.md), and rock has less than 0.4.
constexpr double AVERAGED_ABOVE = 0.4;

/// tr E of H = F - I, row-major; without thermal strain
template <int D> inline double trace_of_strain(const double *H)
{
  double trace = 0.0, square = 0.0;
  for (int k = 0; k < D; k++) trace += H[k * D + k];
  for (int k = 0; k < D * D; k++) square += H[k] * H[k];
  return trace + 0.5 * square;
}

/** mean_i = value_i + (1/V_i) sum_j M_ij (value_j - value_i) for the particles of the slices.
    @param value [local or ghost index]
    @param mean  [local index] */
template <int D> void average_sweep(const Slices &bonds, const double *value, double *mean);

/** Adds V q F Kbar^-1 to the stress part B of a force row.
    @param own constants of the particle's lane in its slice
    @param H   F - I, row-major */
template <int D> void add_pressure(double q, const double *H, const double *own, double *force_row);

/** Adds the Cauchy stress q F F^T/J, divided by stretch^D, to a stress row: the stretch is that of
    the thermal bonds, which H leaves out. Particles with J <= 0 keep what they have. */
template <int D>
void add_pressure_stress(double q, const double *H, double stretch, double *stress);

}    // namespace TMSPH
#endif
