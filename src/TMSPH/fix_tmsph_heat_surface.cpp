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

template <int D> std::vector<FixTMSPHHeat::Pull> FixTMSPHHeat::pull_of_bonds(bool cracks)
{
  const int nlocal = atom->nlocal;
  std::vector<Pull> pulls(nlocal);
  for (int i = 0; i < nlocal; i++) {
    Pull &pull = pulls[i];
    const double c = norms->astore[i][NORM];
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
      if (faced) weight *= correction(i, j, X);
      for (int a = 0; a < D; a++) pull.conducted[a] -= 2.0 * c * weight * X[a];
    }
    pull.surface = own.find(bonds->spacing(i), EVEN);
    const Exposure exposure = pull.surface.exposure;
    if (exposure == Exposure::SURFACE) {
      pull.surface.depth = own.depth_of_rows(pull.surface, bonds->spacing(i));
      pull.area = 2.0 * c * own.length_of_sum();
    }
    pull.one_sidedness = own.one_sidedness();
    pull.outermost = exposure == Exposure::LOOSE || pull.one_sidedness > OUTERMOST;
  }
  return pulls;
}

/* ----------------------------------------------------------------------
   particles that are outermost or have a partner that is
------------------------------------------------------------------------- */

std::vector<char> FixTMSPHHeat::near_surface(const std::vector<Pull> &pulls)
{
  std::vector<double> outermost;
  for (const Pull &p : pulls) outermost.push_back(p.outermost);
  ghosts.complete(outermost);
  std::vector<char> near(pulls.size());
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

double FixTMSPHHeat::interior_noise(const std::vector<Pull> &pulls,
                                    const std::vector<char> &near) const
{
  std::vector<double> inside;
  for (size_t i = 0; i < pulls.size(); i++)
    if (!near[i]) inside.push_back(pulls[i].one_sidedness);
  return median(inside, world);
}

/* ----------------------------------------------------------------------
   of all local particles; those away from the surface have no area
------------------------------------------------------------------------- */

std::vector<FixTMSPHHeat::Pull> FixTMSPHHeat::pulls(bool cracks)
{
  auto pulls = domain->dimension == 2 ? pull_of_bonds<2>(cracks) : pull_of_bonds<3>(cracks);
  const std::vector<char> near = near_surface(pulls);
  for (int i = 0; i < atom->nlocal; i++)
    if (!near[i]) pulls[i].area = 0.0;
  const double noise = evened ? 0.0 : interior_noise(pulls, near);
  if (evened)
    smooth(pulls, IRREGULAR);
  else if (noise >= IRREGULAR)
    smooth(pulls, FAR_MORE * noise);
  return pulls;
}

/* ----------------------------------------------------------------------
   In an irregular cloud bonds pull unevenly too: of its particles those make the
   surface whose bonds pull far more so, and what the bonds of a neighborhood
   bring together gives the normal. Along it the pulls of the surface add up to
   those that a field of unit slope brings through the inside, as heat is
   conserved.
   @param least one-sidedness of the surface
------------------------------------------------------------------------- */

void FixTMSPHHeat::smooth(std::vector<Pull> &pulls, double least)
{
  // the normal from the pulls of the neighborhood, summed up in two passes: it scatters by less
  // than a hundredth then

  const int nlocal = atom->nlocal;
  std::vector<double> smoothed[3], sums[3];
  for (int k = 0; k < 3; k++)
    for (Pull &pull : pulls) {
      if (pull.one_sidedness < least) pull.area = 0.0;
      smoothed[k].push_back(pull.area * pull.surface.normal[k]);
    }
  for (int pass = 0; pass < PASSES; pass++)
    for (int k = 0; k < 3; k++) {
      ghosts.complete(smoothed[k]);
      sums[k].assign(nlocal, 0.0);
      for (int i = 0; i < nlocal; i++) {
        if (pulls[i].area == 0.0) continue;
        sums[k][i] = smoothed[k][i];
        for (int n = 0; n < bonds->count(i); n++) {
          const int j = bonds->partner_index(i, n);
          if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
          sums[k][i] += smoothed[k][j];
        }
      }
      smoothed[k] = sums[k];
    }
  for (int i = 0; i < nlocal; i++) {
    Pull &pull = pulls[i];
    if (pull.area == 0.0) continue;
    double square = 0.0, along = 0.0;
    for (int k = 0; k < 3; k++) {
      square += smoothed[k][i] * smoothed[k][i];
      along += smoothed[k][i] * pull.surface.normal[k];
    }
    const double length = std::sqrt(square);
    pull.area *= along > 0.0 ? along / length : 0.0;
    for (int k = 0; k < 3 && length > 0.0; k++) pull.surface.normal[k] = smoothed[k][i] / length;
  }
}

/* ----------------------------------------------------------------------
   flat faces of a lattice take their shares each, else there is one piece to a particle
------------------------------------------------------------------------- */

std::vector<FixTMSPHHeat::SurfaceShare> FixTMSPHHeat::surface(bool cracks)
{
  const auto found = pulls(cracks);
  const bool plane = domain->dimension == 2;
  std::vector<SurfaceShare> shares;
  for (int i = 0; i < atom->nlocal; i++) {
    const bool told_apart = faced && (plane ? share_faces<2>(i, found[i], cracks, shares)
                                            : share_faces<3>(i, found[i], cracks, shares));
    if (!told_apart && found[i].area > 0.0)
      shares.push_back({i, found[i].surface, found[i].area, false});
  }
  return shares;
}
