/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The fixes that take part in the force evaluations of the pair style.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PARTICIPANTS_H
#define LMP_TMSPH_PARTICIPANTS_H

#include "tmsph_break_test.h"
#include "tmsph_surface_contact.h"

namespace LAMMPS_NS {

/** Each says so in its init(), in every run anew. */
class TMSPHParticipants {
 public:
  void set_break_test(TMSPHBreakTest *test) { break_test = test; }
  bool bonds_may_break() const { return break_test != nullptr; }
  /// nullptr where all bonds break at once
  class TMSPHOpenings *openings() const { return break_test ? break_test->openings() : nullptr; }
  void set_contact(TMSPHSurfaceContact *given) { contact = given; }
  /// nullptr without one
  TMSPHSurfaceContact *contact_of_surfaces() const { return contact; }
  /// see TMSPHSurfaceContact::states(); 0 without contact
  unsigned states_in_contact() const { return contact ? contact->states() : 0u; }
  /// of a fix that needs touches() or rubbings(): contact keeps them during this run
  void heat_crosses_contacts() { contact_serves_heat = true; }
  bool keeps_touches() const { return contact_serves_heat; }

 protected:
  TMSPHBreakTest *break_test = nullptr;
  TMSPHSurfaceContact *contact = nullptr;

  /// before the fixes are initialized
  void forget_participants()
  {
    break_test = nullptr;
    contact = nullptr;
    contact_serves_heat = false;
  }

 private:
  bool contact_serves_heat = false;
};

}    // namespace LAMMPS_NS

#endif
