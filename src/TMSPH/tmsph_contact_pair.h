/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Kernel-weighted pair contact of two deformable surfaces: every pair of
   particles across the interface within the horizon carries a part of it.
   Weight and reference distance do not depend on the penetration; pairs fade
   in and out as the surfaces slip.

   All is oriented from the end with the lower id ("low") to the other
   ("high"), so that both ends, on whatever processor, find the same numbers.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_PAIR_H
#define LMP_TMSPH_CONTACT_PAIR_H

#include "tmsph_contact_hold.h"
#include "tmsph_elastic.h"
#include "tmsph_kernel.h"

namespace TMSPH {

/** k_n = CLOSURE 2 M V_i V_j w_ij/K0 and k_t = SHEAR_CLOSURE 2 G V_i V_j w_ij/K0, with the harmonic
    means M of lambda + 2 mu and G of mu of both ends, make a closed cut as stiff as the intact
    body. Calibrated on flat cuts at several angles, through square and hexagonal lattices in 2-D,
    simple cubic and face-centered cubic ones in 3-D: unittest/verification/test_closed_cut.py. */
template <int D> constexpr double CLOSURE = D == 2 ? 0.593 : 0.47;
template <int D> constexpr double SHEAR_CLOSURE = D == 2 ? 0.56 : 0.52;

/** Where the surfaces of a pair are. */
struct PairGeometry {
  /// reference normals of the ends, both from low to high; 0 of a loose particle: no surface
  double normal_low[3], normal_high[3];
  double distance;    ///< D, of both particles along the normal when the surfaces just touch
  double depth;       ///< of the low end below its surface/sum of both depths
  /// 1: both are loose, the normal is the line between them, the reference normals what it was
  double loose;

  /// true as long as there are no normals
  bool faceless() const { return is_zero(normal_low) && is_zero(normal_high); }
  static bool is_zero(const double *N) { return N[0] == 0.0 && N[1] == 0.0 && N[2] == 0.0; }
};

/** What a pair keeps while it is in contact. */
struct ContactPair : PairGeometry {
  double origin[2];      ///< tangential coordinates of the high end in the reference
  double stiffness;      ///< k_n/w
  double shear_ratio;    ///< k_t/k_n
  double friction;       ///< coefficient
  double horizon;        ///< support of the kernel
};

/** What a pair remembers of its past. */
struct ContactPast {
  double moved[2];    ///< tangential coordinates where friction is zero, less the origin's
  double worn;        ///< overlap of the surfaces that takes no force
};

/** One end as a force evaluation finds it. */
template <int D> struct ContactEnd {
  const double *x, *v, *a;    ///< position, velocity, acceleration by all other forces
  const double *H;            ///< F - I, row-major
  double thermal;             ///< thermal strain
  bool bears;                 ///< can its bonds balance a couple?
};

/** What a step makes of a pair before any contact has acted. */
template <int D> struct ContactState {
  double r[D], normal[D], tangent[D - 1][D];
  double weight;           ///< w
  double stiffness;        ///< k_n
  double shear_ratio;      ///< k_t/k_n
  double fading[D - 1];    ///< derivatives of log k_n along the tangents; of pairs that press
  double closing;          ///< velocity
  double penetration;      ///< now
  double predicted;        ///< at the end of the step; positive: active
  double slip[D - 1];      ///< at the end of the step, from where friction is zero
  double stretch;          ///< 1 + thermal strain
  double lean;             ///< cosine of half the angle between the normals of the ends
  bool central;            ///< no end can balance a couple: it acts along the line between
};

/// direction of F^-T N, of unit length; N itself where F is inside out
template <int D> inline void carried_normal(const double *H, const double *N, double *n)
{
  Matrix<D, double> F;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) F[a][b] = H[a * D + b] + (a == b ? 1.0 : 0.0);
  const Matrix<D, double> C = cofactor(F);
  double square = 0.0, along = 0.0;
  for (int a = 0; a < D; a++) {
    n[a] = 0.0;
    for (int b = 0; b < D; b++) n[a] += C[a][b] * N[b];
    square += n[a] * n[a];
  }
  for (int a = 0; a < D; a++) along += F[a][0] * C[a][0];    // det F
  const bool sound = square > 0.0 && along > 0.0;
  const double scale = sound ? 1.0 / std::sqrt(square) : 1.0;
  for (int a = 0; a < D; a++) n[a] = sound ? scale * n[a] : N[a];
}

inline void cross_product(const double *u, const double *v, double *w)
{
  for (int a = 0; a < 3; a++)
    w[a] = u[(a + 1) % 3] * v[(a + 2) % 3] - u[(a + 2) % 3] * v[(a + 1) % 3];
}

/** Unit vectors in the plane across n. In 2-D n turned left; in 3-D any two across the reference
    normal N, carried along with the material: moved by F, they are taken to the nearest pair that
    is orthonormal (polar decomposition), which turns along with the pair that was chosen. */
inline void tangents(const double *n, const double * /*H*/, const double * /*N*/, double (&t)[1][2])
{
  t[0][0] = -n[1];
  t[0][1] = n[0];
}

inline void tangents(const double *n, const double *H, const double *N, double (&t)[2][3])
{
  int axis = 0;
  for (int a = 1; a < 3; a++)
    if (std::fabs(N[a]) < std::fabs(N[axis])) axis = a;
  double T[2][3], moved[2][3];
  const double length = std::sqrt(1.0 - N[axis] * N[axis]);
  for (int a = 0; a < 3; a++) T[0][a] = ((a == axis) - N[axis] * N[a]) / length;
  cross_product(N, T[0], T[1]);
  for (int k = 0; k < 2; k++)
    for (int a = 0; a < 3; a++) {
      moved[k][a] = T[k][a];
      for (int b = 0; b < 3; b++) moved[k][a] += H[3 * a + b] * T[k][b];
    }

  // in the plane a matrix and its cofactor add up to a multiple of the nearest rotation

  double along = 0.0, square = 0.0;
  cross_product(moved[1], n, t[0]);
  for (int a = 0; a < 3; a++) {
    t[0][a] += moved[0][a];
    along += n[a] * t[0][a];
  }
  for (int a = 0; a < 3; a++) {
    t[0][a] -= along * n[a];
    square += t[0][a] * t[0][a];
  }
  const double scale = 1.0 / std::sqrt(std::max(square, 1.0e-30));    // 0 only where F is absurd
  for (int a = 0; a < 3; a++) t[0][a] *= scale;
  cross_product(n, t[0], t[1]);
}

/// tangents of the pair as the reference stands
template <int D> inline void reference_tangents(const PairGeometry &p, double (&t)[D - 1][D])
{
  static constexpr double REST[9] = {};
  double normal[D], square = 0.0;
  for (int a = 0; a < D; a++) {
    normal[a] = p.normal_low[a] + p.normal_high[a];
    square += normal[a] * normal[a];
  }
  for (int a = 0; a < D; a++) normal[a] /= std::sqrt(square);
  tangents(normal, REST, p.is_zero(p.normal_low) ? p.normal_high : p.normal_low, t);
}

/** Geometry and prediction of one pair.
    @param dt    0: nothing is predicted, the state is as it is */
template <int D>
inline ContactState<D> contact_state(const ContactPair &pair, const ContactEnd<D> &low,
                                     const ContactEnd<D> &high, const ContactPast &past,
                                     Kernel kernel, double dt)
{
  ContactState<D> s;
  s.central = !low.bears && !high.bears;
  const bool loose = pair.loose != 0.0 || s.central;    // along the line between
  double n_low[D], n_high[D], square = 0.0, low_one = 0.0, high_one = 0.0;
  const double *H_low = low.bears || s.central ? low.H : high.H;    // a point has no gradient
  const double *H_high = high.bears || s.central ? high.H : low.H;
  carried_normal<D>(H_low, pair.normal_low, n_low);
  carried_normal<D>(H_high, pair.normal_high, n_high);
  for (int a = 0; a < D; a++) {
    s.r[a] = high.x[a] - low.x[a];
    s.normal[a] = loose ? s.r[a] : n_low[a] + n_high[a];
    square += s.normal[a] * s.normal[a];
    low_one += n_low[a] * n_low[a];
    high_one += n_high[a] * n_high[a];
  }

  // where two surfaces turn from one end to the other, depths s below them add up to (s_i + s_j)
  // times the cosine of half the angle

  const double length = std::sqrt(square);
  for (int a = 0; a < D; a++) s.normal[a] = length > 0.0 ? s.normal[a] / length : n_low[a];
  s.lean = !loose && low_one > 0.5 && high_one > 0.5 ? 0.5 * length : 1.0;
  if (low_one > 0.5)    // 1, or 0 of a loose particle
    tangents(s.normal, H_low, pair.normal_low, s.tangent);
  else
    tangents(s.normal, H_high, pair.normal_high, s.tangent);

  double next[D], apart = 0.0, apart_next = 0.0;
  for (int a = 0; a < D; a++) {
    next[a] = s.r[a] + dt * (high.v[a] - low.v[a]) + dt * dt * (high.a[a] - low.a[a]);
    apart += s.normal[a] * s.r[a];
    apart_next += s.normal[a] * next[a];
  }
  s.stretch = 1.0 + 0.5 * (low.thermal + high.thermal);
  const double touching = pair.distance * s.stretch * s.lean - past.worn;
  double R2 = pair.distance * pair.distance, tau[D - 1];
  for (int k = 0; k < D - 1; k++) {
    double tau_next = 0.0;
    tau[k] = 0.0;
    for (int a = 0; a < D; a++) {
      tau[k] += s.tangent[k][a] * s.r[a];
      tau_next += s.tangent[k][a] * next[a];
    }
    R2 += tau[k] * tau[k];
    s.slip[k] = tau_next - s.stretch * (pair.origin[k] + past.moved[k]);
  }
  const double R = std::max(std::sqrt(R2), 1.0e-3 * pair.horizon);    // w has a limit at 0, not 0/0
  s.weight = kernel_slope(kernel, D, R, pair.horizon);
  s.stiffness = pair.stiffness * s.weight;
  s.shear_ratio = pair.shear_ratio;
  s.closing = 0.0;
  for (int a = 0; a < D; a++) s.closing -= s.normal[a] * (high.v[a] - low.v[a]);
  s.penetration = touching - apart;
  s.predicted = touching - apart_next;
  std::fill_n(s.fading, D - 1, 0.0);
  if (s.predicted > 0.0 && s.weight > 0.0) {
    const double rate = kernel_slope_rate(kernel, D, R, pair.horizon) / (R * s.weight);
    for (int k = 0; k < D - 1; k++) s.fading[k] = rate * tau[k];
  }
  return s;
}

/** Force on the high end; the low end gets the opposite. It is the derivative of what the pair
    holds, whose stiffness fades along the surface.
    @param frequency Kc_low/m_low + Kc_high/m_high, Kc = sum of k_n over the active pairs of an end
    @param dt    0: nothing is predicted
    @param past  its friction moves by the excess of a sliding pair
    @param heat  energy that friction took, added
    @return the normal force */
template <int D>
inline double contact_force(const ContactLaw &law, const ContactPair &pair,
                            const ContactState<D> &s, double frequency, double dt, double *force,
                            ContactPast &past, double &heat)
{
  const double q = law.ahead(dt) * law.ahead(dt) * frequency;
  double normal;
  hold_across(law, s.stiffness, q, frequency, 1, 0.0, &s.predicted, &s.closing, &normal);
  const double ratio = s.shear_ratio, limit = s.central ? 0.0 : pair.friction * normal;
  const Friction<D - 1> friction = hold_along<D - 1>(ratio * s.stiffness, ratio * q, limit, s.slip);
  heat += friction.work;
  for (int a = 0; a < D; a++) force[a] = normal * s.normal[a];
  // the stiffness of the paper's law is no spring's
  const double energy = law.throws_back
      ? 0.0
      : held_energy<D - 1>(s.stiffness, ratio * s.stiffness, normal, friction.force);
  for (int k = 0; k < D - 1; k++) {
    const double along = friction.force[k] + energy * s.fading[k];
    for (int a = 0; a < D; a++) force[a] -= along * s.tangent[k][a];
    past.moved[k] += friction.excess[k] / s.stretch;
  }
  return normal;
}

/** Forces f and -f at two points a vector r apart turn the pair by r x f, which the bonds of the
    ends have to balance, by c = -r x f. The normals of the ends are carried by their gradients,
    n ~ F^-T N: they turn where n . (dF F^-1) t of a direction t along the surface is not 0, and
    not when the surface is sheared. So what does work on all that the law measures, and on nothing
    else, are moments sum f x of the forces in the bonds along n: n (n x c), and for the part of
    the couple about n, which turns the tangents, skew ones.
    @param borne fraction of the couple that this end balances
    @param tilt  D x D, row-major: the moments are added */
template <int D>
inline void add_tilt(double borne, const double *f, const double *r, const double *n, double *tilt)
{
  double c[3] = {0.0, 0.0, borne * (f[0] * r[1] - f[1] * r[0])}, along[3];
  if constexpr (D == 2) {
    along[0] = n[1] * c[2];
    along[1] = -n[0] * c[2];
  } else {
    cross_product(f, r, c);
    for (int a = 0; a < 3; a++) c[a] *= borne;
    cross_product(n, c, along);
  }
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) tilt[D * a + b] += n[a] * along[b];
  if constexpr (D == 3) {
    const double half = 0.5 * (c[0] * n[0] + c[1] * n[1] + c[2] * n[2]);
    for (int a = 0; a < 3; a++) {
      const int b = (a + 1) % 3, d = (a + 2) % 3;
      tilt[3 * b + a] += half * n[d];
      tilt[3 * a + b] -= half * n[d];
    }
  }
}

/// couple of moments sum f x
template <int D> inline void couple_of(const double *tilt, double *couple)
{
  std::fill_n(couple, 3, 0.0);
  for (int a = D == 2 ? 2 : 0; a < 3; a++) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    couple[a] = tilt[D * c + b] - tilt[D * b + c];
  }
}

/** A pair whose surfaces are found anew keeps its energy, or has less: slip along a surface that
    turns would become overlap, with an energy that nothing has brought.
    @param before with the former surfaces
    @param after  at the same positions with the new ones and no past
    @return       the past with which it goes on */
template <int D>
inline ContactPast past_of_refitted(const ContactState<D> &before, const ContactState<D> &after)
{
  const auto least = [](double was, double is) { return was < is ? std::sqrt(was / is) : 1.0; };
  const bool pressed = before.penetration > 0.0;
  const double overlap = pressed ? before.penetration * least(before.stiffness, after.stiffness)
                                 : 0.0;
  const double part = pressed
      ? least(before.shear_ratio * before.stiffness, after.shear_ratio * after.stiffness)
      : 0.0;
  ContactPast past = {{0.0, 0.0}, std::max(0.0, after.penetration - overlap)};
  for (int k = 0; k < D - 1; k++) {
    double slip = 0.0;
    for (int l = 0; l < D - 1; l++)
      for (int a = 0; a < D; a++)
        slip += part * before.slip[l] * before.tangent[l][a] * after.tangent[k][a];
    past.moved[k] = (after.slip[k] - slip) / after.stretch;
  }
  return past;
}

}    // namespace TMSPH
#endif
