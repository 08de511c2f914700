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
#include "tmsph_cohesion.h"
#include "tmsph_criterion.h"
#include "tmsph_ghost_rows.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
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
    double weakest = 1.0;      // of its bonds, to other types, over what the types make it
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
    return one_rock || type == other || (law->alike(type, other) && !of_pair(type, other));
  }
  /// bonds between them have values of their own
  bool of_pair(int type, int other) const { return between.count(std::minmax(type, other)); }
  /// uniaxial, without scatter, of bonds between two types; without types the smallest of all
  double tensile_strength(int type, int other) const;
  double tensile_strength() const;
  /// over the mean of both
  double strength_factor(int type, int other) const;
  /// true if bonds between two types open before they are gone, those of a type with any, any
  bool opens(int type, int other) const;
  bool opens(int type) const;
  bool any_opens() const;
  /// G, E' and E G/tensile^2 of cracks between two types
  double crack_energy(int type, int other) const;
  double crack_modulus(int type, int other) const;
  double characteristic_length(int type, int other) const;
  const TMSPH::CohesiveLaw &softening() const { return cohesion; }

  /** Draws strengths for the ids of the present particles, once in a layout of the bonds
      (collective). All below needs them.
      @return true if the layout is new */
  bool follow(const FixTMSPHBond &, TMSPHGhostSender &);
  /// of particle i as the criterion's first word gives it, and its uniaxial tensile strength
  double strength(int i) const { return strengths[i]; }
  /// of their bond
  double strength(int i, int j) const
  {
    const int type = atom->type[i], other = atom->type[j];
    const double mean = 0.5 * (strengths[i] + strengths[j]);
    return type == other ? mean : strength_factor(type, other) * mean;
  }
  double tensile_strength_of(int i) const { return strengths[i] * rocks[atom->type[i]].tensile; }
  /// of their bond, where the energies of cracks scatter as the strengths, over that of the types
  double energy_factor(int i, int j) const;
  double tensile_strength_of(int i, int j) const
  {
    const int type = atom->type[i], other = atom->type[j];
    const double mean = 0.5 * (tensile_strength_of(i) + tensile_strength_of(j));
    return type == other ? mean : strength_factor(type, other) * mean;
  }
  /// of its weakest bonds, to particles that are as strong
  double weakest_tensile_strength_of(int i) const
  {
    return tensile_strength_of(i) * rocks[atom->type[i]].weakest;
  }

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
  /** Given for bonds between two types; 0: by those. */
  struct Between {
    double energy = 0.0, toughness = 0.0, tensile = 0.0;
  };
  std::unique_ptr<TMSPH::Criterion> law;
  TMSPH::CohesiveLaw cohesion;
  bool energies_scatter = false;
  std::vector<Rock> rocks;                           // by type
  std::map<std::pair<int, int>, Between> between;    // the lower type first
  bool all_principals = false, one_rock = true;
  const TMSPHMaterials *materials = nullptr;    // since init
  int version = -1;                             // layout that strengths belong to
  std::vector<double> strengths;                // [nlocal+nghost] drawn

  void read_weibull(class TMSPHValues &);
  void read_between(class TMSPHValues &);
  Between given(int type, int other) const;
  TMSPH::Principals principals(const double *row, double zz) const;
  bool may_fail(int i, const double *row) const;
};

}    // namespace LAMMPS_NS
#endif
