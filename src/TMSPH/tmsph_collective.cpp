/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_collective.h"

#include "lmptype.h"
#include "tmsph_fixed_point.h"

#include <algorithm>
#include <cmath>

using LAMMPS_NS::bigint;

namespace TMSPH {

// sums[width] of n terms of so many numbers each, in a common unit

static void add_up(int width, int n, const double *terms, double *sums, MPI_Comm world)
{
  double mine = largest_magnitude(width * n, terms), largest;
  bigint count = n, total;
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  const double scale = fixed_point_scale(largest * (double) total);
  std::vector<bigint> units(width), all(width);
  for (int t = 0; t < width * n; t++) units[t % width] += (bigint) (terms[t] * scale);
  MPI_Allreduce(units.data(), all.data(), width, MPI_LMP_BIGINT, MPI_SUM, world);
  for (int a = 0; a < width; a++) sums[a] = scale > 0.0 ? (double) all[a] / scale : 0.0;
}

double fixed_point_sum(const std::vector<double> &terms, MPI_Comm world)
{
  double sum;
  add_up(1, terms.size(), terms.data(), &sum, world);
  return sum;
}

std::array<double, 3> fixed_point_sum(const std::vector<std::array<double, 3>> &terms,
                                      MPI_Comm world)
{
  std::array<double, 3> sum;
  add_up(3, terms.size(), terms.empty() ? nullptr : terms[0].data(), sum.data(), world);
  return sum;
}

double median(const std::vector<double> &values, MPI_Comm world)
{
  double mine[2] = {-HUGE_VAL, 0.0}, range[2];
  for (double v : values) {
    mine[0] = std::max(mine[0], -v);
    mine[1] = std::max(mine[1], v);
  }
  MPI_Allreduce(mine, range, 2, MPI_DOUBLE, MPI_MAX, world);
  bigint count = values.size(), total, below, all;
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (!total) return 0.0;
  double low = -range[0], high = range[1];
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return high;
    below = std::count_if(values.begin(), values.end(), [=](double v) { return v <= middle; });
    MPI_Allreduce(&below, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    (2 * all < total ? low : high) = middle;
  }
}

}    // namespace TMSPH
