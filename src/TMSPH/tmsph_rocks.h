/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What an input says of how the types break: their criterion, strengths that
   scatter, energies of cracks; and what follows for a particle. Which bonds
   break is decided elsewhere, in fix_tmsph_break.h.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_ROCKS_H
#define LMP_TMSPH_ROCKS_H

#include "atom.h"
#include "pointers.h"
#include "tmsph_criterion.h"
#include "tmsph_ghost_rows.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;
class TMSPHMaterials;

class TMSPHRocks : protected Pointers {
 public:
  struct Rock {
    double strength = 0.0;
    double modulus = 0.0;    // Weibull; 0: no scatter
    int seed = 0;
    double energy = 0.0;       // G_f of a crack; 0: bonds break at once
    double toughness = 0.0;    // K_Ic in place of it, or 0
    double tensile = 0.0;      // uniaxial tensile strength/strength, set at init
  };

  TMSPHRocks(class LAMMPS *, std::unique_ptr<TMSPH::Criterion>);
  /// words of the criterion, and those that all of them share
  void read(const std::string &style, char **next, char **last);
  /// in the init of a fix
  void init(const TMSPHMaterials &);

  const TMSPH::Criterion &criterion() const { return *law; }
  const Rock &of(int type) const { return rocks[type]; }
  /// true if bonds between the two types are tested as those of one
  bool alike(int type, int other) const
  {
    return one_rock || type == other || law->alike(type, other);
  }
  /// uniaxial, without scatter; without a type the smallest
  double tensile_strength(int type) const;
  double tensile_strength() const;
  /// true if bonds of this type open before they are gone, those of any type
  bool opens(int type) const { return rocks[type].energy > 0.0 || rocks[type].toughness > 0.0; }
  bool any_opens() const;
  /// G, E' and E G/tensile^2 of its cracks
  double crack_energy(int type) const;
  double crack_modulus(int type) const;
  double characteristic_length(int type) const;

  /** Draws strengths for the ids of the present particles, once in a layout of the bonds
      (collective). All below needs them.
      @return true if the layout is new */
  bool follow(const FixTMSPHBond &, TMSPHGhostSender &);
  /// of particle i as the criterion's first word gives it, and its uniaxial tensile strength
  double strength(int i) const { return strengths[i]; }
  double tensile_strength_of(int i) const { return strengths[i] * rocks[atom->type[i]].tensile; }

  // of local or ghost particles, with a row of stress as the sweeps have it

  TMSPH::Principals principals(int i, const double *row) const;
  /// in bond (i, j), from the rows of its ends and their mean
  TMSPH::Principals principals(int i, int j, const double *row_i, const double *row_j,
                               const double *mean) const;
  bool fails(int i, const double *row) const;
  double load_factor(int i, const TMSPH::Principals &p) const
  {
    return law->load_factor(atom->type[i], atom->type[i], p, strengths[i]);
  }
  /// of a stress xx yy zz xy xz yz
  double load_factor_of_all(int i, const double *stress) const;
  double bytes() const { return strengths.capacity() * sizeof(double); }

 private:
  std::unique_ptr<TMSPH::Criterion> law;
  std::vector<Rock> rocks;    // by type
  bool all_principals = false, one_rock = true;
  const TMSPHMaterials *materials = nullptr;    // since init
  int version = -1;                             // layout that strengths belong to
  std::vector<double> strengths;                // [nlocal+nghost] drawn

  void read_weibull(class TMSPHValues &);
  TMSPH::Principals principals(const double *row, double zz) const;
  bool may_fail(int i, const double *row) const;
};

}    // namespace LAMMPS_NS
#endif
