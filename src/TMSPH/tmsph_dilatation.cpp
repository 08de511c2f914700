/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Averaged dilatation; see tmsph_dilatation.h for the equations.
------------------------------------------------------------------------- */

#include "tmsph_dilatation.h"

namespace TMSPH {
namespace {

TMSPH_INLINE Lanes gather(const double *value, const int *index)
{
  Lanes a;
  for (int l = 0; l < LANES; l++) a[l] = value[index[l]];
  return a;
}

template <int D> Matrix<D, double> deformation_of(const double *H)
{
  Matrix<D, double> F;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) F[i][j] = H[i * D + j] + (i == j);
  return F;
}

}    // namespace

template <int D> void average_sweep(const Slices &bonds, const double *value, double *mean)
{
  for (int q = 0; q < bonds.count(); q++) {
    const int *particle = bonds.particle.data() + q * LANES;
    const Lanes mine = gather(value, particle);
    Lanes sum = broadcast(0.0);
    for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
      const size_t at = (size_t) b * LANES;
      sum += load(bonds.averaging.data() + at) * (gather(value, bonds.partner.data() + at) - mine);
    }
    const Lanes volume = load(bonds.own.data() + ((size_t) q * CONSTANTS<D> + SYMMETRIC<D>) *LANES);
    const Lanes result = mine + sum / volume;
    for (int l = 0; l < bonds.valid[q]; l++) mean[particle[l]] = result[l];
  }
}

template <int D> void add_pressure(double q, const double *H, const double *own, double *force_row)
{
  const double volume = own[LANES * SYMMETRIC<D>];
  const Matrix<D, double> FK = product(deformation_of<D>(H), shape_inverse<D>(own));
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) force_row[Rows<D>::B + a * D + b] += volume * q * FK[a][b];
}

template <int D> void add_pressure_stress(double q, const double *H, double stretch, double *stress)
{
  const Matrix<D, double> F = deformation_of<D>(H);
  const double J = determinant(F);
  if (!(J > 0.0)) return;
  double scale = q / J;
  for (int k = 0; k < D; k++) scale /= stretch;
  const Matrix<D, double> FF = product_transposed(F, F);
  for (int i = 0, k = D; i < D; i++) {
    stress[i] += scale * FF[i][i];
    for (int j = i + 1; j < D; j++) stress[k++] += scale * FF[i][j];
  }
}

template void average_sweep<2>(const Slices &, const double *, double *);
template void average_sweep<3>(const Slices &, const double *, double *);
template void add_pressure<2>(double, const double *, const double *, double *);
template void add_pressure<3>(double, const double *, const double *, double *);
template void add_pressure_stress<2>(double, const double *, double, double *);
template void add_pressure_stress<3>(double, const double *, double, double *);

}    // namespace TMSPH
