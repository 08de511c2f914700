/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The reference configuration: positions in the frame of the present images,
   vectors between particles, weights of bonds, spacing.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_REFERENCE_GEOMETRY_H
#define LMP_TMSPH_REFERENCE_GEOMETRY_H

#include "lmptype.h"
#include "tmsph_bond_user.h"

#include <cstddef>
#include <vector>

namespace LAMMPS_NS {

class TMSPHReferenceGeometry {
 public:
  explicit TMSPHReferenceGeometry(class LAMMPS *lammps) : lammps(lammps) {}

  /// reference position of a local or ghost particle, in the frame of its present image
  const double *reference(int i) const { return xref.data() + 3 * (size_t) i; }
  /// and in the box in which the bonds formed
  void reference_in_box(int i, double *X) const;
  /// where that begins, and its length if it is periodic in this direction, else 0
  double reference_corner(int k) const { return corner[k]; }
  double reference_period(int k) const { return period[k]; }
  /// X_j - X_i, the nearest image, the same to the last bit (but for sign) from both ends
  void reference_vector(int i, int j, double *X) const;
  /// the same of two reference positions as particles store them
  void reference_vector(const double *from, const double *to, double *X) const;
  double reference_distance(int i, int j) const;
  /// V_j W_ij, the part of j in a mean at i; that of i itself with j = i
  double kernel_mass(int i, int j, double horizon) const;
  /// W_ij = V_i V_j w_ij, whatever has become of the bond
  float weight(int i, int j) const;
  /// edge of the cell of a local or ghost particle, in 2-D in the plane
  double spacing(int i) const;
  /// that the volumes imply in 2-D, else 1; w_ij sums up in proportion to it
  double body_thickness() const { return thickness; }
  /// tr K/D of the interior when the bonds formed
  double interior_kappa() const { return kappa; }
  /// horizon with which they formed, the largest
  double reach() const { return horizon; }

 protected:
  TMSPHBondUser *user = nullptr;
  double horizon = 0.0;
  std::vector<double> type_horizons;    // and that of each type
  double kappa = 0.0, thickness = 1.0;
  double period[3] = {}, corner[3] = {};    // of the reference box

  /// periods and corner from the present box
  void take_box();
  /// of the local particles, with room for those of ghosts
  void place_local();
  int pack_references(int n, const int *list, double *buf, int pbc_flag, const int *pbc) const;
  void unpack_references(int n, int first, const double *buf);
  /// true if there is one for each local and ghost particle
  bool all_placed() const;
  /// image of the particle with this id that is nearest to local particle i, or -1
  int find_image(int i, tagint id) const;
  double bytes_of_references() const { return xref.capacity() * sizeof(double); }

 private:
  class LAMMPS *lammps;
  std::vector<double> xref;    // [nlocal+nghost][3]
};

}    // namespace LAMMPS_NS
#endif
