/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Limited-memory BFGS: search directions from the last steps and the changes
   of force over them. Nocedal and Wright, Numerical Optimization, 2nd ed.,
   Algorithm 7.4 (two loops), Eq. 7.20 (scale of the initial inverse Hessian).
   Vectors live with the caller, who may distribute and migrate them.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_LBFGS_H
#define LMP_TMSPH_LBFGS_H

#include <algorithm>
#include <cmath>
#include <vector>

namespace TMSPH {

class LBFGS {
 public:
  /** A vector, or the part of it that is here, and the largest magnitude of any of its
      components anywhere: what an order-independent sum needs. */
  struct Vector {
    double *at;
    double bound;
  };

  /// slots for so many pairs of a step and the change of minus the force over it
  explicit LBFGS(int memory) : step_bound(memory), change_bound(memory), work(memory) { forget(); }

  void forget() { used = 0, newest = -1; }
  int memory() const { return work.size(); }
  int known() const { return used; }
  /// where the next pair goes
  int next() const { return (newest + 1) % memory(); }

  /** Takes the pair in slot next().
      @param work_done step . change, positive
      @param scaled    change . P change, P the preconditioner */
  void take(double step_largest, double change_largest, double work_done, double scaled)
  {
    newest = next();
    used = std::min(used + 1, memory());
    step_bound[newest] = step_largest;
    change_bound[newest] = change_largest;
    work[newest] = work_done;
    scale = work_done / scaled;
  }

  /** Turns a force into a search direction.
      @param n            components here
      @param d            the force, replaced by the direction
      @param step,change  functions: slot to its vector
      @param dot          function: sum of products of two Vectors, over all parts
      @param precondition function: replaces a Vector by P times itself, bound included */
  template <class Step, class Change, class Dot, class Precondition>
  void direction(int n, Vector &d, Step step, Change change, Dot dot, Precondition precondition)
  {
    std::vector<double> a(memory());
    const auto add = [&](double factor, const double *v, double bound) {
      for (int i = 0; i < n; i++) d.at[i] += factor * v[i];
      d.bound += std::fabs(factor) * bound;
    };
    for (int age = 0; age < used; age++) {
      const int k = slot(age);
      a[k] = dot(Vector{step(k), step_bound[k]}, d) / work[k];
      add(-a[k], change(k), change_bound[k]);
    }
    precondition(d);
    if (used) {
      for (int i = 0; i < n; i++) d.at[i] *= scale;
      d.bound *= std::fabs(scale);
    }
    for (int age = used - 1; age >= 0; age--) {
      const int k = slot(age);
      const double b = dot(Vector{change(k), change_bound[k]}, d) / work[k];
      add(a[k] - b, step(k), step_bound[k]);
    }
  }

 private:
  int used, newest;
  double scale = 1.0;
  std::vector<double> step_bound, change_bound, work;

  int slot(int age) const { return (newest - age + memory()) % memory(); }
};

/** The next length to try on a line, from the slopes (force . direction) at its start and at
    "length": where their secant vanishes, within [least, most] times the length. */
inline double secant_length(double length, double slope_start, double slope, double least,
                            double most)
{
  const double fall = slope_start - slope;
  const double factor = fall > 0.0 ? slope_start / fall : most;
  return length * std::clamp(factor, least, most);
}

}    // namespace TMSPH
#endif
