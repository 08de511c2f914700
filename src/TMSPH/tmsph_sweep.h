/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The two sweeps over the bonds that make up a force evaluation, eight
   particles at a time, and the flat arrays they stream over.

   With W_ij = V_i V_j w_ij, X_ij = X_j - X_i, u_ij = u_j - u_i:

     gradient sweep   Kbar_i = sum_j W_ij X_ij X_ij^T          (= V_i K_i)
                      H_i    = F_i - I = (sum_j W_ij u'_ij X_ij^T) Kbar_i^-1
                      B_i    = V_i P(H_i) Kbar_i^-1 - chi_i H_i
     force sweep      f_i    = sum_j W_ij/(1 + theta_ij)
                               { (B_i + B_j) X_ij + (chi_i + chi_j) u'_ij } + viscosity

   This is minus the gradient of U = sum_i V_i psi(F_i)
   + sum_i chi_i/2 sum_j W_ij |u'_ij - H_i X_ij|^2: in the hourglass term the
   weights are those of the least-squares fit H_i, so that its variation drops
   out. u' = (u - theta X)/(1 + theta) with the thermal bond, u otherwise.

   Each particle gathers its own force from all its bonds, in the order of the
   partners' ids: no sum depends on how particles are spread over processors,
   and f_ij = -f_ji to the last bit.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_SWEEP_H
#define LMP_TMSPH_SWEEP_H

#include "tmsph_elastic_law.h"
#include "tmsph_lanes.h"

#include <vector>

namespace TMSPH {

enum class ThermalStrain { NONE, BOND, CONSTITUTIVE };

/** What a scene uses; each combination is compiled on its own. */
struct Features {
  ElasticLaw law;
  ThermalStrain thermal = ThermalStrain::NONE;
  bool hourglass = false;
  bool viscosity = false;
};

/** Layout of the two rows that hold what a bond needs from its ends.

    kinematic row, known before the gradient sweep (8 doubles):
      X[D] u[D] E E*a, and in 2-D c and rho
    force row, known after it (8 doubles in 2-D, 16 in 3-D):
      B[D*D] chi v[D], and in 3-D c and rho
    X reference position, u displacement, E Young's modulus, a thermal strain, c wave speed, rho
    density, chi hourglass stiffness, v velocity. The first part of the force row is what ghosts
    must be sent, as short as the scene allows. */
template <int D> struct Rows {
  static constexpr int KINEMATIC = 8;
  static constexpr int FORCE = D == 2 ? 8 : 16;
  static constexpr int X = 0, U = D, YOUNG = 2 * D, THERMAL = 2 * D + 1;
  static constexpr int B = 0, CHI = D * D, V = D * D + 1;
  /// wave speed and density stand in the kinematic row in 2-D, in the force row in 3-D
  static constexpr int SPEED = D == 2 ? 6 : 14, DENSITY = SPEED + 1;

  /// doubles of the force row that a ghost needs
  static int communicated(const Features &on)
  {
    return on.viscosity ? V + D : on.hourglass ? CHI + 1 : CHI;
  }
};

template <int D> constexpr int SYMMETRIC = D *(D + 1) / 2;      ///< entries of a symmetric matrix
template <int D> constexpr int CONSTANTS = SYMMETRIC<D> + 4;    ///< Kbar^-1, V, lambda, mu, chi

/** Bonds of a set of particles, packed eight particles to a slice ("sliced ELL"): bond number b of
    the eight stands in one row of eight partners and eight weights. Weight 0 is no bond.
    A singular particle has Kbar^-1 = 0 and chi = 0: it neither pulls nor resists. */
struct Slices {
  std::vector<int> particle;       ///< [slice][8] local index; pads repeat the slice's first
  std::vector<int> valid;          ///< [slice] how many of the eight are real
  std::vector<int> offset;         ///< [slice+1] first row of each slice
  std::vector<int> partner;        ///< [row][8] local or ghost index
  std::vector<float> weight;       ///< [row][8] W_ij; rounded to float once, the same for both ends
  std::vector<double> own;         ///< [slice][CONSTANTS][8]
  std::vector<float> averaging;    ///< [row][8] M_ij of tmsph_dilatation.h; empty: none
  /// [row][D][8] g_ij of another fit than the above, H_i = sum_j u'_ij g_ij^T; empty: none
  std::vector<double> fit;

  int count() const { return (int) valid.size(); }
  /// position of bond number b of the particle in lane l of slice q
  size_t at(int q, int l, int b) const { return ((size_t) offset[q] + b) * LANES + l; }
  /// of bond k of local particle i, where the slices hold all of them in their order
  size_t at(int i, int k) const { return at(i / LANES, i % LANES, k); }
  /// constants of local particle i, LANES apart, in such slices
  template <int D> const double *constants(int i) const
  {
    return own.data() + (size_t) (i / LANES) * CONSTANTS<D> * LANES + i % LANES;
  }
  size_t bytes() const
  {
    return (particle.capacity() + valid.capacity() + offset.capacity() + partner.capacity()) *
        sizeof(int) +
        (weight.capacity() + averaging.capacity()) * sizeof(float) +
        (own.capacity() + fit.capacity()) * sizeof(double);
  }
};

/// Kbar^-1 from the constants of one lane
template <int D> inline Matrix<D, double> shape_inverse(const double *own)
{
  Matrix<D, double> K;
  for (int a = 0, entry = 0; a < D; a++)
    for (int b = a; b < D; b++) K[a][b] = K[b][a] = own[LANES * entry++];
  return K;
}

/** Cauchy stress row per particle: xx yy xy in 2-D, xx yy zz xy xz yz in 3-D. */
template <int D> constexpr int STRESS_ROW = D == 2 ? 3 : 6;
constexpr int stress_row(int dimension)
{
  return dimension == 2 ? STRESS_ROW<2> : STRESS_ROW<3>;
}

/// A tension that no bond survives, even in the mean with any other stress.
constexpr double UNBEARABLE = 1.0e200;

/** Optional outputs of the gradient sweep; nullptr leaves one out. */
struct GradientOutput {
  double *force_row = nullptr;    ///< B and chi of each particle's force row
  double *stress = nullptr;       ///< [particle][STRESS_ROW]
  double *gradient = nullptr;     ///< [particle][D*D] H = F - I, row-major
  int *inverted = nullptr;        ///< set to a particle with det F <= 0 or NaN, if there is one
  /// where bonds may break det F <= 0 is no error: the stress becomes UNBEARABLE in tension instead
  bool inverted_breaks = false;
};

template <int D>
void gradient_sweep(const Features &on, const Slices &bonds, int first_slice, int last_slice,
                    const double *kinematic, const GradientOutput &out);

/** Artificial viscosity after Monaghan (1992), on approach and on separation:
    f_ij = W_ij rho (alpha1 c mu - alpha2 mu^2 on approach) |X_ij|/kappa e_ij,
    mu = h (v_j - v_i).(x_j - x_i)/(r^2 + 0.01 h^2).
    kappa = tr K/D of the interior of the intact body. A kappa of each particle's remaining bonds
    would damp the last bonds of a fragment so hard that they limit the time step. */
struct Viscosity {
  double alpha1 = 0.0, alpha2 = 0.0, smoothing_length = 0.0, kappa = 1.0;
};

/** Adds the forces to f[stride*particle]. */
template <int D>
void force_sweep(const Features &on, const Slices &bonds, const Viscosity &viscosity,
                 const double *kinematic, const double *force_row, double *f, int stride = 3);

/** Adds each particle's half of -sum x_ij f_ij (xx yy zz xy xz yz) to virial[particle][6], where
    that is not nullptr, and all of them to total[6], where that is not. A sweep of its own: were it
    done along with the forces, the compiler would round those differently, and a run that asks for
    the pressure would not be the same to the last bit as one that does not. */
template <int D>
void virial_sweep(const Features &on, const Slices &bonds, const Viscosity &viscosity,
                  const double *kinematic, const double *force_row, double *virial,
                  double *total = nullptr);

/** Power that viscosity takes, half of that of its bonds for each particle, written to
    power[particle]. */
template <int D>
void viscous_heat_sweep(const Features &on, const Slices &bonds, const Viscosity &viscosity,
                        const double *kinematic, const double *force_row, double *power);

/** Elastic and hourglass energy of each particle, written to energy[particle] if that is not
    nullptr.
    @return the sum over all particles */
template <int D>
double energy_sweep(const Features &on, const Slices &bonds, const double *kinematic,
                    double *energy);

}    // namespace TMSPH
#endif
