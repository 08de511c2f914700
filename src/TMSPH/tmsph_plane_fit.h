/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   A line (2-D) or plane (3-D) through a cloud of points, from its moments.
   Moments of several clouds add up, so that a cloud may be spread over
   processors.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PLANE_FIT_H
#define LMP_TMSPH_PLANE_FIT_H

#include <Eigen/Eigenvalues>

namespace TMSPH {

/** Number, sum and sum of outer products of points about an origin, in this order: the products as
    xx xy yy, or xx xy xz yy yz zz. */
template <int D> struct Moments {
  static constexpr int SIZE = 1 + D + D * (D + 1) / 2;
  double m[SIZE] = {};

  void add_point(const double *p)
  {
    m[0] += 1.0;
    for (int a = 0, k = 1 + D; a < D; a++) {
      m[1 + a] += p[a];
      for (int b = a; b < D; b++) m[k++] += p[a] * p[b];
    }
  }

  /// adds moments about another origin, which stands at "shift" from the one of these
  void add(const double *other, const double *shift)
  {
    m[0] += other[0];
    for (int a = 0, k = 1 + D; a < D; a++) {
      m[1 + a] += other[1 + a] + other[0] * shift[a];
      for (int b = a; b < D; b++, k++)
        m[k] += other[k] + other[1 + a] * shift[b] + shift[a] * other[1 + b] +
            other[0] * shift[a] * shift[b];
    }
  }
};

/** Cosine of the angle between the normal of a plane and a line across it, at least. Two particles
    that have both parted from a third have the middles of these pairs on a line parallel to their
    own: the plane through those does not lie between them, and only round-off would tell on which
    side of it one of them is. Of pairs that look along a face of a lattice it is small, some 0.05,
    but far from round-off: to take the line between them for the normal would jam the face. */
constexpr double ACROSS = 1.0e-6;

/** Normal of the plane that fits the points best (least squares of the distances), and the mean of
    the points.
    @param direction unit vector to which the normal falls back when the points do not span a
                     plane, or one that is not across; also decides its sign
    @param scatter   weight of that direction, in squared lengths: the moment of inertia that the
                     points must have to overrule it
    @param centre    mean of the points, or the origin if there are none */
template <int D>
void fit_plane(const Moments<D> &points, const double *direction, double scatter, double *normal,
               double *centre)
{
  Eigen::Matrix<double, D, D> C;
  const double n = points.m[0];
  for (int a = 0; a < D; a++) centre[a] = n > 0.0 ? points.m[1 + a] / n : 0.0;
  for (int a = 0, k = 1 + D; a < D; a++)
    for (int b = a; b < D; b++, k++)
      C(a, b) = C(b, a) = points.m[k] - n * centre[a] * centre[b] +
          scatter * ((a == b) - direction[a] * direction[b]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> eigen(C);
  Eigen::Matrix<double, D, 1> v = eigen.eigenvectors().col(0);
  double along = 0.0;
  for (int a = 0; a < D; a++) along += v[a] * direction[a];
  const bool across = along > ACROSS || along < -ACROSS;
  for (int a = 0; a < D; a++) normal[a] = !across ? direction[a] : along < 0.0 ? -v[a] : v[a];
}

}    // namespace TMSPH
#endif
