/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/heat: conduction of heat over the intact reference bonds.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/heat,FixTMSPHHeat);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_HEAT_H
#define LMP_FIX_TMSPH_HEAT_H

#include "fix.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_heat_clock.h"
#include "tmsph_lattice_faces.h"
#include "tmsph_own_surface.h"
#include "tmsph_property_table.h"
#include "tmsph_report.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixTMSPHHeat : public Fix, public TMSPHHeatClock, public TMSPHReporter {
 public:
  /// heat that one particle exchanges with what is outside the body
  struct Exchange {
    int i;                         ///< local index
    double conductance, outside;   ///< power conductance (outside - T_i)
    double power;                  ///< and what does not depend on T_i
  };
  /// a piece of the surface and the local particle below it, which may have several
  struct SurfaceShare {
    int i;
    TMSPH::Surface surface;
    double area;
    bool flat;                     ///< a face of a body on a lattice
  };
  /// mean power in the last advance and energy so far that a boundary or the sources brought
  struct Account {
    double power = 0.0, energy = 0.0;
  };

  FixTMSPHHeat(class LAMMPS *, int, char **);
  ~FixTMSPHHeat() override;
  int setmask() override;
  void post_constructor() override;
  void init() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  void tell() override;
  int reach(int most, double /*largest_change*/) override { return most; }
  int advance(int most, double largest_change) override;

  /** The surface of the body as its reference bonds show it (collective).
      @param cracks bonds that are gone count as surface too
      @return       in the order of the particles */
  std::vector<SurfaceShare> surface(bool cracks);
  /// of the material of local particle i at its temperature, along a direction of unit length
  double conductivity(int i, const double *direction) const;
  class FixTMSPHBond *bonds_of_body() const { return bonds; }
  /// the time step of the next heat step
  bigint next_step() const;
  /// energy per mass of local particle i
  double enthalpy(int i, double temperature) const;
  /// this processor's share of what a boundary that holds temperatures brought
  void bring(const class FixTMSPHHeatBoundary *, double energy);
  /// this processor's share
  Account account(const class FixTMSPHHeatBoundary *) const;

 private:
  // one-sidedness inside an irregular cloud, at least: with spacings that vary by a few thousandths
  static constexpr double IRREGULAR = 1.0e-3;

  struct Substance {
    TMSPH::PropertyTable conductivity, specific_heat;
    bool orthotropic = false;
    double principal[9] = {};      // conductivity tensor in the frame of the reference positions
    double calibrated[9] = {};     // what makes a lattice conduct like it
    double source = 0.0;           // power per volume
    std::string source_variable;
  };
  class PairTMSPH *pair;
  class FixTMSPHBond *bonds;
  // columns of the store: c, depth below an interface or 0, see fix_tmsph_heat_evening.cpp
  enum { NORM, DEPTH, MULTIPLIER };
  class FixStoreAtom *norms;       // they are frozen when the bonds formed
  std::string norms_id;
  std::vector<Substance> substances;    // by type
  bool rkl2, tables;               // some conductivity depends on temperature
  int every;
  double time_scale;
  std::vector<std::vector<double>> gap;    // conductance of closed cracks by type and type, or 0
  bool crosses;                    // any of them is not 0
  bool friction, viscous;          // their work heats
  bool told;

  std::vector<class FixTMSPHHeatBoundary *> boundaries;
  int version, removals;           // of the bonds when the conductances were found
  std::vector<float> conductances; // [row][8], without the conductivity if there are tables
  std::vector<double> conductivities;    // of local and ghost particles, with tables
  std::vector<double> all_norms, all_depths;    // of local and ghost particles
  bool evened;                     // the body is irregular
  std::vector<double> multipliers[3];    // then, of local and ghost particles, by component
  bool faced;                      // the body has flat faces
  static constexpr int NONE = -1;
  std::vector<int> face_row;       // [nmax] of local and ghost particles in faces, or NONE
  std::vector<double> faces;       // [row][dimension][layer_size()], see fix_tmsph_heat_storage.cpp
  std::vector<double> sums;        // sum_j G_ij of local particles, at the largest conductivity
  TMSPHGhostSender ghosts;
  int face_sent;                   // number of a face that goes to ghosts, or NONE

  // of the advance that goes on. The energies of the accounts are stages of the same scheme as
  // the temperatures, so that what is gained and lost adds up to the last digits

  struct Bridge {
    int i, j;                      // a local particle, and a local or ghost one
    double conductance;
  };
  std::vector<Bridge> bridges;     // across closed cracks and between bodies
  std::vector<Exchange> exchanges, rubbed;    // in the latter energies instead of powers
  std::vector<int> first_exchange; // of each boundary, then of friction
  static constexpr int NOT_HELD = -1;
  std::vector<int> held;           // [nlocal] boundary that gives the temperature, or NOT_HELD
  std::vector<double> source_of;   // power per volume of local particles, if any
  std::vector<double> power;       // of local particles
  bool heats, cools;               // sources or fluxes that move the bounds of the temperatures
  double stable, covered;          // explicit step; time covered so far
  double fastest;                  // largest rate of a temperature in the last advance
  int comfortable;                 // steps of an advance that kept to its largest change
  bigint applications;             // of the operator, so far
  std::vector<Account> accounts;   // of the boundaries, then of all sources
  std::vector<std::string> account_ids;    // of the boundaries; none after a restart
  double former_energy;            // of boundaries that are gone
  int source_account() const { return boundaries.size(); }

  void open_accounts();
  void parse(int, char **);
  int parse_by_type(const std::string &word, int, int, char **);
  int parse_conductivity(int, int, char **, Substance &);
  void parse_contact(char **);
  void parse_setting(const std::string &word, const char *value);
  void check_words();
  void find_norms();
  void find_depths();
  std::vector<double> stored(int column) const;
  /// what the bonds of a particle that it lacks would bring
  struct Pull {
    TMSPH::Surface surface;
    double area = 0.0;             // 0: the particle is inside
    double conducted[3] = {};      // the same with the conductances in force, times the normal
    double one_sidedness = 0.0;    // see there
    bool outermost = false;
  };
  template <int D> std::vector<Pull> pull_of_bonds(bool cracks);
  std::vector<Pull> pulls(bool cracks);
  void smooth(std::vector<Pull> &, double least);
  std::vector<char> near_surface(const std::vector<Pull> &);
  double interior_noise(const std::vector<Pull> &, const std::vector<char> &near) const;
  template <int D> void find_layers(const std::vector<char> &near, std::vector<double> &second);
  template <int D> void drop_steps(std::vector<double> &rough);
  int layer_size() const;
  int faces_size() const;
  const double *faces_of(int i) const;
  int count_faces(int i) const;
  double *make_faces(int i);
  void drop_all_faces();
  void tidy_faces();
  template <int D> TMSPH::Layer<D> layer(int i, int k) const;
  template <int D> double boost(int i, const double *X) const;
  template <int D> bool share_faces(int i, const Pull &, bool cracks, std::vector<SurfaceShare> &);
  void share_layers();
  bool corrected(int i, int j) const;
  double correction(int i, int j, const double *X) const;
  template <int D> void calibrate(int type, const std::vector<char> &near);
  template <int D> void even_out();
  double evening(int i, int j, const double *X) const;
  void share_multipliers();
  template <int D> void find_conductances();
  void drop_conductances();
  void follow();
  void attempt(double duration, std::vector<double> &y);
  void commit(double duration, const std::vector<double> &y);
  void collect_friction();
  void prepare(double duration);
  void evaluate_sources();
  void find_bridges();
  void step(double duration, std::vector<double> &y);
  void super_step(double duration, std::vector<double> &y);
  void euler_step(double duration, std::vector<double> &y);
  void rates(const std::vector<double> &y, std::vector<double> &rate);
  void put_temperatures(const std::vector<double> &y);
  double content() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
