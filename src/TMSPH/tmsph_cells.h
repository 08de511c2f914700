/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Finds points near a point. A neighbor list of LAMMPS holds all particles;
   this is for the few that lie at a surface.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CELLS_H
#define LMP_TMSPH_CELLS_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace TMSPH {

class Cells {
 public:
  /** @param x       positions
      @param members indices of the points to be found
      @param reach   how far apart a point and those found near it may be */
  Cells(const double *const *x, const std::vector<int> &members, double reach) : reach(reach)
  {
    for (int a = 0; a < 3; a++) {
      double hi = std::numeric_limits<double>::lowest();
      for (const int i : members) {
        lo[a] = std::min(lo[a], x[i][a]);
        hi = std::max(hi, x[i][a]);
      }
      count[a] = members.empty() ? 1 : cell(hi, a) + 1;
    }
    entries.reserve(members.size());
    for (const int i : members)
      entries.emplace_back(key(cell(x[i][0], 0), cell(x[i][1], 1), cell(x[i][2], 2)), i);
    std::sort(entries.begin(), entries.end());
  }

  /// calls use(i) for all members within reach of p, and some beyond
  template <class Use> void near(const double *p, Use use) const
  {
    std::int64_t first[3], last[3];
    for (int a = 0; a < 3; a++) {
      first[a] = std::max<std::int64_t>(cell(p[a], a) - 1, 0);
      last[a] = std::min(cell(p[a], a) + 1, count[a] - 1);
      if (first[a] > last[a]) return;
    }
    for (std::int64_t iz = first[2]; iz <= last[2]; iz++)
      for (std::int64_t iy = first[1]; iy <= last[1]; iy++) {
        const std::int64_t end = key(last[0], iy, iz);
        auto e = std::lower_bound(entries.begin(), entries.end(),
                                  std::make_pair(key(first[0], iy, iz), -1));
        for (; e != entries.end() && e->first <= end; ++e) use(e->second);
      }
  }

 private:
  double reach;
  double lo[3] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
                  std::numeric_limits<double>::max()};
  std::int64_t count[3];
  std::vector<std::pair<std::int64_t, int>> entries;    // ascending cells

  /* Points far below the members have nobody near and are in cell -2; those that are LAST cells or
     more above the lowest member share one, so that keys fit in 64 bits. NaN counts as far
     below. */
  static constexpr std::int64_t LAST = std::int64_t(1) << 20;
  std::int64_t cell(double x, int a) const
  {
    const double number = std::floor((x - lo[a]) / reach);
    if (!(number > -2.0)) return -2;
    return number < LAST ? static_cast<std::int64_t>(number) : LAST;
  }
  std::int64_t key(std::int64_t ix, std::int64_t iy, std::int64_t iz) const
  {
    return (iz * count[1] + iy) * count[0] + ix;
  }
};

}    // namespace TMSPH
#endif
