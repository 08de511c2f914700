/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   From forces to displacements, roughly: each particle by its own stiffness,
   and the body as a whole on a coarse grid.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PRECONDITIONER_H
#define LMP_TMSPH_PRECONDITIONER_H

#include "pointers.h"
#include "tmsph_coarse_grid.h"
#include "tmsph_lbfgs.h"

#include <memory>

namespace LAMMPS_NS {

class TMSPHPreconditioner : protected Pointers {
 public:
  TMSPHPreconditioner(class LAMMPS *);
  /// builds the grid anew for the next use; without a pair style tmsph nothing is done to forces
  void init(class PairTMSPH *);
  /// replaces forces by displacements; where a force component is zero, the particle is held
  void apply(TMSPH::LBFGS::Vector &);
  double memory_usage() const;

 private:
  template <int D> struct Level {
    std::unique_ptr<TMSPH::CoarseGrid<D>> grid;
    std::vector<typename TMSPH::CoarseGrid<D>::Place> places;    // of local particles
  };

  class PairTMSPH *pair;
  int version;                       // layout that the arrays below belong to
  std::vector<double> compliance;    // of local particles
  double largest_compliance;
  int64_t held;    // components for which the grid was built
  int rebuilds;
  std::vector<int64_t> mine, all;
  Level<2> plane;
  Level<3> space;

  template <int D> Level<D> &level();
  template <int D> void make_grid();
  template <int D> void build(const double *forces);
  template <int D> void follow();
  template <int D> bool restrict(const TMSPH::LBFGS::Vector &, Eigen::VectorXd &);
  template <int D> void apply_in(TMSPH::LBFGS::Vector &);
};

}    // namespace LAMMPS_NS

#endif
