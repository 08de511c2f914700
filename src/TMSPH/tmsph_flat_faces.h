/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The flat faces of bodies on lattices, found once when the bonds formed, and what
   they do to the conduction along them. Kept for the particles near faces only, as
   most are inside of the body; they go with their particles into exchanges and
   restarts, and after an exchange those of the ghosts are behind the own ones.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_FLAT_FACES_H
#define LMP_TMSPH_FLAT_FACES_H

#include "pointers.h"
#include "tmsph_bond_user.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_lattice_faces.h"

#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;

class TMSPHFlatFaces : protected Pointers {
 public:
  TMSPHFlatFaces(class LAMMPS *, TMSPHGhostSender &);
  void init(const FixTMSPHBond *, const TMSPHBondUser *);

  /** Finds those of the particles near a surface (collective).
      @param second sum_j V_j w R^2 becomes that of the lattice where faces are found */
  void find(const std::vector<char> &near, std::vector<double> &second);
  void drop_all();
  /// completes those of local particles by those of ghosts (collective)
  void complete();
  /// the body has some
  bool any() const { return faced; }
  /// near a local or ghost particle
  int count(int i) const;
  /// number k of a local or ghost particle
  template <int D> TMSPH::Layer<D> layer(int i, int k) const
  {
    TMSPH::Layer<D> found;
    found.take(row(i) + k * TMSPH::Layer<D>::SIZE);
    return found;
  }
  /// true if one of the two is near a face, else the following is 1
  bool beside(int i, int j) const { return face_row[i] != NONE || face_row[j] != NONE; }
  /// factor to the conductance of a bond with reference vector X from i to j
  double factor(int i, int j, const double *X) const;
  double bytes() const;

  // for the fix with whose particles they go

  void grow(int nmax);
  void copy(int i, int j) { face_row[j] = face_row[i]; }
  void clear(int i) { face_row[i] = NONE; }
  int size(int i) const { return 1 + count(i) * layer_size(); }    ///< doubles that pack() writes
  int most() const { return 1 + row_size(); }
  int pack(int i, double *buf) const;
  int unpack(int i, const double *buf);
  int layer_size() const;

 private:
  static constexpr int NONE = -1;
  TMSPHGhostSender &ghosts;
  const FixTMSPHBond *bonds = nullptr;
  const TMSPHBondUser *user = nullptr;
  bool faced = false;
  std::vector<int> face_row;    // [nmax] of local and ghost particles near faces, or NONE
  std::vector<double> rows;     // [row][dimension][layer_size()]

  int row_size() const;
  const double *row(int i) const
  {
    return face_row[i] == NONE ? nullptr : &rows[(size_t) face_row[i] * row_size()];
  }
  double *make_row(int i);
  void keep_local();
  void take_of_ghosts(const TMSPHGhostRows &sent, int k);
  template <int D> void find_layers(const std::vector<char> &near, std::vector<double> &second);
  template <int D> void drop_steps(std::vector<double> &rough);
  template <int D> double boost(int i, const double *X) const;
};

}    // namespace LAMMPS_NS

#endif
