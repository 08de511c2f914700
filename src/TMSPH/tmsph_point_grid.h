/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Is a point among those that are there already? For some hundreds of them that
   come one by one, inside a cube about the origin.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_POINT_GRID_H
#define LMP_TMSPH_POINT_GRID_H

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace TMSPH {

template <int D> class PointGrid {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;

  /** @param half half of the edge of the cube; points outside count to the cells at its sides
      @param cell of the grid, at least: few points should share one */
  PointGrid(double half, double cell) :
      half(half), count(std::clamp((int) (2.0 * half / cell), 1, MOST)),
      per_length(0.5 * count / half)
  {
    int cells = 1;
    for (int a = 0; a < D; a++) cells *= count;
    last.assign(cells, NONE);
  }

  /// points are numbered as they come
  void add(const Vector &X)
  {
    int cell = 0;
    for (int a = 0; a < D; a++) cell = cell * count + row(X[a]);
    before.push_back(last[cell]);
    last[cell] = before.size() - 1;
  }

  /** @param same of a number: is it the point in question; asked of all within a distance of X in
                  each direction, and of some beyond
      @return     the lowest such number, or -1 */
  template <class Same> int find(const Vector &X, double within, Same same) const
  {
    int first[3] = {}, end[3] = {0, 0, 0};
    for (int a = 0; a < D; a++) {
      first[3 - D + a] = row(X[a] - within);
      end[3 - D + a] = row(X[a] + within);
    }
    int found = NONE;
    for (int x = first[0]; x <= end[0]; x++)
      for (int y = first[1]; y <= end[1]; y++)
        for (int z = first[2]; z <= end[2]; z++)
          for (int n = last[(x * count + y) * count + z]; n != NONE; n = before[n])
            if ((found == NONE || n < found) && same(n)) found = n;
    return found;
  }

 private:
  static constexpr int NONE = -1, MOST = 16;    // cells along an edge: 4096 for some hundreds
  double half;
  int count;
  double per_length;
  std::vector<int> last, before;    // number of the last point in each cell, and before each point

  int row(double x) const { return std::clamp((int) ((x + half) * per_length), 0, count - 1); }
};

}    // namespace TMSPH
#endif
