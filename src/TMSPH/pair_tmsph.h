/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   pair_style tmsph: total-Lagrangian SPH forces over the reference bonds,
   with thermal bonds, hourglass control and artificial viscosity.
------------------------------------------------------------------------- */

#ifdef PAIR_CLASS
// clang-format off
PairStyle(tmsph,PairTMSPH);
// clang-format on
#else

#ifndef LMP_PAIR_TMSPH_H
#define LMP_PAIR_TMSPH_H

#include "fix_tmsph_bond.h"
#include "pair.h"
#include "tmsph_averaging.h"
#include "tmsph_bond_rows.h"
#include "tmsph_box.h"
#include "tmsph_coupling.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_materials.h"
#include "tmsph_notes.h"
#include "tmsph_own_side.h"
#include "tmsph_participants.h"
#include "tmsph_pressed_surfaces.h"
#include "tmsph_run_report.h"
#include "tmsph_shape.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/** Own-side Cauchy stress and displacement gradient of the local particles. */
struct TMSPHFields {
  const double *stress;      ///< [nlocal][TMSPH::STRESS_ROW]
  const double *gradient;    ///< [nlocal][dimension*dimension], F - I over all bonds
};

class TMSPHOpenings;
struct TMSPHBondState;

class PairTMSPH : public Pair, public TMSPHMaterials, public TMSPHParticipants, public TMSPHNotes {
 public:
  PairTMSPH(class LAMMPS *);
  ~PairTMSPH() override;
  void compute(int, int) override;
  void settings(int, char **) override;
  void coeff(int, char **) override;
  void init_style() override;
  double init_one(int, int) override;
  void write_restart(FILE *) override;
  void read_restart(FILE *) override;
  void write_restart_settings(FILE *) override;
  void read_restart_settings(FILE *) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  double memory_usage() override;

  bool touching(int itype, int jtype) const override
  {
    return contact && contact->touching(itype, jtype);
  }
  const double *step_velocity(int i) const override { return rows.step_velocity(i); }
  void exchange_comes() override { the_box.meet_exchange(); }
  void run_begins() override;
  void run_ends() override { run_report.end(); }

  FixTMSPHBond *bonds() const { return bond_fix; }
  TMSPHBox &box() { return the_box; }
  /// between particles, from the size of the largest family
  double spacing() const;
  /// mean distance of the particles of a type to their nearest bonded partners, as reported last;
  /// 0 if there are none
  double spacing_of(int type) const { return run_report.present().of(type).spacing; }
  /// F - I of the local particles in the last force evaluation, [nlocal][dimension*dimension];
  /// only with a contact set
  const double *step_gradient() const { return gradient.data(); }
  /// false for a local particle with too few bonds for a deformation gradient, see update_shape()
  template <int D> bool bears_stress(int i) const
  {
    return *bond_fix->layout().constants<D>(i) != 0.0;
  }
  /// what the last force evaluation worked on
  TMSPHBondState bond_state();
  /// true if the dilatation of this type is averaged
  bool averages(int type) const { return averaging.averages(type); }
  /// power that viscosity took at local particles in the last force evaluation, to be called before
  /// the next exchange; 0 without viscosity
  void viscous_heat(std::vector<double> &power);
  /** For outputs, also between runs, when much may have changed (collective).
      @param who to be named in an error
      @return    the present pair style, whose bonds are laid out and whose ghosts are where their
                 owners are; else an error */
  static PairTMSPH *laid_out(class LAMMPS *lmp, const std::string &who);
  /// of the present positions, valid until the next call of the pair style
  TMSPHFields fields();
  /// largest stable time step of the present state, by power iteration (collective)
  double stable_timestep();

 private:
  TMSPH::Features on;
  TMSPH::Viscosity viscosity;
  FixTMSPHBond *bond_fix = nullptr;
  TMSPHBox the_box;
  TMSPHGhostSender ghosts;
  TMSPHBondWatch prepared;    // layout that all below belongs to
  TMSPHBondRows rows;
  std::vector<double> stress, gradient;    // [nlocal+nghost][STRESS_ROW], [nlocal][D*D]

  TMSPHAveraging averaging;
  TMSPHCoupling coupling;
  TMSPHOwnSide own_side;
  TMSPHPressedSurfaces pressed;
  TMSPHRunReport run_report;

  void allocate();
  std::string features() const;
  bool opens() const;
  template <int D> void prepare();
  template <int D> void evaluate();
  template <int D> void find_gradients(TMSPH::GradientOutput, bool keep);
  template <int D> void find_stresses(bool inverted_breaks);
  template <int D> void test_bonds();
  template <int D> void reshape(const std::vector<int> &touched);
  template <int D> void follow(const std::vector<int> &touched);
  template <int D> void complete_rows();
  template <int D> void find_forces(const TMSPH::Viscosity &, double *f, int stride);
  template <int D> void add_virial();
  template <int D> void add_energy();
  template <int D> double estimate_timestep();
};

}    // namespace LAMMPS_NS

#endif
#endif
