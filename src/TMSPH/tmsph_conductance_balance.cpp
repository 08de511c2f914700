/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_conductance_balance.h"

#include "domain.h"
#include "fix_tmsph_bond.h"
#include "tmsph_collective.h"
#include "tmsph_conduction_norms.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// of the conductance is left at least, so that no temperature leaves the range of its neighbors;
// clouds that are jittered by 0.2 stay above: 0.01 to 0.3 do the same in test_heat_slab

static constexpr double LEAST_LEFT = 0.1;

// conjugate gradients: reduction of the residual, with 1e-4 the errors of test_heat_slab change by
// less than 1 %, with 1e-8 not at all; and most iterations, a few for each particle between
// opposite surfaces

static constexpr double REDUCTION = 1.0e-6;
static constexpr int ITERATIONS = 2000;

namespace {

/** The network of springs along the bonds, and its equilibrium. */
template <int D> class Springs : protected Pointers {
 public:
  struct Spring {
    int j;
    double X[D], stiffness;    // G, and G/R^2
    double conductance;
  };

  Springs(LAMMPS *lmp, const FixTMSPHBond &bonds, const TMSPHConductionNorms &norms,
          const std::vector<BondPull> &pulls);
  /// multipliers [nlocal][D] (collective)
  std::vector<double> solve(const std::vector<BondPull> &pulls, TMSPHGhostSender &);
  /// fills rows of local and ghost particles (collective)
  void spread(const std::vector<double> &v, TMSPHGhostRows &rows, TMSPHGhostSender &) const;

  // of local particle i those from first[i] to first[i+1]; one that is free has no multipliers

  std::vector<Spring> springs;
  std::vector<size_t> first;
  std::vector<char> free;

 private:
  std::vector<double> residual, diagonal, terms;

  void begin(const std::vector<BondPull> &pulls);
  void find_forces(const TMSPHGhostRows &direction, std::vector<double> &force) const;
  double dot(const std::vector<double> &u, const std::vector<double> &v, bool scaled);
};

/* ---------------------------------------------------------------------- */

template <int D>
Springs<D>::Springs(LAMMPS *lmp, const FixTMSPHBond &bonds, const TMSPHConductionNorms &norms,
                    const std::vector<BondPull> &pulls) :
    Pointers(lmp),
    first(atom->nlocal + 1, 0), free(atom->nlocal)
{
  for (int i = 0; i < atom->nlocal; i++) {
    free[i] = pulls[i].outermost;
    for (int n = 0; n < bonds.count(i); n++) {
      const int j = bonds.partner_index(i, n);
      free[i] = free[i] || j == i || atom->type[j] != atom->type[i];
      if (j == i || bonds.bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
      double X[3], R2 = 0.0;
      bonds.reference_vector(i, j, X);
      Spring s;
      s.j = j;
      for (int a = 0; a < D; a++) {
        s.X[a] = X[a];
        R2 += X[a] * X[a];
      }
      s.conductance = (norms.norm(i) + norms.norm(j)) * bonds.weight(i, j);
      s.stiffness = s.conductance / R2;
      springs.push_back(s);
    }
    first[i + 1] = springs.size();
  }
}

/* ---------------------------------------------------------------------- */

template <int D>
void Springs<D>::spread(const std::vector<double> &v, TMSPHGhostRows &rows,
                        TMSPHGhostSender &ghosts) const
{
  rows.resize(atom->nlocal);
  std::copy(v.begin(), v.end(), rows[0]);
  ghosts.complete(rows);
}

/* ---------------------------------------------------------------------- */

template <int D>
double Springs<D>::dot(const std::vector<double> &u, const std::vector<double> &v, bool scaled)
{
  terms.resize(u.size());
  for (size_t n = 0; n < u.size(); n++) terms[n] = u[n] * v[n] / (scaled ? diagonal[n / D] : 1.0);
  return fixed_point_sum(terms, world);
}

/* ----------------------------------------------------------------------
   loads of the network, and what scales them
------------------------------------------------------------------------- */

template <int D> void Springs<D>::begin(const std::vector<BondPull> &pulls)
{
  residual.assign((size_t) atom->nlocal * D, 0.0);
  diagonal.assign(atom->nlocal, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    for (size_t n = first[i]; n < first[i + 1]; n++) {
      diagonal[i] += springs[n].conductance / D;
      for (int a = 0; a < D; a++) residual[i * D + a] -= springs[n].conductance * springs[n].X[a];
    }
    for (int a = 0; a < D; a++) {
      double &r = residual[i * D + a];
      r = free[i] ? 0.0 : r - pulls[i].area * pulls[i].surface.normal[a];
    }
  }
}

/* ---------------------------------------------------------------------- */

template <int D>
void Springs<D>::find_forces(const TMSPHGhostRows &direction, std::vector<double> &force) const
{
  for (int i = 0; i < atom->nlocal; i++) {
    double sum[D] = {};
    for (size_t n = first[i]; n < first[i + 1] && !free[i]; n++) {
      const Spring &s = springs[n];
      const double *own = direction[i], *other = direction[s.j];
      double along = 0.0;
      for (int a = 0; a < D; a++) along += s.X[a] * (own[a] - other[a]);
      for (int a = 0; a < D; a++) sum[a] += s.stiffness * along * s.X[a];
    }
    std::copy_n(sum, D, &force[i * D]);
  }
}

/* ---------------------------------------------------------------------- */

template <int D>
std::vector<double> Springs<D>::solve(const std::vector<BondPull> &pulls, TMSPHGhostSender &ghosts)
{
  const size_t size = (size_t) atom->nlocal * D;
  std::vector<double> m(size), direction(size), force(size);
  TMSPHGhostRows rows(D);
  begin(pulls);
  double square = dot(residual, residual, true);
  const double enough = REDUCTION * REDUCTION * square;
  for (size_t n = 0; n < size; n++) direction[n] = residual[n] / diagonal[n / D];
  for (int iteration = 0; iteration < ITERATIONS && square > enough; iteration++) {
    spread(direction, rows, ghosts);
    find_forces(rows, force);
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
  return m;
}

}    // namespace

/* ---------------------------------------------------------------------- */

TMSPHConductanceBalance::TMSPHConductanceBalance(LAMMPS *lmp, TMSPHConductionNorms &kept,
                                                 TMSPHGhostSender &sender) :
    Pointers(lmp),
    norms(kept), ghosts(sender), multipliers(domain->dimension)
{
}

/* ---------------------------------------------------------------------- */

double TMSPHConductanceBalance::factor(int i, int j, const double *X) const
{
  const double *own = multipliers[i], *other = multipliers[j];
  double along = 0.0, R2 = 0.0;
  for (int k = 0; k < domain->dimension; k++) {
    along += X[k] * (own[k] - other[k]);
    R2 += X[k] * X[k];
  }
  return std::max(1.0 + along / R2, LEAST_LEFT);
}

/* ---------------------------------------------------------------------- */

void TMSPHConductanceBalance::solve(const std::vector<BondPull> &pulls,
                                    const std::vector<char> &near)
{
  if (domain->dimension == 2)
    solve_in<2>(pulls, near);
  else
    solve_in<3>(pulls, near);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHConductanceBalance::solve_in(const std::vector<BondPull> &pulls,
                                       const std::vector<char> &near)
{
  const int nlocal = atom->nlocal;
  norms.complete(ghosts);
  Springs<D> network(lmp, *bonds, norms, pulls);
  const std::vector<double> m = network.solve(pulls, ghosts);
  network.spread(m, multipliers, ghosts);
  balanced = true;
  for (int type = 1; type <= atom->ntypes; type++) {
    std::vector<double> before, after;
    for (int i = 0; i < nlocal; i++) {
      if (network.free[i] || near[i] || atom->type[i] != type) continue;
      double given = 0.0, now = 0.0;
      for (size_t n = network.first[i]; n < network.first[i + 1]; n++) {
        const auto &s = network.springs[n];
        double R2 = 0.0;
        for (int a = 0; a < D; a++) R2 += s.X[a] * s.X[a];
        given += s.conductance * R2;
        now += s.conductance * R2 * factor(i, s.j, s.X);
      }
      before.push_back(given);
      after.push_back(now);
    }
    const double rest = fixed_point_sum(after, world), whole = fixed_point_sum(before, world);
    for (int i = 0; i < nlocal && rest > 0.0; i++)
      if (atom->type[i] == type) norms.frozen_norm(i) *= whole / rest;
  }
  for (int i = 0; i < nlocal; i++) std::copy_n(&m[i * D], D, norms.frozen_multipliers(i));
}

/* ---------------------------------------------------------------------- */

void TMSPHConductanceBalance::complete()
{
  int mine = 0, any_of_all;
  for (int i = 0; i < atom->nlocal && !mine; i++)
    for (int a = 0; a < domain->dimension; a++) mine |= norms.frozen_multipliers(i)[a] != 0.0;
  MPI_Allreduce(&mine, &any_of_all, 1, MPI_INT, MPI_MAX, world);
  balanced = any_of_all != 0;
  if (!balanced) return;
  multipliers.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++)
    std::copy_n(norms.frozen_multipliers(i), domain->dimension, multipliers[i]);
  ghosts.complete(multipliers);
}
