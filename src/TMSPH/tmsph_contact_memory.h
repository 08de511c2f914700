/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a particle with contacts remembers of its last step, and how it travels.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_MEMORY_H
#define LMP_TMSPH_CONTACT_MEMORY_H

#include "tmsph_contact_pair.h"
#include "tmsph_memories.h"

#include <cstdint>
#include <vector>

namespace LAMMPS_NS {

struct TMSPHContactMemory {
  /** What a pair remembers, at both ends. */
  struct Record {
    tagint partner = 0;
    TMSPH::ContactPast past = {};
    TMSPH::PairGeometry geometry = {};    // without normals until its surface is found
    bool parted = false;    // they went out of each other's reach; if they come back they meet anew
    bool has_surface() const { return !geometry.faceless(); }
  };
  /** Where friction is zero, of a particle that touches a segment: along it from its first end and
      to its left, in its lengths. */
  struct Anchor {
    tagint start, end;
    double along, left;
  };
  /** A pair that presses, as heat needs it. */
  struct Pressed {
    tagint partner;
    double weight, distance;
  };

  double force[3] = {}, stress[6] = {};    // by contact; part of the Cauchy stress
  double tilt[9] = {};                     // moments f x of what bonds have to balance
  std::uint64_t stamp = 0;                 // fingerprint at the end of the run
  std::vector<Record> records;             // of the reference family, ascending partners
  std::vector<Record> met;                 // of those that met later, ascending partners
  std::vector<Anchor> anchors;             // of the segments that it touches
  double apart = 0.0;    // from the other body's outline in the reference; 0: not within reach
  std::vector<Pressed> pressed;    // ascending partners; only for heat
  double rubbed = 0.0;             // only for heat: friction's work not yet taken

  /// doubles that pack() writes
  static int size(int nrecords, int nmet, int nanchors, int npressed);
  int size() const;
  int pack(double *) const;
  int unpack(const double *);
  /// nullptr if this partner is not in the reference family, or was not when pairs were listed
  const Record *record_of(tagint partner) const;
  bool has_met(tagint partner) const;
  /** Particles have new ids.
      @param present   the present id of the one with a former id, 0 of one that is gone
      @param was,is    own ids, former and present
      @param dimension of the simulation */
  void follow_ids(const TMSPHPresentIds &present, tagint was, tagint is, int dimension);
};

using TMSPHContactMemories = TMSPHMemories<TMSPHContactMemory>;

}    // namespace LAMMPS_NS
#endif
