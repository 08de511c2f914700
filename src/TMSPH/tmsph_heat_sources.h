/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Heat that arises in the particles of a type: a number, or a variable.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_SOURCES_H
#define LMP_TMSPH_HEAT_SOURCES_H

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHHeatSources : protected Pointers {
 public:
  explicit TMSPHHeatSources(class LAMMPS *lmp);
  /// TYPES and the value that follow "source"
  void read(class TMSPHValues &);
  /// an error if a variable cannot be asked
  void check() const;
  /// @param next time step on which variables will be asked again
  void evaluate(bigint next);

  /// power per volume of local particles, as evaluated last; nothing if there are no sources
  const std::vector<double> &power() const { return powers; }
  /// any of this processor is above 0, or below
  bool heat() const { return any_above; }
  bool cool() const { return any_below; }
  double bytes() const { return powers.capacity() * sizeof(double); }

 private:
  struct Source {
    double power = 0.0;      // per volume
    std::string variable;    // its name, or nothing
  };
  std::vector<Source> sources;    // by type
  std::vector<double> powers;
  bool any_above = false, any_below = false;
};

}    // namespace LAMMPS_NS

#endif
