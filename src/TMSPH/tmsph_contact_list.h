/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which pairs of particles are in contact, and what each of their ends
   remembers.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_LIST_H
#define LMP_TMSPH_CONTACT_LIST_H

#include "pointers.h"
#include "tmsph_contact_memory.h"
#include "tmsph_contact_scene.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHContactList : protected Pointers {
 public:
  /** Of bodies without bonds, of faces of a crack or a cut, or not in the reference but later. */
  enum class Meeting { BODIES, FACES, LATER };
  /** Two particles, at least one of them local, computed once. */
  struct Pairing {
    int low, high;    // by id
    Meeting meeting;
    bool both_local;           // two ends have it
    bool has_surface;          // else its surface is yet to be found
    TMSPH::ContactPast now;    // what they remember, ahead of them: see write_back()
    TMSPH::ContactPair pair;
  };
  /** One end of a pair, at a local particle. */
  struct End {
    int j, pairing;
    bool low;      // it has the lower id
    bool later;    // it remembers the pair as one that met later, else of the family,
    int place;     // in this place
  };
  struct Member {
    int i;              // local particle
    int memory;         // number of what it remembers
    int first, last;    // its ends, by ascending partner
  };
  /** A pair whose surfaces are found anew, and the former ones. */
  struct Refit {
    int pairing;
    TMSPH::ContactPair before;
  };

  TMSPHContactList(class LAMMPS *lmp, const TMSPHContactScene &scene,
                   TMSPHContactMemories &memories) :
      Pointers(lmp),
      scene(scene), memories(memories)
  {
  }

  std::vector<Member> members;
  std::vector<End> ends;    // of each member by ascending partner
  std::vector<Pairing> pairings;
  std::vector<Refit> refits;    // since they were taken last
  bool anywhere = false;        // pairs on any processor
  bool new_faces = false;       // pairs of families without a surface, on any processor

  /** Lists them again, after an exchange of particles and when bonds have gone (collective). What
      is remembered of particles and pairs that are not listed any more is forgotten.
      @param outlines nullptr, or those of method segment, whose particles are members too
      @param touched  nullptr, or all local particles that lost a bond since the last time, where
                      nothing else has changed
      @return         most doubles that a particle takes in restarts, on any processor */
  int make(const class TMSPHContactOutlines *outlines, const std::vector<int> *touched);
  /// bond k of local particle i goes, open: its pair begins without force
  void opened(int i, int k);
  /** The surfaces of pairs of families were found anew: they are remembered, those that are others
      now, or begin without force, are noted. */
  void take_surfaces(const std::vector<Pairing> &before);

  TMSPHContactMemory &memory(const Member &m) { return memories[m.memory]; }
  /// the pairings know more than their ends from here on
  void run_ahead() { ahead = true; }
  /// what ends remember, before it is needed: they are far apart in memory
  void write_back();
  double bytes() const;

 private:
  const TMSPHContactScene &scene;
  TMSPHContactMemories &memories;
  bool ahead = false;
  // ids of ends whose bonds went open, low and high
  std::vector<std::pair<tagint, tagint>> fresh;

  int list_members(const class TMSPHContactOutlines *, const std::vector<int> &candidates);
  std::vector<int> list_records(int i, const TMSPHContactMemory &before,
                                std::vector<TMSPHContactMemory::Record> &) const;
  void list_ends(int i, const TMSPHContactMemory &, const std::vector<int> &partners);
  int room(const TMSPHContactMemory &) const;
  TMSPHContactMemory::Record &record(const Member &, const End &);
  void add_pairing(const Member &, End &);
};

}    // namespace LAMMPS_NS
#endif
