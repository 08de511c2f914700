/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Forces across the interfaces of nearly incompressible materials: see
   tmsph_interface.h. A fit across such an interface would mix the strains of
   both sides, and lambda times its error would be many times the stress.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_COUPLING_H
#define LMP_TMSPH_COUPLING_H

#include "fix_tmsph_bond.h"
#include "tmsph_averaging.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_interface.h"
#include "tmsph_materials.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {

class TMSPHCoupling : protected Pointers {
 public:
  TMSPHCoupling(class LAMMPS *lmp, const TMSPHMaterials &materials, const TMSPHAveraging &averaging,
                TMSPHGhostSender &ghosts) :
      Pointers(lmp),
      materials(materials), averaging(averaging), ghosts(ghosts)
  {
  }
  /// after that of averaging
  void init();
  /// there are such interfaces
  bool on() const { return averaging.couples(); }
  /// after an exchange of particles: the bonds across leave the sweeps
  void lay_out(FixTMSPHBond &);
  /// local particles that lost a bond, ascending
  void follow(const FixTMSPHBond &, const std::vector<int> &touched);
  /** Forces of the bonds across, and what they put into the force rows through the gradients of
      both sides.
      @param kinematic rows of local and ghost particles
      @param gradients H of the local particles in the present force evaluation */
  template <int D>
  void find_forces(const FixTMSPHBond &, TMSPH::ThermalStrain, const double *kinematic,
                   const double *gradients, double *force_row);
  template <int D> void add_forces(double *f, int stride) const;
  template <int D> void add_virial(const double *kinematic, double *each, double *total) const;
  void add_energy(double &total, double *each) const;
  double bytes() const { return rows.bytes(); }
  int doubles_per_ghost() const;

 private:
  struct Crossing {    // a local particle with bonds across
    struct Bond {
      int k, j;            // number in the family, index of the partner
      double stiffness;    // c W_ij, 0: broken
      std::array<double, 3> force;
    };
    int i;
    double depth = 0.0, energy = 0.0;    // energy: its half
    std::array<double, 3> force{};
    std::vector<Bond> bonds;
  };

  const TMSPHMaterials &materials;
  const TMSPHAveraging &averaging;
  TMSPHGhostSender &ghosts;
  TMSPH::InterfaceDepth depth_of;
  std::vector<Crossing> crossing;
  TMSPHGhostRows rows;    // [D*D + 1] G and the depth; 0: no gradient

  void update(const FixTMSPHBond &, Crossing &) const;
  template <int D> void fill_rows(const FixTMSPHBond &, bool bond_mode, const double *gradients);
  template <int D> TMSPH::Matrix<D, double> find_force(Crossing &, const double *kinematic) const;
};

}    // namespace LAMMPS_NS

#endif
