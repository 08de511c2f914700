/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of the own side of an interface between two materials, for output and
   for the breaking of bonds.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OWN_SIDE_H
#define LMP_TMSPH_OWN_SIDE_H

#include "atom.h"
#include "fix_tmsph_bond.h"
#include "tmsph_sweep.h"

#include <Eigen/Dense>
#include <vector>

namespace LAMMPS_NS {

/** Particles with bonds to another material: their reported stress comes from the bonds to their
    own; a phase one particle thick falls back to all bonds. */
class TMSPHOwnSide {
 public:
  /** After an exchange of particles, when the bonds have their constants.
      @param kinematic rows of local and ghost particles */
  template <int D> void lay_out(const FixTMSPHBond &, const Atom &, const double *kinematic);
  /// local particle i lost a bond, and has new constants
  template <int D> void follow(int i, const FixTMSPHBond &, const Atom &, const double *kinematic);
  /// stress, and gradient if that is asked for, of these particles in place of those over all bonds
  template <int D>
  void find_stress(const TMSPH::Features &on, const double *kinematic,
                   const TMSPH::GradientOutput &out) const;
  /// true if local particle i has bonds to another material
  bool has(int i) const { return lane[i] >= 0; }
  /// g of its bond k in the gradient sum_k u'_k g_k^T
  template <int D> Eigen::Matrix<double, D, 1> fit_vector(int i, int k) const
  {
    const size_t row = slices.offset[lane[i] / TMSPH::LANES] + k;
    Eigen::Matrix<double, D, 1> g;
    for (int a = 0; a < D; a++)
      g[a] = slices.fit[(row * D + a) * TMSPH::LANES + lane[i] % TMSPH::LANES];
    return g;
  }
  /** A copy of the gradients of all local particles, for those of find_stress().
      @return nullptr where no particle has bonds to another material */
  double *start_gradients(const std::vector<double> &whole)
  {
    if (slices.count()) gradients_here = whole;
    return slices.count() ? gradients_here.data() : nullptr;
  }
  /// as they were found last
  double *gradients() { return slices.count() ? gradients_here.data() : nullptr; }
  double bytes() const
  {
    return slices.bytes() + lane.capacity() * sizeof(int) +
        gradients_here.capacity() * sizeof(double);
  }

 private:
  TMSPH::Slices slices;
  std::vector<int> lane;                 // [nlocal] in the slices, or -1
  std::vector<double> gradients_here;    // [nlocal*D*D] where asked for

  template <int D> void fill(int i, const FixTMSPHBond &, const Atom &, const double *kinematic);
  template <int D> void fit(int q, int l, bool one_sided, double spacing, const double *kinematic);
};

}    // namespace LAMMPS_NS

#endif
