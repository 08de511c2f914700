/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Heat where surfaces touch: it crosses closed cracks and goes from body to body,
   and friction heats.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_CONTACTS_H
#define LMP_TMSPH_HEAT_CONTACTS_H

#include "pointers.h"
#include "tmsph_heat_boundary.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHConductionNorms;
class TMSPHHeatMaterials;
class TMSPHParticipants;

class TMSPHHeatContacts : protected Pointers {
 public:
  struct Bridge {
    int i, j;    ///< a local particle, and a local or ghost one
    double conductance;
  };

  explicit TMSPHHeatContacts(class LAMMPS *lmp);
  /// TYPES TYPES and the conductance of a closed crack per area that follow "contact"
  void read(class TMSPHValues &);
  void set_friction(bool heats) { friction = heats; }
  void init(TMSPHParticipants *);
  /// an error if nothing knows what touches
  void check() const;

  /// finds anew what conducts (collective)
  void find_bridges(const TMSPHHeatMaterials &, const TMSPHConductionNorms &);
  const std::vector<Bridge> &bridges() const { return found; }
  /// energies that friction took since the last call (collective)
  void collect_friction();
  /// spread over a time; appends
  void list_friction(double duration, std::vector<TMSPHHeatExchange> &) const;

 private:
  TMSPHParticipants *others = nullptr;
  std::vector<std::vector<double>> gap;    // conductance per area by type and type, or 0
  bool crosses = false;                    // any of them is not 0
  bool friction = false;                   // its work heats
  std::vector<Bridge> found;
  struct Rubbed {
    int i;
    double energy;
  };
  std::vector<Rubbed> rubbed;
};

}    // namespace LAMMPS_NS

#endif
