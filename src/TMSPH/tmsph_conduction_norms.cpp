/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_conduction_norms.h"

#include "domain.h"
#include "fix_tmsph_bond.h"
#include "modify.h"
#include "tmsph_collective.h"
#include "tmsph_interface.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

// a particle is at least this fraction of its spacing below an interface: two depths of 0 would
// have no conductance. On lattices it is half; 0.02 does the same in test_heat_cracks

static constexpr double LEAST_DEPTH = 0.1;

/* ---------------------------------------------------------------------- */

TMSPHConductionNorms::~TMSPHConductionNorms()
{
  if (modify->nfix && modify->get_fix_by_id(store_id)) modify->delete_fix(store_id);
}

/* ---------------------------------------------------------------------- */

void TMSPHConductionNorms::keep(const std::string &id)
{
  store_id = id + "_TMSPH_NORM";
  store = dynamic_cast<FixStoreAtom *>(modify->add_fix(
      fmt::format("{} all STORE/ATOM {} 0 0 1", store_id, MULTIPLIER + domain->dimension)));
}

/* ---------------------------------------------------------------------- */

void TMSPHConductionNorms::init(const FixTMSPHBond *owner, const TMSPHBondUser *style)
{
  bonds = owner;
  user = style;
}

/* ---------------------------------------------------------------------- */

bool TMSPHConductionNorms::lacking() const
{
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal; i++) mine = mine || frozen_norm(i) == 0.0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  return any;
}

/* ---------------------------------------------------------------------- */

std::vector<double> TMSPHConductionNorms::second_moments() const
{
  std::vector<double> second(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED)) {
      double X[3];
      bonds->reference_vector(i, bond.j, X);
      second[i] += bonds->weight(i, bond.j) * (X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
    }
    second[i] /= atom->vfrac[i];
  }
  return second;
}

/* ----------------------------------------------------------------------
   of the particles of a type inside, or the largest where all are near a surface
------------------------------------------------------------------------- */

double TMSPHConductionNorms::typical(int type, const std::vector<double> &second,
                                     const std::vector<char> &near) const
{
  std::vector<double> inside;
  double mine = 0.0, largest;
  for (int i = 0; i < atom->nlocal; i++) {
    if (atom->type[i] != type) continue;
    mine = std::max(mine, second[i]);
    if (!near[i]) inside.push_back(second[i]);
  }
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  const double middle = median(inside, world);
  return middle > 0.0 ? middle : largest;
}

/* ---------------------------------------------------------------------- */

void TMSPHConductionNorms::set(const std::vector<double> &second, const std::vector<char> &near)
{
  const int dimension = domain->dimension;
  for (int type = 1; type <= atom->ntypes; type++) {
    const double sum = typical(type, second, near);
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->type[i] == type) frozen_norm(i) = dimension / (near[i] ? sum : second[i]);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHConductionNorms::find_depths()
{
  std::vector<InterfaceDepth> depth_in(atom->ntypes + 1);
  for (int type = 1; type <= atom->ntypes && atom->ntypes > 1; type++)
    depth_in[type] =
        InterfaceDepth(user->kernel_of_bonds(), domain->dimension, user->horizon(type, type));
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double reach = user->horizon(type, type);
    double own = bonds->kernel_mass(i, i, reach), total = own;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED)) {
      const double mass = bonds->kernel_mass(i, bond.j, reach);
      if (atom->type[bond.j] == type) own += mass;
      total += mass;
    }
    store->astore[i][DEPTH] =
        own == total ? 0.0 : std::max(depth_in[type](own / total), LEAST_DEPTH * bonds->spacing(i));
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHConductionNorms::complete(TMSPHGhostSender &ghosts)
{
  present.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++)
    std::copy_n(store->astore[i], present.columns(), present[i]);
  ghosts.complete(present);
}
