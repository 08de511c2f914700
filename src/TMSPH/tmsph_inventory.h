/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What there is of each type: particles, volumes, spacings.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_INVENTORY_H
#define LMP_TMSPH_INVENTORY_H

#include "fix_tmsph_bond.h"
#include "tmsph_materials.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {

class TMSPHInventory : protected Pointers {
 public:
  struct Type {
    bigint particles = 0;
    std::array<double, 5> material{};
    double volume = 0.0;                 // of all of them
    double spacing = 0.0, cell = 0.0;    // means of nearest distances, of d-th powers
  };

  explicit TMSPHInventory(class LAMMPS *lmp) : Pointers(lmp) {}
  /// true if numbers or materials of the types are not those of the last time (collective)
  bool measure(const TMSPHMaterials &, const FixTMSPHBond &);
  const Type &of(int type) const { return types[type]; }
  /// a table of them in the log
  void tell(const TMSPHMaterials &, double thickness) const;

 private:
  std::vector<Type> types;    // as measured last
};

}    // namespace LAMMPS_NS

#endif
