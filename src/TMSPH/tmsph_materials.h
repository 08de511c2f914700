/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What an input says of the solids: the words of pair_style, the materials of
   pair_coeff, and what follows from both for a particle.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_MATERIALS_H
#define LMP_TMSPH_MATERIALS_H

#include "atom.h"
#include "lammps.h"
#include "tmsph_bond_user.h"
#include "tmsph_settings.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHMaterials : public TMSPHBondUser {
 public:
  struct Material {
    double density = 0.0, reference_temperature = 0.0, expansion = 0.0;
    double young = 0.0, poisson = 0.0;
    double horizon = 0.0;      // 0: that of pair_style
    TMSPH::Elastic elastic;    // set at init, when dimension and plane state are known
    double hourglass = 0.0;    // coefficient of this type, set at init
  };

  explicit TMSPHMaterials(class LAMMPS *lammps) : lammps(lammps) {}

  TMSPH::Kernel kernel_of_bonds() const override { return chosen.kernel; }
  double horizon() const override { return chosen.horizon; }
  double horizon(int itype, int jtype) const override
  {
    const double one = materials[itype].horizon, other = materials[jtype].horizon;
    return 0.5 * ((one > 0.0 ? one : horizon()) + (other > 0.0 ? other : horizon()));
  }
  bool bonded(int itype, int jtype) const override { return are_bonded[itype][jtype]; }
  bool viscous() const override { return chosen.alpha1 > 0.0 || chosen.alpha2 > 0.0; }

  const TMSPHSettings &words() const { return chosen; }
  /// some type does
  bool expands() const { return some_expand; }
  const Material &material(int type) const { return materials[type]; }
  /// in the init of a fix: particles of this type need so much hourglass control
  void raise_hourglass(int type, double coefficient)
  {
    materials[type].hourglass = std::max(materials[type].hourglass, coefficient);
  }
  /// of longitudinal waves inside a solid
  static double wave_speed(const Material &m)
  {
    return std::sqrt(m.elastic.wave_modulus / m.density);
  }
  /// false if the waves in this type are too slow or too fast for any solid
  bool plausible(int type) const;
  /// types with the same constants are one material where strains are averaged
  bool same_material(int itype, int jtype) const;

  /// constants of a local or ghost particle: whoever computes with a particle asks here
  const TMSPH::Elastic &elastic(int i) const { return materials[lammps->atom->type[i]].elastic; }
  /// temperature above that without thermal strain
  double heating(int i) const
  {
    const Atom *const atom = lammps->atom;
    return atom->temperature[i] - materials[atom->type[i]].reference_temperature;
  }
  double thermal_strain(int i) const { return elastic(i).expansion * heating(i); }
  /// E a, what a particle puts into the mean that makes the thermal strain of a bond
  double thermal_push(int i) const
  {
    const TMSPH::Elastic &m = elastic(i);
    return m.young * m.expansion * heating(i);
  }
  /// stress along a surface/stress across it where the material cannot stretch along it
  double lateral_ratio(int i) const
  {
    const TMSPH::Elastic &m = elastic(i);
    return m.lambda / (m.lambda + 2.0 * m.shear);
  }
  /// out-of-plane Cauchy stress from the in-plane ones: zero in plane stress
  double stress_zz(int i, double sxx, double syy) const;

 protected:
  TMSPHSettings chosen;

  /// room for all types, without any material
  void allocate_materials();
  /// what follows pair_coeff I J elastic
  Material read_material(class TMSPHValues &) const;
  void set_material(int type, const Material &m) { materials[type] = m; }
  void set_bonded(int itype, int jtype, bool yes)
  {
    are_bonded[itype][jtype] = are_bonded[jtype][itype] = yes;
  }
  /// @param given [type][type] not 0: pair_coeff told
  void init_materials(int **given);
  /// masses and temperatures that were not given; those that were must agree with the materials
  /// @param formed bonds formed in an earlier run
  void complete_particles(bool formed) const;
  void write_materials(FILE *fp, int **given) const;
  void read_materials(FILE *fp, int **given);

 private:
  class LAMMPS *const lammps;
  std::vector<Material> materials;              // by type
  bool some_expand = false;                     // since init
  std::vector<std::vector<char>> are_bonded;    // by type and type
};

}    // namespace LAMMPS_NS

#endif
