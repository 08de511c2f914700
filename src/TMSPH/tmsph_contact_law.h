/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Contact forces as functions of penetration and slip. They know nothing of
   who touches whom: for walls, segments and kernel-weighted pairs.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_LAW_H
#define LMP_TMSPH_CONTACT_LAW_H

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace TMSPH {

/** What a contact law is made of; one more is one more line of CONTACT_LAWS. */
struct ContactLaw {
  const char *name;
  bool predicts;       ///< answers the penetration at the end of the step, else that of now
  double damping;      ///< of the normal motion, of critical
  bool throws_back;    ///< stiffness 2 m/dt^2: a lone particle leaves in one step

  /// the time that it looks ahead
  double ahead(double dt) const { return predicts ? dt : 0.0; }
  /** @param spring stiffness of the surfaces
      @param factor of the user
      @param m      effective mass of the partners */
  double stiffness(double spring, double factor, double m, double dt) const
  {
    return throws_back ? factor * (2.0 * m / (dt * dt)) : spring;
  }
  /// @param spring stiffness along the surface/across it
  double shear_ratio(double spring) const { return throws_back ? 1.0 : spring; }
  /** Normal force of partners that touch.
      @param force     of the spring
      @param frequency squared, of the partners on all their springs
      @param closing   velocity */
  double normal(double force, double stiffness, double frequency, double closing) const
  {
    return damping == 0.0
        ? force
        : std::max(0.0, force + 2.0 * damping * stiffness / std::sqrt(frequency) * closing);
  }
};

/// implicit is usual; paper: Mu et al. (2022), Eqs. 14 and 15. Damping z = 0.2 leaves, after a
/// bounce, exp(-pi z/sqrt(1 - z^2)) = 0.53 of the velocity, and of the stable step
/// sqrt(1 + z^2) - z = 0.82 (Belytschko, Liu, Moran, Nonlinear Finite Elements, 2000, Sect. 6.2)
constexpr ContactLaw CONTACT_LAWS[] = {
    {"implicit", true, 0.0, false}, {"penalty", false, 0.2, false}, {"paper", false, 0.0, true}};

/// by their names
inline std::vector<std::pair<std::string, ContactLaw>> contact_laws()
{
  std::vector<std::pair<std::string, ContactLaw>> all;
  for (const ContactLaw &law : CONTACT_LAWS) all.emplace_back(law.name, law);
  return all;
}

/** A force per area that depends on the penetration p of two surfaces stands for the half cells
    between them and the centres of the outermost particles: k = 1/sum(dx/(HALF_CELL E')), with
    E' = E/(1 - nu^2) and the spacing dx on each side. HALF_CELL is calibrated on blocks of square
    lattice, Wendland kernel, horizon 3.015 dx and hourglass 0.1, so that a compressed block becomes
    as stiff as the continuum with refinement: unittest/verification/test_slide.py, where 3 % of it
    are 0.5 % of the force at 10 particles an edge. */
constexpr double HALF_CELL = 1.135;
/// stiffness along the surface/across it: G/E' = (1 - nu)/2 with nu = 0.2
constexpr double TANGENTIAL = 0.4;

/** One side of a contact, for half_cells(). */
struct HalfCell {
  double modulus, spacing;    ///< E', dx
};

/** Secant stiffness per area. St Venant-Kirchhoff material in uniaxial compression by e carries
    E' (1 - e)(1 - (1 - e)^2)/2 = E' e (1 - e)(1 - e/2) per reference area.
    @param factor to the stiffness
    @param count  1 against a rigid wall, or 2 */
inline double half_cells(const HalfCell *side, int count, double factor, double penetration)
{
  // beyond 1 - 1/sqrt(3) = 0.42 the stress would fall; with 0.1 the block that is compressed by 8 %
  // in test_slide is the same
  constexpr double LARGEST_STRAIN = 0.25;
  double soft = 0.0, strain = 0.0;
  for (int k = 0; k < count; k++) soft += side[k].spacing / (HALF_CELL * side[k].modulus);
  const double stiffness = factor / soft;
  for (int k = 0; k < count; k++)    // mean of both, weighted by their parts of it
    strain += side[k].spacing / (HALF_CELL * side[k].modulus * soft) * stiffness *
        std::max(0.0, penetration) / side[k].modulus;
  strain = std::min(LARGEST_STRAIN, strain);
  return stiffness * (1.0 - strain) * (1.0 - 0.5 * strain);
}

/** Implicit penalty. The spring of stiffness k answers the penetration at the end of the step, when
    the force has already acted: with p the penetration that the partners would reach without it,
      F = k (p - F dt^2/m_eff),  so  F = k p/(1 + q),  q = k dt^2/m_eff,
    stable for any k and dt; k -> infinity is the Lagrange multiplier that just stops them.
    @param predicted p, positive when the partners overlap
    @return the magnitude of the repulsion, 0 without overlap */
inline double implicit_normal(double stiffness, double q, double predicted)
{
  return stiffness * std::max(0.0, predicted) / (1.0 + q);
}

/** The same for a particle in a corner, held by two springs of equal stiffness at once.
    @param cosine    of the angle between their normals, below 1
    @param predicted of both
    @param force     of both, none negative */
inline void implicit_corner(double stiffness, double q, double cosine, const double *predicted,
                            double *force)
{
  // (1+q) F_1 + q c F_2 = k p_1 and the like; if one would pull, the other acts alone

  const double a = 1.0 + q, b = q * cosine, det = a * a - b * b;
  for (int k = 0; k < 2; k++)
    force[k] = stiffness * (a * predicted[k] - b * predicted[1 - k]) / det;
  if (force[0] >= 0.0 && force[1] >= 0.0) return;
  const int k = stiffness * predicted[1] <= b * implicit_normal(stiffness, q, predicted[0]) ? 0 : 1;
  force[k] = implicit_normal(stiffness, q, predicted[k]);
  force[1 - k] = 0.0;
}

/** Coulomb friction with an elastic stick, implicit like implicit_normal. The slip s is measured
    from an anchor where the contact carries no tangential force.
      |k s/(1 + q)| <= limit: stick, F = k s/(1 + q);  else F = limit s/|s|.
    @param q         k dt^2/m_eff with the tangential stiffness
    @param limit     friction coefficient times normal force
    @param predicted slip at the end of the step without friction, N components
    @param force     what resists the slip: acts against +predicted on the one that slips,
                     N components
    @param excess    by how much the anchor moves along, so that the law gives just this force for
                     the same prediction: (1 + q) F/k is the slip that is left; N components
    @return true if the contact slides */
template <int N>
inline bool implicit_friction(double stiffness, double q, double limit, const double *predicted,
                              double *force, double *excess)
{
  double square = 0.0;
  for (int k = 0; k < N; k++) {
    force[k] = stiffness * predicted[k] / (1.0 + q);
    square += force[k] * force[k];
    excess[k] = 0.0;
  }
  if (square <= limit * limit) return false;
  const double scale = limit / std::sqrt(square);
  for (int k = 0; k < N; k++) {
    force[k] *= scale;
    excess[k] = (1.0 - scale) * predicted[k];
  }
  return true;
}

}    // namespace TMSPH
#endif
