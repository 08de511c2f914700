/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Who is bonded to whom: ids of partners and the states of the bonds, as they
   are stored for each local particle, and what bonds and particles carry
   besides for those who asked for it.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_FAMILIES_H
#define LMP_TMSPH_FAMILIES_H

#include "lmptype.h"
#include "tmsph_bond_values.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHFamilies {
 public:
  /// UNBONDED: never was a bond, but the two may be in contact
  enum State : unsigned char { INTACT = 0, BROKEN = 1, CUT = 2, UNBONDED = 3 };
  /// sets of states: bonds that hold, all that ever were bonds, the whole family
  static constexpr unsigned WHOLE = 1u << INTACT;
  static constexpr unsigned FORMED = WHOLE | 1u << BROKEN | 1u << CUT;
  static constexpr unsigned ALL = FORMED | 1u << UNBONDED;

  int count(int i) const { return npartner[i]; }
  /// members of the family in these states, at hand or not
  int count_in(int i, unsigned states) const;
  tagint partner_tag(int i, int k) const { return partner[at(i, k)]; }
  State bond_state(int i, int k) const { return (State) state[at(i, k)]; }
  /// id that local particle i had when the bonds formed; reset_atoms does not change it
  tagint first_id(int i) const { return first_tag[i]; }
  /// State of local particle i towards the particle with this id, or -1 if they are no family
  int state_with(int i, tagint id) const;
  /// true if an intact bond joins local particle i to the particle with this id
  bool joined(int i, tagint id) const { return state_with(i, id) == INTACT; }

  /** What particles or bonds carry under a name: found, if a restart file brought it or it was asked
      for before, else new. It lives as long as the bonds. To be called on all processors. */
  TMSPHParticleValues &particle_values(const std::string &name, int width);
  TMSPHBondValues &bond_values(const std::string &name, int width);
  /// true if one of the first n particles has bonds that carry something under this name
  bool bonds_carry(const std::string &name, int n) const;

  /// id of the particle at the last setup, NOBODY as long as it has no family
  static constexpr tagint NOBODY = 0;
  tagint owner_tag(int i) const { return own_tag[i]; }
  void set_owner_tag(int i, tagint id) { own_tag[i] = id; }
  /// renamed(id): the present id of a partner, or NOBODY if it is forgotten
  template <class Rename> void rename(int i, Rename renamed);

 protected:
  /// rows for so many bonds, of nmax particles; what was stored is lost
  void resize_rows(int length, int nmax);
  int row_length() const { return maxpartner; }
  /// the family of the particle with this id as it forms; members by ascending ids
  void set_family(int i, tagint id, const std::vector<std::pair<tagint, State>> &members);
  void set_state(int i, int k, State to) { state[at(i, k)] = to; }
  void drop_carried(int i, int k)
  {
    for (auto &values : of_bonds) values->erase(i, k);
  }
  void grow_rows(int nmax);
  void copy_row(int i, int j);
  void clear_row(int i);
  int pack_row(int i, double *buf) const;
  int unpack_row(int i, const double *buf, int nmax);
  int row_size(int i) const;    // doubles that pack_row() writes,
  int most_of_row() const;      // and at most
  double bytes_of_rows() const;
  /// names of what is carried, for the global part of a restart file
  std::vector<double> list_carried() const;
  void take_carried(const char *list, int nmax);

 private:
  int maxpartner = 1;                  // length of the rows
  std::vector<int> npartner;           // bonds at formation, less those of deleted particles
  std::vector<tagint> partner;         // [nmax][maxpartner] ids, ascending
  std::vector<unsigned char> state;    // [nmax][maxpartner]
  std::vector<tagint> own_tag;         // id of the particle at the last setup
  std::vector<tagint> first_tag;       // id when its bonds formed: it draws the random numbers
  std::vector<std::unique_ptr<TMSPHParticleValues>> of_particles;
  std::vector<std::unique_ptr<TMSPHBondValues>> of_bonds;

  size_t at(int i, int k) const { return (size_t) maxpartner * i + k; }
};

template <class Rename> void TMSPHFamilies::rename(int i, Rename renamed)
{
  std::vector<std::pair<tagint, int>> kept;
  for (int k = 0; k < npartner[i]; k++) {
    const tagint id = renamed(partner[at(i, k)]);
    if (id != NOBODY) kept.emplace_back(id, k);
  }
  std::sort(kept.begin(), kept.end());
  const std::vector<unsigned char> former(&state[at(i, 0)], &state[at(i, 0)] + npartner[i]);
  std::vector<int> places(npartner[i], -1);
  npartner[i] = kept.size();
  for (int k = 0; k < npartner[i]; k++) {
    places[kept[k].second] = k;
    partner[at(i, k)] = kept[k].first;
    state[at(i, k)] = former[kept[k].second];
  }
  for (auto &values : of_bonds) values->move(i, places);
}

}    // namespace LAMMPS_NS
#endif
