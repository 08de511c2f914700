/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told and checked at the start of a run: size, features, their cost,
   materials and the stable time step.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RUN_REPORT_H
#define LMP_TMSPH_RUN_REPORT_H

#include "fix_tmsph_bond.h"
#include "tmsph_inventory.h"
#include "tmsph_materials.h"
#include "tmsph_notes.h"
#include "tmsph_participants.h"
#include "tmsph_timestep_check.h"

#include <functional>
#include <string>

namespace LAMMPS_NS {

class TMSPHRunReport : protected Pointers {
 public:
  /** Of the pair style in this run. */
  struct Facts {
    std::string features;     // what this scene uses, in words
    double bytes;             // of this processor
    int doubles_per_ghost;    // sent by force evaluations
    bool expands;
  };

  TMSPHRunReport(class LAMMPS *lmp, const TMSPHMaterials &materials,
                 const TMSPHParticipants &participants, TMSPHNotes &notes) :
      Pointers(lmp),
      materials(materials), participants(participants), notes(notes), inventory(lmp), timestep(lmp)
  {
  }
  /// materials or settings are others
  void forget_timestep() { timestep.forget(); }
  /// the forces of a setup are there (collective)
  /// @param estimate the stable step of the present state
  void begin(const FixTMSPHBond &, const Facts &, const std::function<double()> &estimate);
  /// a run or minimization is over
  void end();
  /// as it was at the start of this run, or of an earlier one
  const TMSPHInventory &present() const { return inventory; }

 private:
  const TMSPHMaterials &materials;
  const TMSPHParticipants &participants;
  TMSPHNotes &notes;
  TMSPHInventory inventory;
  TMSPHTimestepCheck timestep;
  bool reported = false, reported_timestep = false;

  void report(const FixTMSPHBond &, const Facts &);
};

}    // namespace LAMMPS_NS

#endif
