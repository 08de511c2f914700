/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_preconditioner.h"

#include "atom.h"
#include "domain.h"
#include "pair_tmsph.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// Nodes 2 to 4 spacings apart and 0.15 to 0.6 for LOCAL make 5 % of the evaluations
// (doc/report/quasistatic.md); 1e-6 for FREE and 0.1 to 2 for HOLD one of 25, FREE 1e-2 five
// (test_quasistatic). MOST bounds the time of a factorization, of which REBUILDS are some more

static constexpr double SPACING = 3.0;    // of the nodes, in particle spacings
static constexpr int MOST = 6000;         // degrees of freedom of the grid
static constexpr double FREE = 1.0e-4;    // of the diagonal, against rigid motions
static constexpr double LOCAL = 0.5;      // stiffness of a particle, in M V/spacing^2
static constexpr double HOLD = 0.5;       // spring of a held particle, in the same unit
static constexpr int REBUILDS = 20;       // of the grid in a minimization

/* ---------------------------------------------------------------------- */

TMSPHPreconditioner::TMSPHPreconditioner(LAMMPS *lmp) :
    Pointers(lmp), pair(nullptr), version(-1), largest_compliance(0.0), held(0), rebuilds(0)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHPreconditioner::init(PairTMSPH *given)
{
  pair = given;
  version = -1;
  rebuilds = 0;
  plane.grid.reset();
  space.grid.reset();
}

template <> TMSPHPreconditioner::Level<2> &TMSPHPreconditioner::level<2>()
{
  return plane;
}
template <> TMSPHPreconditioner::Level<3> &TMSPHPreconditioner::level<3>()
{
  return space;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::make_grid()
{
  double ends[6], most[6];    // low, negative, and high
  bool periodic[3];
  for (int k = 0; k < 3; k++) {
    periodic[k] = domain->periodicity[k];
    ends[k] = periodic[k] ? -domain->boxlo[k] : -HUGE_VAL;
    ends[3 + k] = periodic[k] ? domain->boxhi[k] : -HUGE_VAL;
    for (int i = 0; i < atom->nlocal && !periodic[k]; i++) {
      ends[k] = std::max(ends[k], -atom->x0[i][k]);
      ends[3 + k] = std::max(ends[3 + k], atom->x0[i][k]);
    }
  }
  MPI_Allreduce(ends, most, 6, MPI_DOUBLE, MPI_MAX, world);
  for (int k = 0; k < 3; k++) most[k] = -most[k];
  level<D>().grid =
      std::make_unique<CoarseGrid<D>>(most, most + 3, periodic, SPACING * pair->spacing(), MOST);
}

/* ----------------------------------------------------------------------
   stiffness of the body on the grid. A held particle in a field that is not zero there
   strains its neighborhood: a spring.
------------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::build(const double *forces)
{
  CoarseGrid<D> &grid = *level<D>().grid;
  const double square = std::pow(pair->spacing(), 2);
  double stiffest = 0.0, bound;
  for (int i = 0; i < atom->nlocal; i++)
    stiffest = std::max(stiffest, atom->vfrac[i] * pair->elastic(i).wave_modulus);
  stiffest *= atom->natoms * (2.0 * D / std::pow(grid.narrowest(), 2) + HOLD / square);
  MPI_Allreduce(&stiffest, &bound, 1, MPI_DOUBLE, MPI_MAX, world);
  const double scale = fixed_point_scale(bound);
  mine.assign(grid.entries(), 0);
  all.resize(grid.entries());
  for (int i = 0; i < atom->nlocal; i++) {
    const Elastic &elastic = pair->elastic(i);
    const double volume = atom->vfrac[i];
    grid.add_stiffness(atom->x0[i], volume * elastic.lambda, volume * elastic.shear, scale,
                       mine.data());
    for (int k = 0; k < D; k++)
      if (forces[3 * (size_t) i + k] == 0.0)
        grid.add_spring(level<D>().places[i], k, HOLD * elastic.wave_modulus * volume / square,
                        scale, mine.data());
  }
  MPI_Allreduce(mine.data(), all.data(), mine.size(), MPI_LL, MPI_SUM, world);
  if (!grid.factorize(all.data(), scale, FREE)) rebuilds = -1;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::follow()
{
  if (version == pair->bonds()->layout_version()) return;
  if (version < 0) make_grid<D>();
  version = pair->bonds()->layout_version();
  Level<D> &on = level<D>();
  on.places.clear();
  compliance.clear();
  const double square = std::pow(pair->spacing(), 2);
  double softest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double modulus = pair->elastic(i).wave_modulus;
    compliance.push_back(square / (LOCAL * modulus * atom->vfrac[i]));
    softest = std::max(softest, compliance.back());
    on.places.push_back(on.grid->place(atom->x0[i]));
  }
  MPI_Allreduce(&softest, &largest_compliance, 1, MPI_DOUBLE, MPI_MAX, world);
}

/* ---------------------------------------------------------------------- */

void TMSPHPreconditioner::apply(LBFGS::Vector &v)
{
  if (!pair) return;
  domain->dimension == 2 ? apply_in<2>(v) : apply_in<3>(v);
}

/* ----------------------------------------------------------------------
   forces on the nodes of the grid, in an order-independent sum, and along with it the number of
   components that are held: when it changes, the grid is not that of this problem
   return false if there is no grid
------------------------------------------------------------------------- */

template <int D> bool TMSPHPreconditioner::restrict(const LBFGS::Vector &v, Eigen::VectorXd &nodes)
{
  const Level<D> &on = level<D>();
  const double scale = fixed_point_scale(D * atom->natoms * v.bound);
  if (rebuilds < 0 || scale == 0.0) return false;
  const int n = on.grid->freedoms();
  mine.assign(n + 1, 0);
  all.resize(n + 1);
  for (int i = 0; i < atom->nlocal; i++) {
    const auto &place = on.places[i];
    const double *force = v.at + 3 * (size_t) i;
    for (int k = 0; k < D; k++) mine[n] += force[k] == 0.0;
    for (int c = 0; c < CoarseGrid<D>::CORNERS; c++)
      for (int k = 0; k < D; k++)
        mine[place.node[c] * D + k] += (int64_t) (scale * place.weight[c] * force[k]);
  }
  MPI_Allreduce(mine.data(), all.data(), n + 1, MPI_LL, MPI_SUM, world);
  nodes.resize(n);
  for (int m = 0; m < n; m++) nodes[m] = all[m] / scale;
  if (rebuilds == 0 || (all[n] != held && rebuilds < REBUILDS)) {
    held = all[n];
    rebuilds++;
    build<D>(v.at);
  }
  return rebuilds > 0;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::apply_in(LBFGS::Vector &v)
{
  follow<D>();
  double bound = largest_compliance * v.bound;
  Eigen::VectorXd nodes;
  const bool coarse = restrict<D>(v, nodes);
  if (coarse) {
    nodes = level<D>().grid->solve(nodes);
    bound += nodes.template lpNorm<Eigen::Infinity>();
  }
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) {
      double &d = v.at[3 * (size_t) i + k];
      if (d == 0.0) continue;
      d *= compliance[i];
      if (!coarse || k >= D) continue;
      const auto &place = level<D>().places[i];
      for (int c = 0; c < CoarseGrid<D>::CORNERS; c++)
        d += place.weight[c] * nodes[place.node[c] * D + k];
    }
  v.bound = bound;
}

/* ---------------------------------------------------------------------- */

double TMSPHPreconditioner::memory_usage() const
{
  return compliance.capacity() * sizeof(double) +
      (mine.capacity() + all.capacity()) * sizeof(int64_t) +
      plane.places.capacity() * sizeof(CoarseGrid<2>::Place) +
      space.places.capacity() * sizeof(CoarseGrid<3>::Place);
}
