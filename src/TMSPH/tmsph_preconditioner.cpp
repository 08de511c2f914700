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

static constexpr double SPACING = 3.0;     // of the nodes, in particle spacings
static constexpr int MOST = 6000;          // degrees of freedom of the grid
static constexpr double FREE = 1.0e-4;     // of the diagonal, against rigid motions
static constexpr double LOCAL = 0.3;       // stiffness of a particle, in M V/spacing^2

/* ---------------------------------------------------------------------- */

TMSPHPreconditioner::TMSPHPreconditioner(LAMMPS *lmp) :
    Pointers(lmp), pair(nullptr), version(-1), largest_compliance(0.0)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHPreconditioner::init(PairTMSPH *given)
{
  pair = given;
  version = -1;
  plane.grid.reset();
  space.grid.reset();
}

template <> TMSPHPreconditioner::Level<2> &TMSPHPreconditioner::level<2>() { return plane; }
template <> TMSPHPreconditioner::Level<3> &TMSPHPreconditioner::level<3>() { return space; }

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::build()
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
  auto grid = std::make_unique<CoarseGrid<D>>(most, most + 3, periodic, SPACING * pair->spacing(),
                                              MOST);

  double stiffest = 0.0, bound;
  for (int i = 0; i < atom->nlocal; i++)
    stiffest = std::max(stiffest,
                        atom->vfrac[i] * pair->material(atom->type[i]).elastic.wave_modulus);
  stiffest *= 2.0 * D * atom->natoms / std::pow(grid->narrowest(), 2);
  MPI_Allreduce(&stiffest, &bound, 1, MPI_DOUBLE, MPI_MAX, world);
  const double scale = fixed_point_scale(bound);
  mine.assign(grid->entries(), 0);
  all.resize(grid->entries());
  for (int i = 0; i < atom->nlocal; i++) {
    const Elastic &elastic = pair->material(atom->type[i]).elastic;
    grid->add_stiffness(atom->x0[i], atom->vfrac[i] * elastic.lambda,
                        atom->vfrac[i] * elastic.shear, scale, mine.data());
  }
  MPI_Allreduce(mine.data(), all.data(), mine.size(), MPI_INT64_T, MPI_SUM, world);
  if (grid->factorize(all.data(), scale, FREE)) level<D>().grid = std::move(grid);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::follow()
{
  if (version == pair->bonds()->layout_version()) return;
  if (version < 0) build<D>();
  version = pair->bonds()->layout_version();
  Level<D> &on = level<D>();
  on.places.clear();
  compliance.clear();
  const double square = std::pow(pair->spacing(), 2);
  double softest = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double modulus = pair->material(atom->type[i]).elastic.wave_modulus;
    compliance.push_back(square / (LOCAL * modulus * atom->vfrac[i]));
    softest = std::max(softest, compliance.back());
    if (on.grid) on.places.push_back(on.grid->place(atom->x0[i]));
  }
  MPI_Allreduce(&softest, &largest_compliance, 1, MPI_DOUBLE, MPI_MAX, world);
}

/* ---------------------------------------------------------------------- */

void TMSPHPreconditioner::apply(LBFGS::Vector &v)
{
  if (!pair) return;
  domain->dimension == 2 ? apply_in<2>(v) : apply_in<3>(v);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHPreconditioner::apply_in(LBFGS::Vector &v)
{
  follow<D>();
  const Level<D> &on = level<D>();
  const int nlocal = atom->nlocal;
  double bound = largest_compliance * v.bound;
  Eigen::VectorXd nodes;
  const double scale = fixed_point_scale(D * atom->natoms * v.bound);
  if (on.grid && scale > 0.0) {
    mine.assign(on.grid->freedoms(), 0);
    all.resize(mine.size());
    for (int i = 0; i < nlocal; i++) {
      const auto &place = on.places[i];
      for (int c = 0; c < CoarseGrid<D>::CORNERS; c++)
        for (int k = 0; k < D; k++)
          mine[place.node[c] * D + k] +=
              (int64_t) (scale * place.weight[c] * v.at[3 * (size_t) i + k]);
    }
    MPI_Allreduce(mine.data(), all.data(), mine.size(), MPI_INT64_T, MPI_SUM, world);
    nodes.resize(mine.size());
    for (size_t n = 0; n < mine.size(); n++) nodes[n] = all[n] / scale;
    nodes = on.grid->solve(nodes);
    bound += nodes.template lpNorm<Eigen::Infinity>();
  }
  for (int i = 0; i < nlocal; i++)
    for (int k = 0; k < 3; k++) {
      double &d = v.at[3 * (size_t) i + k];
      if (d == 0.0) continue;
      d *= compliance[i];
      if (!nodes.size() || k >= D) continue;
      const auto &place = on.places[i];
      for (int c = 0; c < CoarseGrid<D>::CORNERS; c++)
        d += place.weight[c] * nodes[place.node[c] * D + k];
    }
  v.bound = bound;
}

/* ---------------------------------------------------------------------- */

double TMSPHPreconditioner::memory_usage() const
{
  return compliance.capacity() * sizeof(double) + (mine.capacity() + all.capacity()) *
      sizeof(int64_t) + plane.places.capacity() * sizeof(CoarseGrid<2>::Place) +
      space.places.capacity() * sizeof(CoarseGrid<3>::Place);
}
