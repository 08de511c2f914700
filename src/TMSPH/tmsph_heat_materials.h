/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Thermal properties of the types of fix tmsph/heat.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_MATERIALS_H
#define LMP_TMSPH_HEAT_MATERIALS_H

#include "atom.h"
#include "pointers.h"
#include "tmsph_property_table.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHHeatMaterials : protected Pointers {
 public:
  explicit TMSPHHeatMaterials(class LAMMPS *lmp) : Pointers(lmp), materials(atom->ntypes + 1) {}

  /// what follows the words of this name
  void read_conductivity(class TMSPHValues &);
  void read_specific_heat(TMSPHValues &);
  /// an error if one lacks a property, or some do not go together
  void check();

  /// some conductivity depends on temperature
  bool has_tables() const { return tables; }
  bool orthotropic(int type) const { return materials[type].orthotropic; }
  /// [3][3] in the frame of the reference positions, if orthotropic
  const double *tensor(int type) const { return materials[type].tensor; }
  /// the largest principal value, if orthotropic
  const TMSPH::PropertyTable &conductivity(int type) const { return materials[type].conductivity; }
  const TMSPH::PropertyTable &specific_heat(int type) const
  {
    return materials[type].specific_heat;
  }

  /// of a local or ghost particle at its temperature
  double conductivity_of(int i) const { return conductivity(atom->type[i])(atom->temperature[i]); }
  /// the same along a direction of unit length
  double conductivity_of(int i, const double *direction) const;
  /// energy per mass
  double enthalpy(int i, double temperature) const;
  double temperature(int i, double enthalpy) const
  {
    return specific_heat(atom->type[i]).temperature_at(enthalpy);
  }
  /// energy of the local particles
  double content() const;

 private:
  struct Material {
    TMSPH::PropertyTable conductivity, specific_heat;
    bool orthotropic = false;
    double tensor[9] = {};
  };
  std::vector<Material> materials;    // by type
  bool tables = false;

  TMSPH::PropertyTable read_property(const char *name, TMSPHValues &) const;
  void read_tensor(TMSPHValues &, Material &) const;
};

}    // namespace LAMMPS_NS

#endif
