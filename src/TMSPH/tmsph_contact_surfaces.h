/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Surfaces of bodies near their particles in the reference state: those of
   given regions, else as the bonds show them.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_SURFACES_H
#define LMP_TMSPH_CONTACT_SURFACES_H

#include "pointers.h"
#include "tmsph_contact_pair.h"
#include "tmsph_contact_scene.h"
#include "tmsph_own_surface.h"

#include <string>
#include <vector>

namespace TMSPH {

/** Cosine of the angle between the outward normals of surfaces that face each other, at most: 107
    degrees, beyond the 90 between both sides of a corner of one body; 93 to 134 degrees do the same
    in unittest/verification/test_fragments.py. */
constexpr double FACING = -0.3;

}    // namespace TMSPH

namespace LAMMPS_NS {

class TMSPHContactSurfaces : protected Pointers {
 public:
  TMSPHContactSurfaces(class LAMMPS *lmp, const TMSPHContactScene &scene) :
      Pointers(lmp), scene(scene)
  {
  }
  /// a region whose surface is that of bodies
  void add_region(const std::string &id) { region_ids.push_back(id); }
  /// at each init: an error if a region is not there or moves
  void init();
  /// of all local particles, if bonds have changed since
  template <int D> void find();
  /// of a local particle, as found
  const TMSPH::Surface &operator[](int i) const { return surfaces[i]; }
  /** The given surfaces of two particles, at least one of them local.
      @param X reference vector from low to high
      @return  false if the two are not on either side of a given surface */
  template <int D> bool take_given(int low, int high, const double *X, TMSPH::PairGeometry &);

 private:
  const TMSPHContactScene &scene;
  std::vector<std::string> region_ids;
  std::vector<class Region *> regions;
  bool sides_checked = false;              // of the particles at these
  std::vector<TMSPH::Surface> surfaces;    // of local particles
  TMSPHBondWatch watch;                    // of the bonds that they were found from

  TMSPH::Surface given(int i) const;
};

}    // namespace LAMMPS_NS
#endif
