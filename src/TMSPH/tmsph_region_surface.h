/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface of a LAMMPS region as that of a body.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_REGION_SURFACE_H
#define LMP_TMSPH_REGION_SURFACE_H

#include "region.h"
#include "tmsph_own_surface.h"

namespace LAMMPS_NS {

/// of faces that are equally far but for round-off the first one counts
static constexpr double NEARER = 1.0 - 1.0e-9;

/** Where the surface of a region is nearest to X, if that is nearer than the depth of s: then s
    becomes GIVEN, its normal points away from X. */
inline void take_nearest_surface(Region &region, const double *X, TMSPH::Surface &s)
{
  const int found = region.inside(X[0], X[1], X[2])
      ? region.surface_interior(const_cast<double *>(X), s.depth)
      : region.surface_exterior(const_cast<double *>(X), s.depth);
  for (int n = 0; n < found; n++) {
    const Region::Contact &c = region.contact[n];
    if (c.r <= 0.0 || c.r >= NEARER * s.depth) continue;
    s.exposure = TMSPH::Exposure::GIVEN;
    s.depth = c.r;
    s.normal[0] = -c.delx / c.r;
    s.normal[1] = -c.dely / c.r;
    s.normal[2] = -c.delz / c.r;
  }
}

}    // namespace LAMMPS_NS

#endif
