/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Averaged dilatation of nearly incompressible materials: who averages, and the
   pressures. tmsph_dilatation.h has the equations.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_AVERAGING_H
#define LMP_TMSPH_AVERAGING_H

#include "fix_tmsph_bond.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_materials.h"
#include "tmsph_shape.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHAveraging : protected Pointers {
 public:
  TMSPHAveraging(class LAMMPS *lmp, const TMSPHMaterials &materials, TMSPHGhostSender &ghosts) :
      Pointers(lmp), materials(materials), ghosts(ghosts)
  {
  }
  /// who averages, the same on all processors; an error if that is not enough
  void init();
  /// some material averages
  bool on() const { return averaging; }
  bool averages(int type) const;
  /// a material that averages is bonded to another one: these two, any
  bool coupled(int itype, int jtype) const;
  bool couples() const { return coupling; }

  /// of a local particle in the sweeps; where dilatations are averaged, lambda acts on the mean
  TMSPH::ParticleConstants constants(int i, double thickness) const;
  /// after an exchange of particles
  void lay_out(FixTMSPHBond &) const;
  /** Mean dilatations and pressures (positive in tension) of the local particles.
      @param gradients H of the local particles in the present force evaluation */
  template <int D>
  void find_pressures(const FixTMSPHBond &, TMSPH::ThermalStrain, const double *gradients);
  /// the pressures enter the force rows
  template <int D>
  void add_to_forces(const FixTMSPHBond &, const double *gradients, double *force_row) const;
  /// and the stresses, which belong to these gradients
  template <int D>
  void add_to_stress(TMSPH::ThermalStrain, const double *gradients, double *stress) const;
  /// lambda/2 thetabar^2 of the local particles, times their volumes
  void add_energy(double &total, double *each) const;
  double bytes() const
  {
    return (exchanged.capacity() + mean_dilatation.capacity() + pressure.capacity()) *
        sizeof(double);
  }
  int doubles_per_ghost() const { return 2 * averaging; }

 private:
  const TMSPHMaterials &materials;
  TMSPHGhostSender &ghosts;
  bool averaging = false, coupling = false;
  std::vector<double> exchanged;                    // [nlocal+nghost] theta, then lambda thetabar
  std::vector<double> mean_dilatation, pressure;    // [nlocal]
};

}    // namespace LAMMPS_NS

#endif
