/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What contacts do to a particle: force, its part of the stress, couples.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_EFFECT_H
#define LMP_TMSPH_CONTACT_EFFECT_H

#include "tmsph_contact_pair.h"

namespace TMSPH {

struct ContactEffect {
  double force[3] = {};
  double stress[6] = {};    ///< Cauchy stress times volume: xx yy zz xy xz yz
  double tilt[9] = {};      ///< moments f x of what bonds have to balance

  /** Adds half of a contact, between two points.
      @param sign  1 at the second of them, on which f acts, -1 at the first
      @param depth of the particle below its surface, as a fraction of the sum of both depths
      @param borne fraction of the couple that its bonds balance
      @param r     from the first point to the second
      @param normal of the surface, of unit length */
  template <int D>
  void add(double sign, double depth, double borne, const double *f, const double *r,
           const double *normal)
  {
    // of the stress: the mean of one half and of the fraction of depth; with either alone stresses
    // of single particles beside a cut are off by more than 10 % (test_closed_cut)
    const double part = 0.25 + 0.5 * depth;
    for (int a = 0; a < D; a++) {
      force[a] += sign * f[a];
      stress[a] -= part * f[a] * r[a];
    }
    stress[3] -= 0.5 * part * (f[0] * r[1] + f[1] * r[0]);
    if (D == 3) {
      stress[4] -= 0.5 * part * (f[0] * r[2] + f[2] * r[0]);
      stress[5] -= 0.5 * part * (f[1] * r[2] + f[2] * r[1]);
    }
    if (borne != 0.0) add_tilt<D>(borne, f, r, normal, tilt);
  }

  void add(const ContactEffect &other)
  {
    for (int a = 0; a < 3; a++) force[a] += other.force[a];
    for (int k = 0; k < 6; k++) stress[k] += other.stress[k];
    for (int k = 0; k < 9; k++) tilt[k] += other.tilt[k];
  }
};

}    // namespace TMSPH
#endif
