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

double fixed_point_sum(const std::vector<double> &terms, MPI_Comm world)
{
  const int n = terms.size();
  const std::vector<double> ones(n, 1.0);
  double mine = largest_magnitude(n, terms.data()), largest;
  bigint count = n, total, all;
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(&count, &total, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  const double scale = fixed_point_scale(largest * (double) total);
  bigint sum = fixed_point_dot(n, terms.data(), ones.data(), scale);
  MPI_Allreduce(&sum, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return scale > 0.0 ? (double) all / scale : 0.0;
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
