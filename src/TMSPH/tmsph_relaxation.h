/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Moves particles of bodies to an irregular arrangement that is as good as a
   lattice, in two stages:

     push      along -sum_j V_j grad W_ij, with the images of particles that mirrors at the
               surface of their body would show: distances become even, and so does density.
               Colagrossi, Bouscasse, Antuono, Marrone, Comput. Phys. Commun. 183 (2012) 1641.
     balance   along g_i = -sum_j V_j w_ij (K_i^-1 + K_j^-1) X_ij with the bonds that the
               particles will have, K_i = sum_j V_j w_ij X_ij X_ij^T. A body with stress P in all
               particles has forces V_i P g_i, so that an even stress is in equilibrium where
               these vanish: inside all of g_i, at free surfaces what lies along them.

   Every processor knows all particles and moves some of them. Sums run over neighbors in an order
   that depends on neither.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RELAXATION_H
#define LMP_TMSPH_RELAXATION_H

#include "tmsph_kernel.h"

#include <Eigen/Dense>
#include <functional>
#include <vector>

namespace TMSPH {

template <int D> struct CloudParticle {
  Eigen::Matrix<double, D, 1> place;
  double size;    ///< volume, in 2-D area
  int body, type;
};

/// Touches the surface of a body where this is nearest to a point of the body.
template <int D> struct TangentPlane {
  static constexpr int NOTHING = -1;
  Eigen::Matrix<double, D, 1> normal;    ///< of unit length, outward
  double depth;                          ///< of the point below it
  int beyond;                            ///< body on its other side, or NOTHING
};

template <int D> class BodyShapes {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;
  virtual bool inside(int body, const Vector &X) const = 0;
  /// those nearer than "reach" to X, a point inside of the body
  virtual std::vector<TangentPlane<D>> planes(int body, const Vector &X, double reach) const = 0;

 protected:
  ~BodyShapes() = default;    // never owned through this interface
};

/// The bonds that there will be.
struct CloudBonds {
  Kernel kernel;
  std::vector<std::vector<double>> horizon;    ///< by type and type; 0: not bonded
};

/// Which particles are moved here, and how those of all processors are told.
struct CloudShare {
  int first, last;
  /// fills up rows of so many numbers for each particle, of which those from first to last are
  /// there
  std::function<void(double *rows, int width)> complete;
};

/// Directions in which places repeat; period 0: they do not.
template <int D> struct CloudBox {
  Eigen::Matrix<double, D, 1> low, period;
};

/// What can be said of one particle in its place.
struct CloudFigures {
  double nearest;      ///< distance to the nearest particle/mean of their spacings
  int neighbor;        ///< that one, or -1 if there is none within reach
  double imbalance;    ///< force under an even stress/(stress times section of the particle)
};

template <int D> class Relaxation {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;

  Relaxation(std::vector<CloudParticle<D>>, const CloudBox<D> &, const BodyShapes<D> &,
             const CloudBonds &, const CloudShare &);
  /// moves that spread the particles over the largest of the bodies
  int pushes() const;
  void push(int moves);
  void balance(int moves);
  /// of all particles
  std::vector<CloudFigures> figures();
  const std::vector<CloudParticle<D>> &particles() const { return cloud; }

 private:
  using Matrix = Eigen::Matrix<double, D, D>;

  std::vector<CloudParticle<D>> cloud;
  const CloudBox<D> box;
  const BodyShapes<D> &shapes;
  const CloudBonds bonds;
  const CloudShare share;

  std::vector<double> spacing;              // of each particle
  double smallest, largest;                 // of these
  double longest;                           // of the horizons
  std::vector<std::vector<char>> joined;    // by body and body: some of their types are bonded

  // Points are the particles, and behind them their periodic images

  std::vector<Vector> points;
  std::vector<int> owner;           // of each point
  std::vector<Vector> shift;        // of each point from its owner
  std::vector<Vector> built;        // places of the particles when the lists were made
  std::vector<int> offset, list;    // points near the particles that are moved here
  std::vector<Vector> motion;       // last move of these
  std::vector<Matrix> inverse;      // of the shape matrices of all particles

  double push_support(int i, int j) const;
  void find_joined();
  double lowest_rate() const;
  void make_points();
  void make_lists();
  void follow();
  Vector pushed(int i) const;
  Vector off_the_nearest(int i) const;
  Vector confined(int i, const Vector &to) const;
  void move(double keeps, double longest_step, const std::function<Vector(int)> &along);
  void find_inverses();
  Vector unbalanced(int i) const;
  Vector along_surfaces(int i, Vector g) const;
};

}    // namespace TMSPH
#endif
