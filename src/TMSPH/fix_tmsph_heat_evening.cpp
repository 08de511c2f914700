/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Conductances of irregular clouds that keep linear fields steady.

   The bonds of a particle on a lattice pull evenly: sum_j G_ij X_ij = 0, so that
   a linear field is steady. In an irregular cloud they do not; the temperatures
   then scatter about the field, by a share of its change over a spacing, and the
   cloud conducts less than the mean of its bonds. The conductances nearest to
   the given ones, sum (dG)^2 R^2/G least, that pull evenly are
     G_ij (1 + X_ij.(m_i - m_j)/R^2)
   with Lagrange multipliers m, one vector a particle. For them
     sum_j G_ij X_ij X_ij.(m_i - m_j)/R^2 = -(sum_j G_ij X_ij + A_i n_i),
   with the area A of the surface and its outward normal n: the equilibrium of a
   network of springs that pull along the bonds, solved by conjugate gradients.
   The outermost particles are left free and take what the guess of their areas
   lacks: as heat is conserved their pulls are then what a field of unit slope
   brings through the inside, and areas follow from them.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "domain.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "tmsph_collective.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// of the conductance is left at least, so that no temperature leaves the range of its neighbors

static constexpr double LEAST_SHARE = 0.1;

// conjugate gradients: reduction of the residual, and most iterations, a few for each particle
// between opposite surfaces

static constexpr double REDUCTION = 1.0e-6;
static constexpr int ITERATIONS = 2000;

/* ----------------------------------------------------------------------
   factor to the conductance of a bond with reference vector X from i to j
------------------------------------------------------------------------- */

double FixTMSPHHeat::evening(int i, int j, const double *X) const
{
  double along = 0.0, R2 = 0.0;
  for (int k = 0; k < domain->dimension; k++) {
    along += X[k] * (multipliers[k][i] - multipliers[k][j]);
    R2 += X[k] * X[k];
  }
  return std::max(1.0 + along / R2, LEAST_SHARE);
}

/* ----------------------------------------------------------------------
   Solves for the multipliers of particles whose bonds are all of one material,
   and scales c so that the conductances have the conductivity.
------------------------------------------------------------------------- */

template <int D> void FixTMSPHHeat::even_out()
{
  const int nlocal = atom->nlocal;
  const auto targets = pulls(false);
  const auto near = near_surface(targets);
  all_norms = stored(NORM);
  ghosts.complete(all_norms);

  struct Spring {
    int j;
    double X[D], stiffness;    // G, and G/R^2
    double conductance;
  };
  std::vector<Spring> springs;
  std::vector<size_t> first(nlocal + 1, 0);
  std::vector<char> free(nlocal);
  for (int i = 0; i < nlocal; i++) {
    free[i] = targets[i].outermost;
    for (int n = 0; n < bonds->count(i); n++) {
      const int j = bonds->partner_index(i, n);
      free[i] = free[i] || j == i || atom->type[j] != atom->type[i];
      if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
      double X[3], R2 = 0.0;
      bonds->reference_vector(i, j, X);
      Spring s;
      s.j = j;
      for (int a = 0; a < D; a++) {
        s.X[a] = X[a];
        R2 += X[a] * X[a];
      }
      s.conductance = (all_norms[i] + all_norms[j]) * bonds->weight(i, j);
      s.stiffness = s.conductance / R2;
      springs.push_back(s);
    }
    first[i + 1] = springs.size();
  }

  const size_t size = (size_t) nlocal * D;
  std::vector<double> m(size), residual(size), direction, force(size), terms(size),
      diagonal(nlocal);
  std::vector<double> all[D];    // a vector of local and ghost particles, by component
  const auto spread = [&](const std::vector<double> &v) {
    for (int a = 0; a < D; a++) {
      all[a].resize(nlocal);
      for (int i = 0; i < nlocal; i++) all[a][i] = v[i * D + a];
      ghosts.complete(all[a]);
    }
  };
  const auto dot = [&](const std::vector<double> &u, const std::vector<double> &v, bool scaled) {
    for (size_t n = 0; n < size; n++) terms[n] = u[n] * v[n] / (scaled ? diagonal[n / D] : 1.0);
    return fixed_point_sum(terms, world);
  };
  for (int i = 0; i < nlocal; i++) {
    for (size_t n = first[i]; n < first[i + 1]; n++) {
      diagonal[i] += springs[n].conductance / D;
      for (int a = 0; a < D; a++) residual[i * D + a] -= springs[n].conductance * springs[n].X[a];
    }
    for (int a = 0; a < D; a++) {
      double &r = residual[i * D + a];
      r = free[i] ? 0.0 : r - targets[i].area * targets[i].surface.normal[a];
    }
  }
  double square = dot(residual, residual, true);
  const double enough = REDUCTION * REDUCTION * square;
  direction.resize(size);
  for (size_t n = 0; n < size; n++) direction[n] = residual[n] / diagonal[n / D];
  for (int iteration = 0; iteration < ITERATIONS && square > enough; iteration++) {
    spread(direction);
    for (int i = 0; i < nlocal; i++) {
      double sum[D] = {};
      for (size_t n = first[i]; n < first[i + 1] && !free[i]; n++) {
        const Spring &s = springs[n];
        double along = 0.0;
        for (int a = 0; a < D; a++) along += s.X[a] * (all[a][i] - all[a][s.j]);
        for (int a = 0; a < D; a++) sum[a] += s.stiffness * along * s.X[a];
      }
      std::copy_n(sum, D, &force[i * D]);
    }
    const double step = square / dot(direction, force, false);
    if (!std::isfinite(step)) break;
    for (size_t n = 0; n < size; n++) {
      m[n] += step * direction[n];
      residual[n] -= step * force[n];
    }
    const double before = square;
    square = dot(residual, residual, true);
    for (size_t n = 0; n < size; n++)
      direction[n] = residual[n] / diagonal[n / D] + square / before * direction[n];
  }

  spread(m);
  for (int a = 0; a < D; a++) multipliers[a] = all[a];
  evened = true;
  for (int type = 1; type <= atom->ntypes; type++) {
    std::vector<double> before, after;
    for (int i = 0; i < nlocal; i++) {
      if (free[i] || near[i] || atom->type[i] != type) continue;
      double given = 0.0, now = 0.0;
      for (size_t n = first[i]; n < first[i + 1]; n++) {
        const Spring &s = springs[n];
        double R2 = 0.0;
        for (int a = 0; a < D; a++) R2 += s.X[a] * s.X[a];
        given += s.conductance * R2;
        now += s.conductance * R2 * evening(i, s.j, s.X);
      }
      before.push_back(given);
      after.push_back(now);
    }
    const double rest = fixed_point_sum(after, world), all_before = fixed_point_sum(before, world);
    for (int i = 0; i < nlocal && rest > 0.0; i++)
      if (atom->type[i] == type) norms->astore[i][NORM] *= all_before / rest;
  }
  for (int i = 0; i < nlocal; i++)
    for (int a = 0; a < D; a++) norms->astore[i][MULTIPLIER + a] = m[i * D + a];
}

template void FixTMSPHHeat::even_out<2>();
template void FixTMSPHHeat::even_out<3>();
