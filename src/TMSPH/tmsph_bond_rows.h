/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The two rows that the sweeps read at both ends of a bond, of local and ghost
   particles: from LAMMPS's arrays, and to ghosts.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOND_ROWS_H
#define LMP_TMSPH_BOND_ROWS_H

#include "fix_tmsph_bond.h"
#include "tmsph_box.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_materials.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHBondRows : protected Pointers {
 public:
  TMSPHBondRows(class LAMMPS *lmp, TMSPHGhostSender &ghosts, const TMSPHBox &box) :
      Pointers(lmp), ghosts(ghosts), box(box)
  {
  }
  double *kinematic() { return kinematic_row.data(); }
  double *force() { return force_row.data(); }
  template <int D> double *force(int i) { return force() + (size_t) i * TMSPH::Rows<D>::FORCE; }

  /// after an exchange of particles: references and constants
  template <int D> void lay_out(const TMSPHMaterials &, const FixTMSPHBond &);
  /// displacements of all particles, and thermal strains if there are any; an error if one of those
  /// leaves nothing of its particle
  template <int D> void move(const TMSPHMaterials &, bool heated);
  /// velocities of local particles: those of a step or of its setup, none while minimizing
  template <int D> void take_velocities(const FixTMSPHBond &);
  /// the former ones; nullptr if the rows hold others
  const double *step_velocity(int i) const;
  /** Displacements of push times the trial vector from the present positions, on ghosts too, and
      "rate" times that as velocities. */
  template <int D> void try_move(const std::vector<double> &trial, double push, double rate);
  template <int D> std::vector<double> velocities() const;
  template <int D> void put_velocities(const std::vector<double> &);
  /// the first columns of the force rows
  template <int D> void send_forces(int columns);
  /// while LAMMPS packs: adds to velocities under way what the change of the box does
  void add_rate(int n, const int *list, double *buf, const int *pbc) const;
  double bytes() const
  {
    return (kinematic_row.capacity() + force_row.capacity()) * sizeof(double);
  }

 private:
  TMSPHGhostSender &ghosts;
  const TMSPHBox &box;
  std::vector<double> kinematic_row, force_row;    // [nlocal+nghost][Rows::...]
  bool stepped = false;                            // the velocities are those of a step or setup
  bool box_moves = false;                          // and those of ghosts need the rate of the box
  bool sends_velocities = false;                   // to such ghosts, just now
};

}    // namespace LAMMPS_NS

#endif
