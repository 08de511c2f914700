/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface of the body of fix tmsph/heat.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "domain.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "tmsph_collective.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// one-sidedness of the particles in the outermost row of a surface, at least: of a flat one it is
// about 0.45, inside an irregular cloud below 0.15

static constexpr double OUTERMOST = 0.25;

// less than this is round-off

static constexpr double EVEN = 1.0e-6;

// one-sidedness of surfaces in an irregular cloud, in multiples of that inside it

static constexpr double FAR_MORE = 3.0;

// of smoothing of normals there

static constexpr int PASSES = 2;

/* ----------------------------------------------------------------------
   Normal, depth and area of the surface near each local particle. With
     A_i = 2 c V_i |sum_j V_j grad W_ij|
   a field that varies linearly with the depth is steady at each particle near a
   flat surface at the right temperature: what its bonds bring, A_i k dT/dn, is
   what its share of the surface takes.
------------------------------------------------------------------------- */

template <int D> std::vector<FixTMSPHHeat::SurfaceShare> FixTMSPHHeat::classify(bool cracks)
{
  const int nlocal = atom->nlocal;
  std::vector<SurfaceShare> shares(nlocal);
  for (int i = 0; i < nlocal; i++) {
    OwnSurface<D> own;
    for (int k = 0; k < bonds->count(i); k++) {
      const int j = bonds->partner_index(i, k), state = bonds->bond_state(i, k);
      if (j == i || state == FixTMSPHBond::UNBONDED) continue;
      if (cracks && state != FixTMSPHBond::INTACT) continue;
      double X[3];
      bonds->reference_vector(i, j, X);
      double weight = bonds->weight(i, j);
      if (evened) weight *= 0.5 * (1.0 + all_norms[j] / all_norms[i]) * evening(i, j, X);
      own.add(X, weight);
    }
    SurfaceShare &share = shares[i];
    share.surface = own.find(bonds->spacing(i), EVEN);
    const Exposure exposure = share.surface.exposure;
    if (exposure == Exposure::SURFACE) {
      share.surface.depth = own.depth_of_rows(share.surface, bonds->spacing(i));
      share.area = 2.0 * norms->astore[i][NORM] * own.length_of_sum();
    }
    share.one_sidedness = own.one_sidedness();
    share.outermost = exposure == Exposure::LOOSE || share.one_sidedness > OUTERMOST;
  }
  return shares;
}

/* ----------------------------------------------------------------------
   particles that are outermost or have a partner that is
------------------------------------------------------------------------- */

std::vector<char> FixTMSPHHeat::near_surface(const std::vector<SurfaceShare> &shares)
{
  std::vector<double> outermost;
  for (const SurfaceShare &s : shares) outermost.push_back(s.outermost);
  share(outermost);
  std::vector<char> near(shares.size());
  for (int i = 0; i < atom->nlocal; i++) {
    near[i] = outermost[i] != 0.0;
    for (int k = 0; k < bonds->count(i) && !near[i]; k++)
      near[i] = bonds->bond_state(i, k) != FixTMSPHBond::UNBONDED &&
          outermost[bonds->partner_index(i, k)] != 0.0;
  }
  return near;
}

/* ----------------------------------------------------------------------
   typical one-sidedness of particles away from any surface: 0 on a lattice
------------------------------------------------------------------------- */

double FixTMSPHHeat::interior_noise(const std::vector<SurfaceShare> &shares,
                                    const std::vector<char> &near) const
{
  std::vector<double> inside;
  for (size_t i = 0; i < shares.size(); i++)
    if (!near[i]) inside.push_back(shares[i].one_sidedness);
  return median(inside, world);
}

/* ----------------------------------------------------------------------
   In an irregular cloud bonds pull unevenly too: of its particles those make the
   surface whose bonds pull far more so, and what the bonds of a neighborhood
   bring together gives the normal. Along it the pulls of the surface add up to
   those that a field of unit slope brings through the inside, as heat is
   conserved.
------------------------------------------------------------------------- */

std::vector<FixTMSPHHeat::SurfaceShare> FixTMSPHHeat::surface(bool cracks)
{
  const int nlocal = atom->nlocal;
  std::vector<SurfaceShare> shares = domain->dimension == 2 ? classify<2>(cracks)
                                                            : classify<3>(cracks);
  const std::vector<char> near = near_surface(shares);
  for (int i = 0; i < nlocal; i++)
    if (!near[i]) shares[i].area = 0.0;
  double least = IRREGULAR;
  if (!evened) {
    const double noise = interior_noise(shares, near);
    if (noise < IRREGULAR) return shares;
    least = FAR_MORE * noise;
  }

  // the normal from the pulls of the neighborhood, summed up in two passes: it scatters by less
  // than a hundredth then

  std::vector<double> smooth[3], sums[3];
  for (int k = 0; k < 3; k++)
    for (SurfaceShare &share : shares) {
      if (share.one_sidedness < least) share.area = 0.0;
      smooth[k].push_back(share.area * share.surface.normal[k]);
    }
  for (int pass = 0; pass < PASSES; pass++)
    for (int k = 0; k < 3; k++) {
      share(smooth[k]);
      sums[k].assign(nlocal, 0.0);
      for (int i = 0; i < nlocal; i++) {
        if (shares[i].area == 0.0) continue;
        sums[k][i] = smooth[k][i];
        for (int n = 0; n < bonds->count(i); n++) {
          const int j = bonds->partner_index(i, n);
          if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
          sums[k][i] += smooth[k][j];
        }
      }
      smooth[k] = sums[k];
    }
  for (int i = 0; i < nlocal; i++) {
    SurfaceShare &share = shares[i];
    if (share.area == 0.0) continue;
    double square = 0.0, along = 0.0;
    for (int k = 0; k < 3; k++) {
      square += smooth[k][i] * smooth[k][i];
      along += smooth[k][i] * share.surface.normal[k];
    }
    const double length = std::sqrt(square);
    share.area *= along > 0.0 ? along / length : 0.0;
    for (int k = 0; k < 3 && length > 0.0; k++) share.surface.normal[k] = smooth[k][i] / length;
  }
  return shares;
}
