/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What the breaking of bonds asks of a failure criterion, and how a law becomes one.
   A law is a struct, the constants of one rock but for its strength, with
     TITLE, STRENGTH       how the report at the start calls it and its strength
     words()               the constants that users give; the first is the strength, a stress,
                           which may scatter
     Law(values)           from their values in that order
     fails(p, strength)    true if the state is at or beyond failure
     load_factor(p, strength)   o: the stress divided by o is just at failure, so that o >= 1 is
                           failure
     may_fail(m, reach, strength)   a cheap, safe bound: false only if fails() is
     ==, mean(law, law)    for bonds between two rocks
   The safe states must form a convex set around the stress-free one that scales with the strength:
   a bond between two safe ends is then safe with the means of both.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CRITERION_H
#define LMP_TMSPH_CRITERION_H

#include "tmsph_principal.h"

#include <cmath>
#include <memory>
#include <vector>

namespace TMSPH {

/** A constant of a rock, as users give it. */
struct CriterionWord {
  const char *name;
  double standard;    ///< value without the word; REQUIRED: it must be given
  bool (*allows)(double value);
  const char *rule;    ///< what allows() asks, for the error
};

constexpr double REQUIRED = HUGE_VAL;

/** A failure criterion with the rocks of all types. Stresses come in tension positive, strengths in
    the unit of the stresses. A bond has the types of both ends, a particle its own twice. */
class Criterion {
 public:
  virtual ~Criterion() = default;
  virtual const char *title() const = 0;
  virtual const char *strength_name() const = 0;
  virtual const std::vector<CriterionWord> &words() const = 0;
  /// values in the order of words(); types from 1 on, in ascending order
  virtual void add(const std::vector<double> &values) = 0;
  /// true if the two types differ in nothing but strength
  virtual bool alike(int type, int other) const = 0;
  virtual bool fails(int type, int other, const Principals &, double strength) const = 0;
  virtual double load_factor(int type, int other, const Principals &, double strength) const = 0;
  /** @param reach the largest principal stress is at most mean + reach sqrt(deviation2): 1 in the
                 plane, 2/sqrt(3) in 3-D */
  virtual bool may_fail(int type, const Invariants &, double reach, double strength) const = 0;
};

template <class Law> class CriterionOf : public Criterion {
 public:
  const char *title() const override { return Law::TITLE; }
  const char *strength_name() const override { return Law::STRENGTH; }
  const std::vector<CriterionWord> &words() const override { return Law::words(); }
  void add(const std::vector<double> &values) override { rocks.emplace_back(values); }
  bool alike(int type, int other) const override { return rock(type) == rock(other); }
  bool fails(int type, int other, const Principals &p, double strength) const override
  {
    return of(type, other).fails(p, strength);
  }
  double load_factor(int type, int other, const Principals &p, double strength) const override
  {
    return of(type, other).load_factor(p, strength);
  }
  bool may_fail(int type, const Invariants &m, double reach, double strength) const override
  {
    return rock(type).may_fail(m, reach, strength);
  }

 private:
  std::vector<Law> rocks;
  const Law &rock(int type) const { return rocks[type - 1]; }
  Law of(int type, int other) const
  {
    return type == other ? rock(type) : mean(rock(type), rock(other));
  }
};

}    // namespace TMSPH
#endif
