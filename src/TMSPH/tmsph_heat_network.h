/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The network of conductances that the bonds of a body are to heat,
   tmsph_conduction.h, and what it is made of.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_NETWORK_H
#define LMP_TMSPH_HEAT_NETWORK_H

#include "fix_tmsph_bond.h"
#include "pointers.h"
#include "tmsph_body_surface.h"
#include "tmsph_bond_user.h"
#include "tmsph_conductance_balance.h"
#include "tmsph_conduction_norms.h"
#include "tmsph_flat_faces.h"
#include "tmsph_ghost_rows.h"

#include <array>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHHeatMaterials;

class TMSPHHeatNetwork : protected Pointers {
 public:
  TMSPHHeatNetwork(class LAMMPS *, const TMSPHHeatMaterials &, TMSPHGhostSender &);
  /// @param id of the fix whose it is
  void keep(const std::string &id) { norms_of_bonds.keep(id); }
  void init(const FixTMSPHBond *, const TMSPHBondUser *, const class TMSPHParticipants *);

  /// at a setup: finds what stays as it was when the bonds formed, unless it is known (collective)
  void form();
  /// after an exchange of particles all conductances are found anew; bonds that have gone since no
  /// longer conduct, those that open the less the farther they do (collective)
  void follow();
  /// power that the bonds bring to local particles, at the temperatures of these and of ghosts
  void conduct(const double *temperature, double *power);

  /// sum_j G_ij of local particles, at the largest conductivity
  const std::vector<double> &sums() const { return sum_of; }
  const TMSPHConductionNorms &norms() const { return norms_of_bonds; }
  /// they migrate with the particles of the fix
  TMSPHFlatFaces &faces() { return flat_faces; }
  const TMSPHFlatFaces &faces() const { return flat_faces; }
  const TMSPHBodySurface &surface() const { return body_surface; }
  const FixTMSPHBond &owner_of_bonds() const { return *bonds; }
  double bytes() const;

  // restart: nine doubles for each type and type 0

  void append_to(std::vector<double> &list) const;
  void take_from(const double *list);
  int restart_length() const { return 9 * (int) calibrated.size(); }

 private:
  const TMSPHHeatMaterials &materials;
  const FixTMSPHBond *bonds = nullptr;
  const TMSPHParticipants *others = nullptr;
  TMSPHBondWatch watch;
  TMSPHGhostSender &ghosts;
  TMSPHConductionNorms norms_of_bonds;
  TMSPHFlatFaces flat_faces;
  TMSPHConductanceBalance balance;
  TMSPHBodySurface body_surface;

  std::vector<std::array<double, 9>> calibrated;    // by type: what makes a lattice conduct like it
  std::vector<float> conductances;       // [row][8], without the conductivity if there are tables
  std::vector<double> conductivities;    // of local and ghost particles, with tables
  std::vector<double> sum_of;

  bool corrected(int i, int j) const { return balance.any() || flat_faces.beside(i, j); }
  double correction(int i, int j, const double *X) const;
  template <int D> void calibrate(int type, const std::vector<char> &near);
  template <int D> void find_conductances(const std::vector<int> &particles);
};

}    // namespace LAMMPS_NS

#endif
