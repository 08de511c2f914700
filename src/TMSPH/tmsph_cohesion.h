/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Cohesive opening of a bond: the traction t that its faces still carry falls
   from the strength to zero while they open by c along a normal. A law is a
   struct with
     NAME                    the word of the input
     traction(x)             T/t0 at the opening x = c/c_f, 1 at 0 and 0 at 1, never rising
     STEEPEST                largest -dT/dx
     area(x)                 its integral from 0 to x; area(1) is G_f/(t0 c_f)
     opening(q, k)           the c/c_f >= x0 where the falling branch T meets q - k c
   The energy that full opening takes is G_f = area(1) t0 c_f per area of the crack.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_COHESION_H
#define LMP_TMSPH_COHESION_H

#include "tmsph_alternatives.h"

#include <algorithm>

namespace TMSPH {

/** T = t0 (1 - c/c_f). */
struct LinearCohesion {
  static constexpr const char *NAME = "linear";
  static constexpr double STEEPEST = 1.0;
  static double traction(double x) { return std::max(0.0, 1.0 - x); }
  static double area(double x)
  {
    x = std::min(x, 1.0);
    return x - 0.5 * x * x;
  }
  /** Where t0 (1 - x) = q - k c_f x.
      @param q, k in units of t0 and t0/c_f
      @return  1 where the line lies above the law up to full opening */
  static double opening(double q, double k)
  {
    if (k <= 1.0) return 1.0;
    return std::min(1.0, std::max(0.0, (q - 1.0) / (k - 1.0)));
  }
};

/** Two lines, for concrete and rock (Petersson, Report TVBM-1006, Lund 1981): the kink lies at
    .8 G_f/t0 and t0/3, the end at 3.6 G_f/t0. */
struct BilinearCohesion {
  static constexpr const char *NAME = "bilinear";
  static constexpr double KINK = 0.8 / 3.6, LOW = 1.0 / 3.0, STEEPEST = (1.0 - LOW) / KINK;
  static double traction(double x)
  {
    if (x < KINK) return 1.0 - (1.0 - LOW) * x / KINK;
    return std::max(0.0, LOW * (1.0 - x) / (1.0 - KINK));
  }
  static double area(double x)
  {
    const double first = std::min(x, KINK), rest = std::min(x, 1.0) - KINK;
    double sum = first - 0.5 * (1.0 - LOW) / KINK * first * first;
    if (rest > 0.0) sum += LOW * (rest - 0.5 * rest * rest / (1.0 - KINK));
    return sum;
  }
  static double opening(double q, double k)
  {
    // The law is convex: its line from the kink on lies above the first one behind the kink, and the
    // straight line q - k x meets the larger of both first from above.

    const double steep = STEEPEST, flat = LOW / (1.0 - KINK);
    const double first = k > steep ? (q - 1.0) / (k - steep) : 2.0;
    if (first <= KINK) return std::max(0.0, first);
    const double second = k > flat ? (q - flat) / (k - flat) : 2.0;
    return std::min(1.0, std::max(KINK, second));
  }
};

using CohesiveLaw = std::variant<LinearCohesion, BilinearCohesion>;

/** What an opening bond remembers, the same at both ends. */
struct Opening {
  double strength = 0.0;    ///< t0, with which it began
  double end = 0.0;         ///< c_f, where it carries nothing any more
  double now = 0.0;         ///< c >= 0
  double most = 0.0;    ///< largest c so far; below it the traction is on the line to the origin
};

/// traction of an opening
template <class Law> inline double traction(Law, const Opening &o)
{
  if (o.now >= o.most) return o.strength * Law::traction(o.now / o.end);
  return o.strength * Law::traction(o.most / o.end) * o.now / o.most;
}

/// energy per area that it holds and gives back when it closes
template <class Law> inline double stored_energy(Law law, const Opening &o)
{
  return 0.5 * traction(law, o) * o.now;
}

/// energy per area that is gone: the area below the law, less what unloading gives back
template <class Law> inline double dissipated_energy(Law, const Opening &o)
{
  const double x = o.most / o.end;
  return o.strength * o.end * (Law::area(x) - 0.5 * x * Law::traction(x));
}

/** k of update(): how much the traction of a bond falls, per length that it opens.
    @param half half of the second derivative of the elastic energy U per area by the opening */
template <class Law> inline double stiffness_of_update(Law, const Opening &o, double half)
{
  return half + 0.5 * Law::STEEPEST * o.strength / o.end;
}

/** One update. The bond carries the traction t at the opening c; if it opened by dc more that would
    fall by k dc. The new opening is where that line meets the law: with q = t + k c
      q <= 0            closed; as long as it never opened: q <= t0
      below the largest the secant:        c = q/(k + T(c_max)/c_max)
      above             the falling branch: q - k c = T(c), beyond its end without traction
    This minimizes t-line + k/2 (c' - c)^2 + the energy of the law, whose second derivative is at least
    -STEEPEST t0/c_f: U(c) + stored + dissipated never rises if k is half of the second derivative of
    the elastic energy U per area plus half of that, or more.
    @param q, k stress, stress per length */
template <class Law> inline void update(Law, Opening &o, double q, double k)
{
  if (q <= (o.most > 0.0 ? 0.0 : o.strength)) {
    o.now = 0.0;
    return;
  }
  if (o.most > 0.0) {
    const double at_most = o.strength * Law::traction(o.most / o.end);
    const double secant = q / (k + at_most / o.most);
    if (secant <= o.most) {
      o.now = secant;
      return;
    }
  }
  const double x = Law::opening(q / o.strength, k * o.end / o.strength);
  o.now = o.most = x < 1.0 ? std::max(o.most, x * o.end) : std::max(o.end, q / k);
}

/** For update(): half of the second derivative of the elastic energy of a bond by its
    opening, bounded from above.
    @param W       weight W_ij of the bond
    @param modulus D lambda + 2 mu: all bonds of a particle may open at once
    @param kappa   tr K/D of the interior
    @param least   least eigenvalue of K/kappa at both ends: where a neighborhood has lost bonds, the
                   same opening changes H more
    @param chi     mean hourglass stiffness of both ends
    @param area    A of the bond */
inline double opening_stiffness(double W, double modulus, double kappa, double least, double chi,
                                double area)
{
  constexpr double LEAST = 0.02;    // with less the step of the opening becomes too small
  return W * std::max(modulus / (kappa * std::max(least, LEAST)), chi) / area;
}

}    // namespace TMSPH
#endif
