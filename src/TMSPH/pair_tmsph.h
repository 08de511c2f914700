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

#include "atom.h"
#include "fix_tmsph_bond.h"
#include "pair.h"
#include "tmsph_box.h"
#include "tmsph_dilatation.h"
#include "tmsph_interface.h"
#include "tmsph_materials.h"
#include "tmsph_notes.h"
#include "tmsph_participants.h"
#include "tmsph_presses.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PairTMSPH : public Pair,
                  public TMSPHMaterials,
                  public TMSPHParticipants,
                  public TMSPHNotes {
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
  bool viscous() const override { return on.viscosity; }
  const double *step_velocity(int i) const override;
  void exchange_comes() override { the_box.meet_exchange(); }
  void run_begins() override;
  void run_ends() override;

  /// number of stress components per particle in fields(): xx yy xy, or xx yy zz xy xz yz
  int stress_size() const;
  /// F - I of the local particles in the last force evaluation, [nlocal][dimension*dimension];
  /// only with a contact set
  const double *step_gradient() const { return gradient.data(); }
  /// false for a local particle with too few bonds for a deformation gradient, see update_shape()
  template <int D> bool bears_stress(int i) const { return *own_constants<D>(i) != 0.0; }
  bool expands() const { return on.thermal != TMSPH::ThermalStrain::NONE; }
  /// power that viscosity took at local particles in the last force evaluation, to be called before
  /// the next exchange; 0 without viscosity
  void viscous_heat(std::vector<double> &power);
  /// between particles, from the size of the largest family
  double spacing() const;
  /// mean distance of the particles of a type to their nearest bonded partners, as reported last;
  /// 0 if there are none
  double spacing_of(int type) const { return present[type].spacing; }
  FixTMSPHBond *bonds() const { return bond_fix; }
  TMSPHBox &box() { return the_box; }
  /** For outputs, also between runs, when much may have changed (collective).
      @param who to be named in an error
      @return    the present pair style, whose bonds are laid out and whose ghosts are where their
                 owners are; else an error */
  static PairTMSPH *laid_out(class LAMMPS *lmp, const std::string &who);

  /** Own-side Cauchy stress and displacement gradient of the local particles in their present
      positions. Both are owned by the pair style and valid until its next call. */
  struct Fields {
    const double *stress;      ///< [nlocal][stress_size()]
    const double *gradient;    ///< [nlocal][dimension*dimension], F - I over all bonds
  };
  Fields fields();
  /// small-strain share of the strain energy that bond k of local particle i carries at a stress
  double bond_energy(int i, int k, const double *stress) const;
  /// largest stable time step of the present state, by power iteration (collective)
  double stable_timestep();

 private:
  TMSPH::Features on;
  TMSPH::Viscosity viscosity;
  FixTMSPHBond *bond_fix;
  int coefficients;                               // grows with pair_style and pair_coeff

  // of the stable time step: what it was estimated for last, and its value
  int coefficients_at_estimate;
  bigint bonds_at_estimate;
  double mass_at_estimate, stiffness_at_estimate;    // see matter()
  double stable_dt, intact_dt;    // now, and before bonds broke
  bool reported, reported_timestep;
  struct Present {                                // of a type, as reported last
    bigint particles = 0;
    std::array<double, 5> material{};
    double volume = 0.0;                          // of all of them
    double spacing = 0.0, cell = 0.0;             // means of nearest distances, of d-th powers
  };
  std::vector<Present> present;                   // [type]

  bool stepped;                                   // the rows hold the velocities of a step or setup
  bool box_moves;                                 // and those of ghosts need the rate of the box
  TMSPHBox the_box;
  int prepared_version;                           // layout that the arrays below belong to
  std::vector<double> kinematic, force_row;       // [nlocal+nghost][Rows::...]
  std::vector<double> stress, gradient;
  std::vector<double> rows;                       // virials or energies of particles, on demand
  TMSPH::Slices own_side;                         // particles with bonds to other materials
  std::vector<int> own_side_lane;                 // [nlocal] lane in own_side, or -1
  std::vector<int> touched;

  // averages at pressed surfaces, once a surface may be pressed
  struct Near {
    int j;
    double mass;                                  // V_j W_ij
  };
  struct Span {
    int first = 0, last = 0;                      // of those near a particle; 0: not listed
  };
  struct Member {
    int i;
    double part;                                  // of the average that it reports
  };
  struct Across {
    int i, k, ghost;                              // a local particle and its bond to a ghost
  };
  struct Surfaces {
    int trusted = 0;                              // calls until it is asked who is pressed
    int version = -1;                             // layout that all the rest belongs to
    std::vector<double> rows;                     // [nlocal+nghost][pressed_width()]; 0: nothing
    std::vector<int> sharing, touching;           // local particles with a row: outermost, by pairs
    std::vector<Member> members;
    std::vector<double> change;                   // of the stress of each
    std::vector<Near> near;
    std::vector<Span> spans;                      // [nlocal]
    std::vector<Across> across;
    std::vector<char> listed;                     // [nlocal]
  } surfaces;

  // averaged dilatation
  bool averaging;                                 // some material averages
  std::vector<double> exchanged;                  // [nlocal+nghost] theta, then lambda thetabar
  std::vector<double> mean_dilatation, pressure;  // [nlocal]

  // its interfaces
  bool coupling;                                  // a material that averages is bonded to another
  struct Crossing {                               // a local particle with bonds across
    struct Bond {
      int k, j;                                   // number in the family, index of the partner
      double stiffness;                           // c W_ij, 0: broken
      std::array<double, 3> force;
    };
    int i;
    double depth = 0.0, energy = 0.0;             // energy: its half
    std::array<double, 3> force{};
    std::vector<Bond> bonds;
  };
  std::vector<Crossing> crossing;
  std::vector<double> coupling_row;               // [nlocal+nghost][D*D + 1]
  TMSPH::InterfaceDepth interface_depth;

  enum { FORCE_ROWS, STRESS, DISPLACEMENT, AVERAGE, COUPLING, PRESSES } what_to_send;

  void allocate();
  TMSPH::Slices &slices();
  template <int D> void prepare();
  template <int D> void build_own_side();
  template <int D> void fill_own_side(int i);
  template <int D> void fit_own_side(int q, int l, bool one_sided);
  template <int D> void update_shape(TMSPH::Slices &, int q, int l);
  template <int D> void update_kinematics();
  template <int D> void update_velocities();
  template <int D> void evaluate();
  template <int D> void test_bonds();
  template <int D> void own_side_stress(bool inverted_breaks);
  void add_surface_stress();
  bool pressed(bool mine);
  void lay_out_surfaces();
  void drop_near(const std::vector<int> &touched);
  Span near(int i);
  void take_shares(const std::vector<TMSPHPresses::Share> &);
  void find_members();
  void average_surfaces();
  void average_pairs();
  void average(const double *stresses, int stride, bool pairs);
  void add_changes();
  double *pressed_row(int i) { return surfaces.rows.data() + (size_t) pressed_width() * i; }
  int pressed_width() const { return stress_size() + 2; }
  int doubles_of_pressed() const;    // sent per ghost and test of the bonds
  bool averaged(int type) const;
  void init_dilatation();
  void lay_out_averaging();
  template <int D> void find_pressures();
  template <int D> void add_pressures();
  template <int D> void add_pressure_to_stress(int i, const double *H);
  double dilatation_energy(int i) const;
  bool coupled(int itype, int jtype) const;
  template <int D> void lay_out_coupling();
  template <int D> void update_crossing(Crossing &);
  template <int D> void couple_materials();
  template <int D> void add_coupling_virial(double *each, double *total) const;
  template <int D> const double *own_constants(int i) const
  {
    using namespace TMSPH;
    return bond_fix->layout().own.data() + (size_t) (i / WIDTH) * CONSTANTS<D> * WIDTH + i % WIDTH;
  }
  template <int D> void complete_rows();
  template <int D>
  void bond_forces(const TMSPH::Viscosity &, double *f, int stride);
  void stop_inverted(int);
  void stop_thermal();
  template <int D> double stable_timestep_in();
  void check_timestep(const std::string &doubt);
  std::pair<double, double> matter() const;
  void report();
  bool measure();
  void tell_materials();
  std::string doubtful_material() const;
  std::string doubtful_horizon() const;
  std::string doubtful_volume() const;
  std::string doubtful_place() const;
  std::string doubts() const;
  void check_groups();
  void check_expansion();
  void check_reach() const;
  std::string features() const;     // what this scene uses, in words
  int doubles_per_ghost() const;    // sent by force evaluations
  void send(decltype(FORCE_ROWS));
  std::pair<double *, int> rows_to_send();
};

}    // namespace LAMMPS_NS

#endif
#endif
