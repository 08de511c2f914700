/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Particles against the segments between the outer particles of another body,
   in 2-D: the hybrid friction contact of Mu et al. (2022), Sect. 3. One pass,
   the finer body against the outline of the coarser one. The owner of a
   particle finds its force; the owners of the ends of the segment learn it
   from the particle, and add it in the order of ids.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_PLACES_H
#define LMP_TMSPH_CONTACT_PLACES_H

#include "pointers.h"
#include "tmsph_contact_effect.h"
#include "tmsph_contact_memory.h"
#include "tmsph_contact_outlines.h"
#include "tmsph_contact_rows.h"
#include "tmsph_contact_scene.h"
#include "tmsph_contact_totals.h"
#include "tmsph_ghost_rows.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHContactPlaces : protected Pointers {
 public:
  /** @param rows   of a force evaluation, as SegmentRow
      @param ghosts sends columns of them */
  TMSPHContactPlaces(class LAMMPS *lmp, const TMSPHContactScene &scene,
                     TMSPHContactMemories &memories, const TMSPHContactOutlines &outlines,
                     TMSPHGhostRows &rows, TMSPHGhostSender &ghosts, TMSPHContactTotals &totals) :
      Pointers(lmp),
      scene(scene), memories(memories), outlines(outlines), rows(rows), ghosts(ghosts),
      totals(totals)
  {
  }
  /// where particles touch, as they are and at the end of the step (collective)
  void find(double dt);
  /// of all places that press on local particle i
  double stiffness(int i) const;
  /// the forces, when the compliances of all particles are known (collective)
  void hold(double dt);
  /// what they do to local particle i
  /// @param counted,other in the totals, or not
  void add(int i, TMSPH::ContactEffect &counted, TMSPH::ContactEffect &other) const;
  /// for heat
  void keep_touches(int i, TMSPHContactMemory &) const;

 private:
  /** Where a particle touches the outline of another body. */
  struct Place {
    int a, b;            // ends of the segment
    double along;        // weight of b, 1 less that of a
    double normal[2];    // towards the particle
    double distance;     // from the line through the centres; negative behind it
    double touching;     // the same when the surfaces just touch
    double predicted, closing;
  };
  /** All of a guest of the outlines. */
  struct Held {
    int count;
    double stiffness;
    Place place[2];
  };
  /** What the places of a particle have in common in a step. */
  struct Step {
    double ahead;        // time
    double k, q;         // stiffness, and k ahead^2/m_eff
    double pushed[2];    // by the normal forces of all of them
  };
  using Guest = TMSPHContactOutlines::Guest;
  using Host = TMSPHContactOutlines::Host;
  using Anchor = TMSPHContactMemory::Anchor;

  const TMSPHContactScene &scene;
  TMSPHContactMemories &memories;
  const TMSPHContactOutlines &outlines;
  TMSPHGhostRows &rows;
  TMSPHGhostSender &ghosts;
  TMSPHContactTotals &totals;
  std::vector<Held> held;    // of each guest

  double touching_distance(int i, int a, int b, double along) const;
  std::vector<Place> places_of(const Guest &, double ahead) const;
  void hold_one(const Guest &, const Held &, double dt);
  int node(const Guest &, tagint id) const;
  bool find_origin(const Guest &, const Anchor &, double *origin) const;
  Anchor rub(int i, const Place &, const Step &, double normal, double *origin, double *out);
  template <class Use> void at_host(const Host &, Use) const;
};

}    // namespace LAMMPS_NS
#endif
