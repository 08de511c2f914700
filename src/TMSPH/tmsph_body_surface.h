/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface of a body that conducts heat, as its reference bonds show it: where
   particles are on it, with which area, depth and normal.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BODY_SURFACE_H
#define LMP_TMSPH_BODY_SURFACE_H

#include "pointers.h"
#include "tmsph_bond_pull.h"
#include "tmsph_ghost_rows.h"

#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;
class TMSPHConductanceBalance;
class TMSPHConductionNorms;
class TMSPHFlatFaces;

/** A piece of the surface and the local particle below it, which may have several. */
struct TMSPHSurfacePiece {
  int i;
  TMSPH::Surface surface;
  double area;
  bool flat;    ///< a face of a body on a lattice
};

class TMSPHBodySurface : protected Pointers {
 public:
  TMSPHBodySurface(class LAMMPS *, const TMSPHConductionNorms &, const TMSPHFlatFaces &,
                   const TMSPHConductanceBalance &, TMSPHGhostSender &);
  void init(const FixTMSPHBond *owner) { bonds = owner; }

  // collective, all of them

  /** @param cracks bonds that are gone count as surface too
      @return       in the order of the particles */
  std::vector<TMSPHSurfacePiece> pieces(bool cracks) const;
  /// of all local particles; those away from the surface have no area
  std::vector<TMSPH::BondPull> pulls(bool cracks) const;
  /// particles that are outermost or have a partner that is
  std::vector<char> near(const std::vector<TMSPH::BondPull> &) const;
  /// true if the bonds of particles away from it pull unevenly, as those of no lattice
  bool irregular_inside(const std::vector<TMSPH::BondPull> &, const std::vector<char> &near) const;

 private:
  const TMSPHConductionNorms &norms;
  const TMSPHFlatFaces &faces;
  const TMSPHConductanceBalance &balance;
  TMSPHGhostSender &ghosts;
  const FixTMSPHBond *bonds = nullptr;

  template <int D> std::vector<TMSPH::BondPull> pulls_of_bonds(bool cracks) const;
  double noise_inside(const std::vector<TMSPH::BondPull> &, const std::vector<char> &near) const;
  void smooth(std::vector<TMSPH::BondPull> &, double least) const;
  template <int D>
  bool divide_among_faces(int i, const TMSPH::BondPull &, bool cracks,
                          std::vector<TMSPHSurfacePiece> &) const;
};

}    // namespace LAMMPS_NS

#endif
