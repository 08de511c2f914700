/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a fix that breaks bonds offers the pair style.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BREAK_TEST_H
#define LMP_TMSPH_BREAK_TEST_H

#include <vector>

namespace LAMMPS_NS {

/** Asked between the two sweeps of a step. */
struct TMSPHBreakTest {
  /// true if the bonds are to be tested in this force evaluation
  virtual bool due() const = 0;
  /** Breaks what is due.
      @param stress  own-side Cauchy stress of local and ghost particles, STRESS_ROW doubles each
      @param touched local particles that lost a bond are added to it */
  virtual void break_bonds(const double *stress, std::vector<int> &touched) = 0;
  /** Forces between particles that no bond joins any more, added to atom->f of local particles.
      @param virial six components to add to, or nullptr
      @return this processor's part of their energy */
  virtual double repel(double *virial) = 0;
  /// bonds that open, or nullptr where all break at once
  virtual class TMSPHOpenings *openings() = 0;
  /// removes the bonds that are fully open and may leave; local particles are added to touched
  virtual void remove_opened(std::vector<int> &touched) = 0;

 protected:
  ~TMSPHBreakTest() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

#endif
