/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   A coarse grid over a body: its smooth deformations by multilinear finite
   elements, with the particles as points of integration. Solvers use it to
   see across the body (two-level preconditioning: Smith, Bjorstad, Gropp,
   Domain Decomposition, 1996, Sect. 2.1).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_COARSE_GRID_H
#define LMP_TMSPH_COARSE_GRID_H

#include "tmsph_fixed_point.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace TMSPH {

template <int D> class CoarseGrid {
 public:
  static constexpr int CORNERS = 1 << D, OFFSETS = D == 2 ? 9 : 27;

  /// The nodes around a point, and their shape functions there.
  struct Place {
    std::array<int, CORNERS> node;
    std::array<double, CORNERS> weight;
  };

  /** @param most degrees of freedom; the spacing of the nodes grows until there are no more */
  CoarseGrid(const double *low, const double *high, const bool *periodic, double spacing, int most)
  {
    do {
      nodes = 1;
      for (int k = 0; k < D; k++) {
        const double length = std::max(high[k] - low[k], spacing);
        cells[k] = std::max(1, (int) std::ceil(length / spacing - 1.0e-6));    // round-off: no cell
        width[k] = length / cells[k];
        origin[k] = low[k];
        wraps[k] = periodic[k];
        count[k] = wraps[k] ? cells[k] : cells[k] + 1;
        nodes *= count[k];
      }
      spacing *= 1.1;    // at most a tenth coarser than need be
    } while (nodes * D > most);
  }

  int freedoms() const { return nodes * D; }
  /// length of the stiffness array
  size_t entries() const { return (size_t) nodes * OFFSETS * D * D; }
  double narrowest() const { return *std::min_element(width.begin(), width.begin() + D); }

  Place place(const double *X) const
  {
    Slope slope;
    return place(X, slope);
  }

  /** Adds the stiffness of the elements at a point: lambda and shear modulus times volume. Integers
      in a unit of 1/scale: the sum over all points does not depend on their order. */
  void add_stiffness(const double *X, double lambda, double shear, double scale,
                     std::int64_t *stiffness) const
  {
    Slope g;
    const Place p = place(X, g);
    for (int a = 0; a < CORNERS; a++)
      for (int b = 0; b < CORNERS; b++) {
        double product = 0.0;
        for (int k = 0; k < D; k++) product += g[a][k] * g[b][k];
        std::int64_t *entry = stiffness + block(p, a, b);
        for (int r = 0; r < D; r++)
          for (int c = 0; c < D; c++)
            entry[D * r + c] +=
                (std::int64_t)(scale *
                               (lambda * g[a][r] * g[b][c] + shear * g[a][c] * g[b][r] +
                                (r == c ? shear * product : 0.0)));
      }
  }

  /// adds a spring that holds component k of the displacement at a place
  void add_spring(const Place &p, int k, double spring, double scale, std::int64_t *stiffness) const
  {
    for (int a = 0; a < CORNERS; a++)
      for (int b = 0; b < CORNERS; b++)
        stiffness[block(p, a, b) + D * k + k] +=
            (std::int64_t)(scale * spring * p.weight[a] * p.weight[b]);
  }

  /** Factorizes the sum of the stiffnesses of all points. A free body turns and shifts without
      resistance, which a small part "free" of the diagonal supplies.
      @return true if it worked */
  bool factorize(const std::int64_t *stiffness, double scale, double free)
  {
    std::vector<Eigen::Triplet<double>> triplets;
    for (int n = 0; n < nodes; n++)
      for (int offset = 0; offset < OFFSETS; offset++) {
        const std::int64_t *block = stiffness + ((size_t) n * OFFSETS + offset) * D * D;
        const bool own = offset == OFFSETS / 2;
        const int other = own ? n : neighbor(n, offset);
        for (int r = 0; r < D; r++)
          for (int c = 0; c < D; c++) {
            double value = block[D * r + c] / scale;
            // nodes without particles hold themselves
            if (own && r == c) value = value > 0.0 ? value * (1.0 + free) : 1.0;
            if (other >= 0 && value != 0.0) triplets.emplace_back(n * D + r, other * D + c, value);
          }
      }
    Eigen::SparseMatrix<double> matrix(freedoms(), freedoms());
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    solver.compute(matrix);
    return solver.info() == Eigen::Success;
  }

  /// displacements of the nodes under forces on them
  Eigen::VectorXd solve(const Eigen::VectorXd &forces) const { return solver.solve(forces); }

 private:
  using Slope = std::array<std::array<double, D>, CORNERS>;
  int nodes;
  std::array<int, D> cells, count;
  std::array<double, D> width, origin;
  std::array<bool, D> wraps;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;

  /// where the stiffness between two corners is stored
  static size_t block(const Place &p, int a, int b)
  {
    int offset = 0;
    for (int k = D - 1; k >= 0; k--) offset = 3 * offset + 1 + (b >> k & 1) - (a >> k & 1);
    return ((size_t) p.node[a] * OFFSETS + offset) * D * D;
  }

  Place place(const double *X, Slope &slope) const
  {
    int cell[D];
    double part[D];
    for (int k = 0; k < D; k++) {
      const double x = (X[k] - origin[k]) / width[k];
      const double floor = std::floor(x);
      cell[k] = wraps[k] ? (int) floor : std::clamp((int) floor, 0, cells[k] - 1);
      part[k] = x - cell[k];
      if (wraps[k]) cell[k] = (cell[k] % cells[k] + cells[k]) % cells[k];
    }
    Place p;
    for (int a = 0; a < CORNERS; a++) {
      p.node[a] = 0;
      p.weight[a] = 1.0;
      for (int k = D - 1; k >= 0; k--) {
        const int up = a >> k & 1;
        p.node[a] = p.node[a] * count[k] + (cell[k] + up) % count[k];
        p.weight[a] *= up ? part[k] : 1.0 - part[k];
      }
      for (int k = 0; k < D; k++) {
        slope[a][k] = (a >> k & 1 ? 1.0 : -1.0) / width[k];
        for (int m = 0; m < D; m++)
          if (m != k) slope[a][k] *= a >> m & 1 ? part[m] : 1.0 - part[m];
      }
    }
    return p;
  }

  /// node at an offset of -1, 0 or 1 in each direction; -1 beyond the edge
  int neighbor(int n, int offset) const
  {
    int index[D];
    for (int k = 0; k < D; k++) {
      index[k] = n % count[k] + offset % 3 - 1;
      n /= count[k];
      offset /= 3;
      if (wraps[k]) index[k] = (index[k] + count[k]) % count[k];
      if (index[k] < 0 || index[k] >= count[k]) return -1;
    }
    int other = 0;
    for (int k = D - 1; k >= 0; k--) other = other * count[k] + index[k];
    return other;
  }
};

}    // namespace TMSPH
#endif
