/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface of a LAMMPS region as that of a body.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_REGION_SURFACE_H
#define LMP_TMSPH_REGION_SURFACE_H

#include "fix_tmsph_bond.h"
#include "region.h"
#include "tmsph_own_surface.h"

namespace LAMMPS_NS {

/// of faces that are equally far but for round-off, which is far below this, the first one counts
static constexpr double NEARER = 1.0 - 1.0e-9;

/** Where the surface of a region is nearest to X, if that is nearer than the depth of s: then s
    becomes GIVEN, its normal points away from X. */
inline void take_nearest_surface(Region &region, double *X, TMSPH::Surface &s)
{
  const double low[3] = {region.extent_xlo, region.extent_ylo, region.extent_zlo};
  const double high[3] = {region.extent_xhi, region.extent_yhi, region.extent_zhi};
  for (int k = 0; k < 3 && region.bboxflag && !region.dynamic && !region.varshape; k++)
    if (X[k] < low[k] - s.depth || X[k] > high[k] + s.depth) return;
  const int found = region.inside(X[0], X[1], X[2]) ? region.surface_interior(X, s.depth)
                                                    : region.surface_exterior(X, s.depth);
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

/// the same of particle i in the reference positions; the region is there once in each period
inline void take_nearest_surface(Region &region, const FixTMSPHBond &bonds, int i,
                                 TMSPH::Surface &s)
{
  double X[3];
  int most[3];
  bonds.reference_in_box(i, X);
  for (int k = 0; k < 3; k++) most[k] = bonds.reference_period(k) > 0.0;
  for (int nx = -most[0]; nx <= most[0]; nx++)
    for (int ny = -most[1]; ny <= most[1]; ny++)
      for (int nz = -most[2]; nz <= most[2]; nz++) {
        double image[3] = {X[0] + nx * bonds.reference_period(0),
                           X[1] + ny * bonds.reference_period(1),
                           X[2] + nz * bonds.reference_period(2)};
        take_nearest_surface(region, image, s);
      }
}

}    // namespace LAMMPS_NS

#endif
