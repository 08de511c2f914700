/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a fix for contact of surfaces offers the pair style and the fix for heat.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_SURFACE_CONTACT_H
#define LMP_TMSPH_SURFACE_CONTACT_H

#include "tmsph_families.h"

#include <vector>

namespace LAMMPS_NS {

/** Its forces come after those of the bonds. */
struct TMSPHSurfaceContact {
  /// true if particles of these types, which are not bonded, may touch
  virtual bool touching(int itype, int jtype) const = 0;
  /// bit 1<<state for each state of a family that it sees to
  virtual unsigned states() const = 0;
  /// true if bodies touch in pairs of their families; else its forces reach the outermost
  bool over_horizon() const { return states() >> TMSPHFamilies::UNBONDED & 1u; }
  /// doubles that it sends per ghost and step where surfaces may touch
  virtual int doubles_per_ghost() const = 0;

  /// bond k of local particle i is about to go, open: its faces begin without force
  virtual void opened(int i, int k) = 0;
  /// pairs that touched in the last force evaluation, on all processors (collective)
  virtual double touching_pairs() = 0;

  /** Two particles that pressed on each other in the last force evaluation. */
  struct Touch {
    int i, j;           ///< a local particle, and a local or ghost one
    double weight;      ///< V_i V_j w_ij as the contact took it
    double distance;    ///< of the two along the normal when the surfaces just touch
  };
  /// friction took this energy at local particle i since the last call: half of that of its pairs
  struct Rubbing {
    int i;
    double work;
  };
  /** By ascending i, then by the partners' ids; a pair of two local particles comes twice. Only
      if heat crosses contacts, see TMSPHParticipants. Both survive exchanges and restarts, and are
      collective calls. */
  virtual void touches(std::vector<Touch> &) = 0;
  virtual void rubbings(std::vector<Rubbing> &) = 0;

 protected:
  ~TMSPHSurfaceContact() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

#endif
