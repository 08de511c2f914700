/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface between the two particles of a contact pair, and its stiffness.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_FIT_H
#define LMP_TMSPH_CONTACT_FIT_H

#include "pointers.h"
#include "tmsph_contact_list.h"
#include "tmsph_contact_surfaces.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_plane_fit.h"

namespace LAMMPS_NS {

/** The surface between two particles is the plane through the middles of the short separated pairs
    around both, unless it is given. Those of body interfaces and of cracks count apart: a crack
    that runs into an interface has another direction. */
class TMSPHContactFit : protected Pointers {
 public:
  /// @param ghosts sends MOST_SENT doubles of each particle at most
  TMSPHContactFit(class LAMMPS *lmp, const TMSPHContactScene &scene, TMSPHContactSurfaces &surfaces,
                  TMSPHGhostSender &ghosts) :
      Pointers(lmp),
      scene(scene), surfaces(surfaces), ghosts(ghosts)
  {
  }
  static constexpr int MOST_SENT = 2 * TMSPH::Moments<3>::SIZE;

  /// what all pairs need, and where there are new ones the surfaces of all (collective)
  void fit(TMSPHContactList &);

 private:
  const TMSPHContactScene &scene;
  TMSPHContactSurfaces &surfaces;
  TMSPHGhostSender &ghosts;
  bool distance_checked = false;    // of bodies that are not bonded

  template <int D> void fit_pairs(TMSPHContactList &);
  template <int D> void set_origin(TMSPHContactList::Pairing &) const;
  template <int D> void find_surfaces(TMSPHContactList &);
  template <int D> double mark(const TMSPHContactList &, TMSPHGhostRows &) const;
  template <int D> void gather_marks(const TMSPHContactList &, TMSPHGhostRows &);
  template <int D> void fit_surface(TMSPHContactList::Pairing &, const TMSPHGhostRows &);
  void set_stiffness(TMSPHContactList::Pairing &, double kappa, double ratio, double closure) const;
  void warn_if_apart(double nearest);
};

}    // namespace LAMMPS_NS
#endif
