/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   One step of a contact law: the forces that hold a particle at the one or two
   places where it touches a wall or the outline of another body, or two
   particles apart. Anchors, where friction is zero, go along from place to
   place.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_HOLD_H
#define LMP_TMSPH_CONTACT_HOLD_H

#include "tmsph_contact_law.h"

namespace TMSPH {

/** Normal forces at one or two places.
    @param q         k dt^2/m_eff
    @param frequency squared, of the partners on all their springs: what damping is relative to
    @param cosine    of the angle between the normals of two places
    @param predicted penetrations at the end of the step without the contact
    @param closing   velocities
    @param normal    none negative */
inline void hold_across(const ContactLaw &law, double stiffness, double q, double frequency,
                        int places, double cosine, const double *predicted, const double *closing,
                        double *normal)
{
  if (places == 2)
    implicit_corner(stiffness, q, cosine, predicted, normal);
  else if (places == 1)
    normal[0] = implicit_normal(stiffness, q, predicted[0]);
  for (int p = 0; p < places; p++)
    if (normal[p] > 0.0) normal[p] = law.normal(normal[p], stiffness, frequency, closing[p]);
}

/** What friction does at a place in a step; N components along the surface, or in space. */
template <int N> struct Friction {
  double force[N];     ///< against +slip on the one that slips
  double excess[N];    ///< by how much the anchor moves along
  double work;         ///< lost
};

/** Friction at a place.
    @param q     stiffness dt^2/m_eff
    @param limit friction coefficient times normal force
    @param slip  at the end of the step without friction, from the anchor */
template <int N>
inline Friction<N> hold_along(double stiffness, double q, double limit, const double *slip)
{
  Friction<N> r;
  implicit_friction<N>(stiffness, q, limit, slip, r.force, r.excess);
  r.work = r.force[0] * r.excess[0];
  for (int k = 1; k < N; k++) r.work += r.force[k] * r.excess[k];
  return r;
}

/** Energy in the springs of a place.
    @param rubbing friction along the surface, N components */
template <int N>
inline double held_energy(double stiffness, double tangential, double normal, const double *rubbing)
{
  double square = rubbing[0] * rubbing[0];
  for (int k = 1; k < N; k++) square += rubbing[k] * rubbing[k];
  return 0.5 * normal * normal / stiffness + 0.5 * square / tangential;
}

/** The anchor that a place takes over: the one of its own piece of the surface, else, where there
    is no other place, any.
    @param taken  those that another place has already
    @param same   same(n): does anchor n belong to the piece of this place?
    @return       its number, or -1: friction starts from where the particle is */
template <class Same> inline int anchor_for(int anchors, const char *taken, int places, Same same)
{
  int which = -1;
  for (int n = 0; n < anchors; n++)
    if (!taken[n] && (same(n) || (which < 0 && places == 1))) which = n;
  return which;
}

}    // namespace TMSPH
#endif
