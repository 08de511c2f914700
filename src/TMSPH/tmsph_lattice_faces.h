/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The flat faces of a body on a lattice near one of its particles, told apart.

   The family of a particle spans the lattice, hence the places of the neighbors
   that it lacks are known. Faces are the planes along the outermost ones of its
   neighbors that have these places, and no neighbor, beyond them. At a re-entrant
   corner the places that are left are those beyond two faces at once. What faces
   do to the conduction of heat:

   - Normal to a face, the lacking bonds pull: sum V w X.n over the places beyond.
     This part of the face makes a linear field steady.
   - Along it the body conducts worse, as the rows near the face lack bonds with
     others. The bonds within a row replace them: with X_t the part of X along the
     face they are stronger by
       boost = sum_beyond V w X_t^2/sum_same_row V w X_t^2.
     They are normal to n, so that nothing changes along it. As heat is
     conserved, the parts of another face at whose edge the rows end then add
     up to its whole area.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_LATTICE_FACES_H
#define LMP_TMSPH_LATTICE_FACES_H

#include "tmsph_point_grid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace TMSPH {

/** One flat face near a particle, or two with the body between them. */
template <int D> struct Layer {
  Eigen::Matrix<double, D, 1> normal;    ///< outward, of unit length
  double above = 0.0;                    ///< depth of the particle below the face
  double below = 0.0;                    ///< and above that on the other side; 0: there is none
  double boost = 0.0;                    ///< of bonds along the face, less 1
  double missing = 0.0;                  ///< sum V w |X.n| of the places beyond

  /// less than this in X.n/|X| is what positions lose in files
  static constexpr double ALONG = 1.0e-4;
  bool along(const double *X) const
  {
    const Eigen::Map<const Eigen::Matrix<double, D, 1>> x(X);
    return std::fabs(x.dot(normal)) < ALONG * x.norm();
  }

  /// numbers that it is stored as; above is the first behind the normal
  static constexpr int SIZE = D + 4;
  void put(double *to) const
  {
    to = std::copy_n(normal.data(), D, to);
    for (const double value : {above, below, boost, missing}) *to++ = value;
  }
  void take(const double *from)
  {
    std::copy_n(from, D, normal.data());
    from += D;
    for (double *value : {&above, &below, &boost, &missing}) *value = *from++;
  }
};

/** Collects the bonds of a particle and finds the faces near it. */
template <int D> class LatticeFaces {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;

  /// @param horizon of the bonds
  explicit LatticeFaces(double horizon) : reach(horizon * (1.0 - SAME)), own(1, Vector::Zero()) {}
  /// a bond with reference vector X
  void add(const double *X)
  {
    const Eigen::Map<const Vector> x(X);
    if (x.norm() < reach) own.push_back(x);
  }

  /** @param weight V w(R) of a neighbor at the distance R
      @return       false where else than a few faces bounds the family: steps, disorder */
  template <class Weight> bool find(Weight weight)
  {
    if (!span_lattice()) return false;
    if (!std::count(lacking.begin(), lacking.end(), 1)) return true;
    find_candidates();
    return bounded_by(false, weight) || bounded_by(true, weight) || reentrant(weight);
  }
  /// at most D, with independent normals; none inside
  const std::vector<Layer<D>> &found() const { return layers; }

  /// sum V w R^2 of the lattice, after find() has found layers
  template <class Weight> double second_moment(Weight weight) const
  {
    double sum = 0.0;
    for (size_t n = 1; n < places.size(); n++)
      sum += weight(places[n].norm()) * places[n].squaredNorm();
    return sum;
  }

 private:
  // in shortest bonds: the same place, but for what positions lose in files; the same step, but for
  // round-off; bonds that span the lattice, where bcc has the next at 1.15, others beyond; bonds
  // that span faces, up to 1.73 in hexagonal, sc and fcc lattices, the next, of bcc, at 1.91
  static constexpr double SAME = 1.0e-4, ROUND_OFF = 1.0e-9, NEAREST = 1.01, SHORT = 1.8;

  struct Face {
    Vector normal;
    double height, gap;         // of the outermost row above the particle; distance of rows
    bool spanned;               // by D of the family or more, not on a line
    std::vector<int> beyond;    // places
  };
  double reach, same = 0.0;
  std::vector<Vector> own, places;             // the particle itself is the first
  std::vector<char> lacking;                   // places without a neighbor
  std::vector<double> own_heights, heights;    // of own and of places along a normal
  std::vector<Face> candidates, faces;
  std::vector<Layer<D>> layers;

  int find_place(const PointGrid<D> &grid, const Vector &X) const
  {
    return grid.find(X, same, [&](int n) { return (places[n] - X).squaredNorm() < same * same; });
  }

  /// all places of the lattice within reach; false if the neighbors do not stand on them
  bool span_lattice()
  {
    double shortest = reach;
    for (size_t n = 1; n < own.size(); n++) shortest = std::min(shortest, own[n].norm());
    same = SAME * shortest;
    std::vector<Vector> steps;
    const auto add = [&](const Vector &step) {    // opposite neighbors give it twice
      for (const Vector &s : steps)
        if ((s - step).norm() < ROUND_OFF * shortest) return;
      steps.push_back(step);
    };
    for (size_t n = 1; n < own.size(); n++)
      if (own[n].norm() < NEAREST * shortest) {
        add(own[n]);
        add(-own[n]);
      }
    const double most = std::pow(2.0 * reach / shortest + 1.0, D);
    places.assign(1, Vector::Zero());
    PointGrid<D> grid(reach, 0.5 * shortest);
    grid.add(places[0]);
    for (size_t n = 0; n < places.size(); n++)
      for (const Vector &step : steps) {
        const Vector X = places[n] + step;
        if (X.norm() < reach && find_place(grid, X) < 0) {
          places.push_back(X);
          grid.add(X);
        }
        if (places.size() > most) return false;
      }
    lacking.assign(places.size(), 1);
    for (const Vector &X : own) {
      const int place = find_place(grid, X);
      if (place < 0) return false;
      lacking[place] = 0;
    }
    return true;
  }

  /// planes along the outermost of the family in each direction
  void find_candidates()
  {
    std::vector<Vector> steps;
    const double longest = SHORT * (places.size() > 1 ? places[1].norm() : 0.0);
    for (size_t n = 1; n < places.size(); n++)
      if (places[n].norm() < longest) steps.push_back(places[n]);
    for (size_t a = 0; a < steps.size(); a++) {
      if constexpr (D == 2)
        consider(Vector(-steps[a][1], steps[a][0]), false);
      else
        for (size_t b = a + 1; b < steps.size(); b++) consider(steps[a].cross(steps[b]), true);
    }
  }

  /// @param both also the opposite direction
  void consider(const Vector &direction, bool both)
  {
    const double length = direction.norm();
    if (length < same * same) return;
    const Vector normal = direction / length;
    bool here = false, there = !both;    // known
    for (const Face &f : candidates) {
      const double cosine = f.normal.dot(normal);
      here = here || cosine > 1.0 - SAME * SAME;
      there = there || -cosine > 1.0 - SAME * SAME;
      if (here && there) return;
    }
    own_heights.clear();
    heights.clear();
    for (const Vector &X : own) own_heights.push_back(X.dot(normal));
    for (const Vector &X : places) heights.push_back(X.dot(normal));
    if (!here) add_candidate(normal, 1.0);
    if (!there) add_candidate(-normal, -1.0);
  }

  /// @param sign of the heights in its direction
  void add_candidate(const Vector &normal, double sign)
  {
    Face face;
    face.normal = normal;
    face.height = 0.0;
    for (const double height : own_heights) face.height = std::max(face.height, sign * height);
    face.gap = reach;
    for (size_t n = 0; n < places.size(); n++) {
      const double height = sign * heights[n];
      if (height > same) face.gap = std::min(face.gap, height);
      if (height > face.height + same) face.beyond.push_back(n);
    }
    face.spanned = spanned(face);
    candidates.push_back(std::move(face));
  }

  bool spanned(const Face &face) const
  {
    const Vector *first = nullptr, *second = nullptr;
    for (const Vector &X : own) {
      if (X.dot(face.normal) < face.height - same) continue;
      if (!first)
        first = &X;
      else if (D == 2)
        return true;
      else if (!second)
        second = &X;
      else {
        const Vector along = (*second - *first).normalized(), other = X - *first;
        if ((other - other.dot(along) * along).norm() > same) return true;
      }
    }
    return false;
  }

  /// candidates, less those beyond which is nothing but what is beyond others; the largest first
  void choose(bool spanned)
  {
    faces.clear();
    for (const Face &face : candidates)
      if (!face.beyond.empty() && (face.spanned || !spanned)) faces.push_back(face);
    std::stable_sort(faces.begin(), faces.end(), [](const Face &a, const Face &b) {
      return a.beyond.size() > b.beyond.size();
    });
    std::vector<int> times(places.size(), 0);
    for (const Face &face : faces)
      for (int n : face.beyond) times[n]++;
    const auto redundant = [&](const Face &face) {
      for (int n : face.beyond)
        if (times[n] == 1) return false;
      for (int n : face.beyond) times[n]--;
      return true;
    };
    faces.erase(std::remove_if(faces.begin(), faces.end(), redundant), faces.end());
  }

  template <class Weight> bool bounded_by(bool spanned, Weight weight)
  {
    choose(spanned);
    if (!left_by(faces).empty()) return false;
    for (const Face &face : faces) add_layer(face);
    for (Layer<D> &layer : layers) find_sums(layer, weight);
    return few();
  }

  bool few()
  {
    if ((int) layers.size() > D) layers.clear();
    return !layers.empty();
  }

  /// the places that are lacking and not beyond any of these
  std::vector<int> left_by(const std::vector<Face> &some) const
  {
    std::vector<char> open(lacking);
    for (const Face &face : some)
      for (int n : face.beyond) open[n] = 0;
    std::vector<int> left;
    for (size_t n = 0; n < open.size(); n++)
      if (open[n]) left.push_back(n);
    return left;
  }

  void add_layer(const Face &face)
  {
    const double depth = std::max(face.height, 0.0) + 0.5 * face.gap;
    for (Layer<D> &layer : layers)
      if (layer.normal.dot(face.normal) < SAME * SAME - 1.0) {
        layer.below = depth;
        return;
      }
    Layer<D> layer;
    layer.normal = face.normal;
    layer.above = depth;
    layers.push_back(layer);
  }

  /// planes at right angles beyond both of which is all that faces aside or behind leave
  template <class Weight> bool reentrant(Weight weight)
  {
    choose(true);
    const auto aside_or_behind = [](const Face &face, const Face &plane) {
      const double cosine = face.normal.dot(plane.normal);
      return std::fabs(cosine) < SAME || cosine < SAME - 1.0;
    };
    for (size_t n = 0; n < candidates.size(); n++)
      for (size_t m = 0; m < n; m++) {
        Face a = candidates[n], b = candidates[m];
        if (std::fabs(a.normal.dot(b.normal)) > SAME) continue;
        std::vector<Face> others;
        for (const Face &face : faces)
          if (aside_or_behind(face, a) && aside_or_behind(face, b)) others.push_back(face);
        const std::vector<int> left = left_by(others);
        if (!is_corner(a, b, left)) continue;
        for (const Face &face : others) add_layer(face);
        for (Layer<D> &layer : layers) find_sums(layer, weight);
        for (const Face *plane : {&a, &b}) {
          add_layer(*plane);
          Layer<D> &layer = layers.back();
          const bool in_front = plane->height > -same;
          if (in_front && layer.boost == 0.0) layer.boost = boost_for(layer, left, weight);
        }
        if (few()) return true;
      }
    return false;
  }

  /// sets the heights of the planes
  bool is_corner(Face &a, Face &b, const std::vector<int> &left) const
  {
    if (left.empty()) return false;
    for (Face *plane : {&a, &b}) {
      double lowest = reach;
      for (int n : left) lowest = std::min(lowest, places[n].dot(plane->normal));
      plane->height = lowest - plane->gap;
    }
    for (size_t n = 0; n < places.size(); n++)
      if (!lacking[n] && places[n].dot(a.normal) > a.height + same &&
          places[n].dot(b.normal) > b.height + same)
        return false;
    return true;
  }

  template <class Weight> void find_sums(Layer<D> &layer, Weight weight) const
  {
    std::vector<int> beyond;
    for (size_t n = 1; n < places.size(); n++) {
      const double height = places[n].dot(layer.normal), thickness = layer.above + layer.below;
      if (height < layer.above && (layer.below == 0.0 || height > -layer.below)) continue;
      beyond.push_back(n);
      // a bond longer than the body is thick would go through several times
      const double times = layer.below > 0.0 ? std::max(1.0, std::fabs(height) / thickness) : 1.0;
      layer.missing += weight(places[n].norm()) * std::fabs(height) * times;
    }
    layer.boost = boost_for(layer, beyond, weight);
  }

  /// replaces what bonds to these places would conduct along the layer
  template <class Weight>
  double boost_for(const Layer<D> &layer, const std::vector<int> &lost, Weight weight) const
  {
    const auto part = [&](int n) {
      const double height = places[n].dot(layer.normal);
      return weight(places[n].norm()) * (places[n].squaredNorm() - height * height);
    };
    double gone = 0.0, same_row = 0.0;
    for (int n : lost) gone += part(n);
    for (size_t n = 1; n < places.size(); n++)
      if (std::fabs(places[n].dot(layer.normal)) < same) same_row += part(n);
    return same_row > 0.0 ? gone / same_row : 0.0;
  }
};

}    // namespace TMSPH
#endif
