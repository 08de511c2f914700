/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a fix offers that acts on a body from outside: to fix tmsph/heat, which
   conducts heat in the body.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_BOUNDARY_H
#define LMP_TMSPH_HEAT_BOUNDARY_H

#include <vector>

namespace LAMMPS_NS {

/** Heat that one particle exchanges with what is outside the body. */
struct TMSPHHeatExchange {
  int i;                          ///< local index
  double conductance, outside;    ///< power conductance (outside - T_i)
  double power;                   ///< and what does not depend on T_i
};

struct TMSPHHeatBoundary {
  /// true if it sets the temperature of its particles themselves
  virtual bool holds_temperature() const = 0;
  /// sets the temperature of local and ghost particles of the group
  virtual void hold_temperature() = 0;
  /// what the particles at the surface exchange now; appends (collective)
  virtual void list_exchanges(std::vector<TMSPHHeatExchange> &) = 0;
  /// with its id and group
  virtual const class Fix &fix() const = 0;

  bool has_account = false;    ///< in the books of fix tmsph/heat

 protected:
  ~TMSPHHeatBoundary() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

#endif
