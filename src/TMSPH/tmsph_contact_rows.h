/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Columns of the rows by which a force evaluation of contact tells other
   processors of its particles.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_ROWS_H
#define LMP_TMSPH_CONTACT_ROWS_H

namespace TMSPH {

/** Of each particle: F - I, velocity, acceleration, 1 if its bonds can balance a couple, compliance
    Kc/m. */
template <int D> struct ContactRow {
  static constexpr int H = 0, V = D * D, A = V + D, BEARS = A + D, COMPLIANCE = BEARS + 1,
                       SIZE = COMPLIANCE + 1;
};

/** And of its places at segments: the ids of the ends, how much of the place belongs to the second,
    stiffness; then force, from the particle to the place, distance when touching, normal force,
    heat, depth of the particle below its surface/sum of both depths, 1/sum over the ends that can
    balance a couple of what belongs to them. */
struct SegmentRow : ContactRow<2> {
  static constexpr int PLACES = 2;
  static constexpr int START = 0, END = 1, ALONG = 2, STIFFNESS = 3, WHERE_SIZE = 4;
  static constexpr int F = 0, R = 2, TOUCHING = 4, NORMAL = 5, HEAT = 6, DEPTH = 7, BORNE = 8,
                       FORCE_SIZE = 9;
  // places at a particle of an outline, else an error: 32 on each of its two segments
  static constexpr int MOST_PRESSED = 64;
  static constexpr int WHERE = ContactRow<2>::SIZE, FORCE = WHERE + PLACES * WHERE_SIZE,
                       SIZE = FORCE + PLACES * FORCE_SIZE;
};

}    // namespace TMSPH
#endif
