/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_sweep.h"

namespace TMSPH {
namespace {

TMSPH_INLINE Lanes pick(const double *values, const int *which)
{
  Lanes a;
  for (int l = 0; l < LANES; l++) a[l] = values[which[l]];
  return a;
}

template <bool VARIABLE>
void conduct(const Slices &bonds, const float *conductance, const double *temperature,
             const double *conductivity, double *power)
{
  for (int q = 0; q < bonds.count(); q++) {
    const int *particle = bonds.particle.data() + q * LANES;
    const Lanes T = pick(temperature, particle);
    Lanes k = broadcast(0.0), sum = broadcast(0.0);
    if constexpr (VARIABLE) k = pick(conductivity, particle);
    for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
      const size_t at = (size_t) b * LANES;
      const int *partner = bonds.partner.data() + at;
      Lanes flow = load(conductance + at) * (pick(temperature, partner) - T);
      if constexpr (VARIABLE) {
        const Lanes other = pick(conductivity, partner);
        flow *= 2.0 * (k * other) / (k + other);
      }
      sum += flow;
    }
    for (int l = 0; l < bonds.valid[q]; l++) power[particle[l]] = sum[l];
  }
}

}    // namespace

void heat_sweep(const Slices &bonds, const float *conductance, const double *temperature,
                const double *conductivity, double *power)
{
  if (conductivity)
    conduct<true>(bonds, conductance, temperature, conductivity, power);
  else
    conduct<false>(bonds, conductance, temperature, nullptr, power);
}

}    // namespace TMSPH
