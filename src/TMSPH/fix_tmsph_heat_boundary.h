/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/heat/boundary: prescribed temperature of particles; temperature,
   flux, convection or radiation at the surface of a body that conducts heat.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/heat/boundary,FixTMSPHHeatBoundary);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_HEAT_BOUNDARY_H
#define LMP_FIX_TMSPH_HEAT_BOUNDARY_H

#include "fix_tmsph_heat.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_heat_boundary.h"

namespace LAMMPS_NS {

class FixTMSPHHeatBoundary :
    public Fix,
    public TMSPHHeatBoundary,
    public TMSPHHeatClock,
    public TMSPHReporter {
 public:
  FixTMSPHHeatBoundary(class LAMMPS *, int, char **);
  ~FixTMSPHHeatBoundary() override;
  int setmask() override;
  void post_constructor() override;
  void init() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  void min_pre_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override { return values.capacity() * sizeof(double); }
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;

  bool holds_temperature() const override { return body; }
  void hold_temperature() override;
  void list_exchanges(std::vector<TMSPHHeatExchange> &) override;
  const Fix &fix() const override { return *this; }
  int reach(int, double) override;
  void tell() override;

 private:
  TMSPHGhostSender ghosts;
  enum Kind { TEMPERATURE, FLUX, CONVECTION, RADIATION } kind;
  enum Place { UNDECIDED, BODY, SURFACE } place;
  bool body;               // place as decided at init
  double value;            // temperature or flux in force
  double coefficient;      // film coefficient, or emissivity times Stefan's constant
  double absolute_zero;    // of the temperature scale
  std::string variable;    // name of that of equal or atom style that gives the value, or empty
  int variable_index;
  std::vector<double> values;    // of local particles, of an atom-style variable

  std::string region_id;    // its surface is that of the body
  double given_area;        // of the whole surface of the group, or 0
  bool one_sided;           // only faces that look in this direction
  double direction[3];
  bool cracks;    // bonds that are gone make surface
  class FixTMSPHHeat *heat;
  class FixStoreAtom *store;    // area, depth, normal of each particle, in the reference positions
  std::string store_id;
  bool found;              // the surface; it is kept, but for cracks
  TMSPHBondWatch watch;    // of what was gone when it was found

  void parse(int, char **);
  void read_direction(class TMSPHValues &);
  FixTMSPHHeat *conduction() const;
  void evaluate();
  void find_surface();
  void add(const TMSPHSurfacePiece &);
};

}    // namespace LAMMPS_NS

#endif
#endif
