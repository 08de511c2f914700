/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Contact forces as functions of penetration and slip. They know nothing of
   who touches whom: walls, segments and kernel-weighted pairs share them.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_LAW_H
#define LMP_TMSPH_CONTACT_LAW_H

#include <algorithm>
#include <cmath>

namespace TMSPH {

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

/** Coulomb friction with an elastic stick, implicit like implicit_normal. The slip s is measured from
    an anchor where the contact carries no tangential force.
      |k s/(1 + q)| <= limit: stick, F = k s/(1 + q);  else F = limit s/|s|.
    @param q         k dt^2/m_eff with the tangential stiffness
    @param limit     friction coefficient times normal force
    @param predicted slip at the end of the step without friction, N components
    @param force     what resists the slip: acts against +predicted on the one that slips, N components
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
