/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Regions of LAMMPS as the shapes of bodies: where their surfaces are, and their
   size.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_REGION_SHAPES_H
#define LMP_TMSPH_REGION_SHAPES_H

#include "pointers.h"
#include "tmsph_relaxation.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {

/** Faces of a region at which the body goes on, at a side of a periodic box, are no surface. */
template <int D> class TMSPHRegionShapes : protected Pointers, public TMSPH::BodyShapes<D> {
 public:
  using Vector = typename TMSPH::BodyShapes<D>::Vector;

  TMSPHRegionShapes(class LAMMPS *lmp, const std::vector<class Region *> &regions) :
      Pointers(lmp), regions(regions)
  {
  }
  bool inside(int body, const Vector &X) const override;
  std::vector<TMSPH::TangentPlane<D>> planes(int body, const Vector &X,
                                             double reach) const override;
  /** Volume, in 2-D area, of a region in the box; an error if it has no end.
      @param cell edge of the cells that are divided no further */
  double size(int body, double cell) const;

 private:
  const std::vector<Region *> regions;

  Vector wrapped(Vector X) const;
  std::vector<TMSPH::TangentPlane<D>> tangents(int body, const Vector &X, double reach) const;
  double part_inside(int body, const Vector &middle, const Vector &edges, bool &crossed) const;
  double size_within(int body, const Vector &low, const Vector &high, double cell) const;
};

}    // namespace LAMMPS_NS

#endif
