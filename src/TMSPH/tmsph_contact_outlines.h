/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Outlines of bodies in 2-D, and which particles may touch them: for method
   segment.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_OUTLINES_H
#define LMP_TMSPH_CONTACT_OUTLINES_H

#include "pointers.h"
#include "tmsph_contact_memory.h"
#include "tmsph_contact_scene.h"
#include "tmsph_ghost_rows.h"

#include <array>
#include <utility>
#include <vector>

namespace TMSPH {

/** A particle is held at an outline if it is nearer than this many of the coarsest spacing, in
    front and behind: it touches at one, half cells of both, and in a step of half a spacing over
    the wave speed what flies at that speed comes by half a spacing more. */
constexpr double OUTLINE_REACH = 1.5;

}    // namespace TMSPH

namespace LAMMPS_NS {

class TMSPHContactOutlines : protected Pointers {
 public:
  /** A local particle that outlines of other bodies may hold. */
  struct Guest {
    int i;
    int first, last;    // chains of segments near it
  };
  /** A local particle of an outline that may hold others. */
  struct Host {
    int i;
    int first, last;    // those near it, local and ghost, by ascending ids
  };
  struct Chain {
    int first, last;    // its nodes, from end to end
  };

  TMSPHContactOutlines(class LAMMPS *lmp, const TMSPHContactScene &scene,
                       TMSPHContactMemories &memories, TMSPHGhostSender &ghosts) :
      Pointers(lmp),
      scene(scene), memories(memories), ghosts(ghosts)
  {
  }
  /// the outlines, after an exchange of particles and when bonds have gone (collective)
  void find();
  /// who may touch what until the next search (collective)
  void face();
  /// true if local particle i may touch, be touched, or was near from the start
  bool faces(int i, double apart) const;

  double coarsest = 0.0;         // spacing
  bool measured = false;         // distances in the reference
  bool any = false;              // guests on any processor
  std::vector<int> particles;    // local and ghost particles of outlines
  std::vector<Guest> guests;
  std::vector<Host> hosts;
  std::vector<int> guest_of, host_of;    // of local particles, -1: neither
  std::vector<Chain> chains;
  std::vector<int> nodes, near;

 private:
  const TMSPHContactScene &scene;
  TMSPHContactMemories &memories;
  TMSPHGhostSender &ghosts;
  std::vector<double> spacing;                // by type
  std::vector<std::array<tagint, 2>> next;    // of local and ghost particles; 0: none

  void find_spacings();
  bool is_guest(int itype, int jtype) const;
  void measure();
  double reach() const;
  void list_host(int i, const std::vector<int> &others, double reach);
  void list_guest(int i, const std::vector<int> &others, double reach);
};

}    // namespace LAMMPS_NS
#endif
