/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   min_style tmsph/lbfgs: limited-memory BFGS that judges steps by forces.
------------------------------------------------------------------------- */

#ifdef MINIMIZE_CLASS
// clang-format off
MinimizeStyle(tmsph/lbfgs,MinTMSPHLBFGS);
// clang-format on
#else

#ifndef LMP_MIN_TMSPH_LBFGS_H
#define LMP_MIN_TMSPH_LBFGS_H

#include "min.h"
#include "tmsph_lbfgs.h"
#include "tmsph_preconditioner.h"

#include <functional>

namespace LAMMPS_NS {

class MinTMSPHLBFGS : public Min {
 public:
  MinTMSPHLBFGS(class LAMMPS *);
  void init() override;
  void setup_style() override;
  void reset_vectors() override;
  int modify_param(int, char **) override;
  int iterate(int) override;
  double memory_usage() override { return preconditioner.memory_usage(); }

  /** Looks for equilibrium on the present time step, without output and energies.
      @param norm      Euclidean norm of all forces to reach
      @param evaluations most force evaluations
      @param after     called after each iteration
      @return true if it was reached */
  bool equilibrate(double norm, bigint evaluations, const std::function<void()> &after);
  /// forces in the present positions, which may have been moved
  void update_forces();
  /// energies and virials too, if the present time step asks for them
  void update_all();
  /// what earlier iterations have learned does not hold any more
  void forget() { lbfgs.forget(); }
  /// Euclidean norm of all forces, the same on any number of processors
  double force_norm();
  bigint evaluations() const { return total_evaluations; }
  /// a vector of three components for each local particle that goes with it, n = 0 or 1
  double *extra_vector(int n) { return fix_vector(EXTRA + n); }

 private:
  /// vectors of the particles
  enum { START, DIRECTION, FORMER, SCALED, EXTRA, HISTORY = EXTRA + 2 };
  TMSPH::LBFGS lbfgs;
  TMSPHPreconditioner preconditioner;
  class PairTMSPH *pair;
  double longest;    // no particle moves farther in an iteration, 0: not yet known
  bool with_energy;
  bigint total_evaluations;

  double usual_longest() const;
  double *fix_vector(int);
  double dot(const TMSPH::LBFGS::Vector &, const TMSPH::LBFGS::Vector &);
  double largest(const double *);
  void evaluate();
  double try_length(double);
  int step();
};

}    // namespace LAMMPS_NS

#endif
#endif
