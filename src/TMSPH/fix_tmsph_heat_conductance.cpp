/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Conductances of the bonds of fix tmsph/heat.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "domain.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "pair_tmsph.h"
#include "tmsph_collective.h"
#include "tmsph_conduction.h"
#include "tmsph_interface.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// a particle is at least this share of its spacing below an interface

static constexpr double LEAST_DEPTH = 0.1;

/* ----------------------------------------------------------------------
   c = D/sum_j V_j w R^2 of each particle from all bonds that it had, so that
   broken ones do not make the others conduct better. Near a surface, where the
   sum lacks terms, that of the interior.
------------------------------------------------------------------------- */

void FixTMSPHHeat::find_norms()
{
  const int nlocal = atom->nlocal, dimension = domain->dimension;
  int lacking = 0, any;
  for (int i = 0; i < nlocal; i++) lacking = lacking || norms->astore[i][NORM] == 0.0;
  MPI_Allreduce(&lacking, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;
  evened = faced = false;
  drop_all_faces();

  std::vector<double> second(nlocal);    // sum_j V_j w R^2
  for (int i = 0; i < nlocal; i++) {
    for (int k = 0; k < bonds->count(i); k++) {
      const int j = bonds->partner_index(i, k);
      if (j == i || bonds->bond_state(i, k) == FixTMSPHBond::UNBONDED) continue;
      double X[3];
      bonds->reference_vector(i, j, X);
      second[i] += bonds->weight(i, j) * (X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
    }
    second[i] /= atom->vfrac[i];
  }
  const auto found = pulls(false);
  const std::vector<char> near = near_surface(found);
  const bool irregular = interior_noise(found, near) >= IRREGULAR;
  if (!irregular) dimension == 2 ? find_layers<2>(near, second) : find_layers<3>(near, second);
  const auto typical = [&](int type) {
    std::vector<double> inside;
    double mine = 0.0, largest;
    for (int i = 0; i < nlocal; i++) {
      if (atom->type[i] != type) continue;
      mine = std::max(mine, second[i]);
      if (!near[i]) inside.push_back(second[i]);
    }
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    const double middle = median(inside, world);
    return middle > 0.0 ? middle : largest;
  };
  for (int type = 1; type <= atom->ntypes; type++) {
    const double sum = typical(type);
    for (int i = 0; i < nlocal; i++)
      if (atom->type[i] == type) norms->astore[i][NORM] = dimension / (near[i] ? sum : second[i]);
  }
  find_depths();
  if (irregular) dimension == 2 ? even_out<2>() : even_out<3>();
  for (int type = 1; type <= atom->ntypes; type++)
    if (substances[type].orthotropic)
      dimension == 2 ? calibrate<2>(type, near) : calibrate<3>(type, near);
}

/* ----------------------------------------------------------------------
   depth below the interface to another type, of particles near one
------------------------------------------------------------------------- */

void FixTMSPHHeat::find_depths()
{
  std::vector<InterfaceDepth> depth_in(atom->ntypes + 1);
  for (int type = 1; type <= atom->ntypes && atom->ntypes > 1; type++)
    depth_in[type] = InterfaceDepth(pair->kernel_of_bonds(), domain->dimension,
                                    pair->horizon(type, type));
  for (int i = 0; i < atom->nlocal; i++) {
    const int type = atom->type[i];
    const double reach = pair->horizon(type, type);
    double own = bonds->kernel_mass(i, i, reach), all = own;
    for (int n = 0; n < bonds->count(i); n++) {
      const int j = bonds->partner_index(i, n);
      if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED) continue;
      const double mass = bonds->kernel_mass(i, j, reach);
      if (atom->type[j] == type) own += mass;
      all += mass;
    }
    norms->astore[i][DEPTH] = own == all
        ? 0.0
        : std::max(depth_in[type](own / all), LEAST_DEPTH * bonds->spacing(i));
  }
}

/* ----------------------------------------------------------------------
   A lattice has few directions: its mean of k(e) e e^T is not quite K. The
   tensor in k(e) is adjusted until it is, on the mean of the interior.
------------------------------------------------------------------------- */

template <int D> void FixTMSPHHeat::calibrate(int type, const std::vector<char> &near)
{
  static constexpr int ITERATIONS = 100;
  using Conductivity = DirectionalConductivity<D>;
  Substance &s = substances[type];
  typename Conductivity::Tensor K, used;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) K(a, b) = s.principal[3 * a + b];
  used = K;

  for (int iteration = 0; iteration < ITERATIONS; iteration++) {
    const Conductivity k(used);
    std::vector<double> terms[SYMMETRIC<D>], ones;
    for (int i = 0; i < atom->nlocal; i++) {
      if (atom->type[i] != type || near[i]) continue;
      bool pure = true;
      typename Conductivity::Tensor sum = Conductivity::Tensor::Zero();
      for (int n = 0; n < bonds->count(i) && pure; n++) {
        const int j = bonds->partner_index(i, n);
        pure = j != i && atom->type[j] == type;
        double X[3];
        bonds->reference_vector(i, j, X);
        const typename Conductivity::Vector R(X);
        if (!pure) continue;
        const double weight = bonds->weight(i, j) * correction(i, j, X);
        sum += weight * k(R.normalized()) * R * R.transpose();
      }
      if (!pure) continue;
      sum *= norms->astore[i][NORM] / atom->vfrac[i];
      ones.push_back(1.0);
      for (int a = 0, n = 0; a < D; a++)
        for (int b = a; b < D; b++) terms[n++].push_back(sum(a, b));
    }
    const double count = fixed_point_sum(ones, world);
    if (count == 0.0) break;
    typename Conductivity::Tensor mean;
    for (int a = 0, n = 0; a < D; a++)
      for (int b = a; b < D; b++)
        mean(a, b) = mean(b, a) = fixed_point_sum(terms[n++], world) / count;
    const double error = (K - mean).norm() / K.norm();
    used += K - mean;
    if (error < 1.0e-13) break;
  }
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) s.calibrated[3 * a + b] = used(a, b);
}

/* ---------------------------------------------------------------------- */

template <int D> void FixTMSPHHeat::find_conductances()
{
  const Slices &slices = bonds->layout();
  const int ntypes = atom->ntypes;
  std::vector<double> k(ntypes + 1), most(ntypes + 1);
  std::vector<DirectionalConductivity<D>> directional(ntypes + 1);
  for (int type = 1; type <= ntypes; type++) {
    const Substance &s = substances[type];
    k[type] = tables ? 1.0 : s.conductivity(0.0);
    most[type] = s.conductivity.largest();
    if (!s.orthotropic) continue;
    typename DirectionalConductivity<D>::Tensor K;
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) K(a, b) = s.calibrated[3 * a + b];
    directional[type] = DirectionalConductivity<D>(K);
  }
  conductances.assign(slices.weight.size(), 0.0f);
  sums.assign(atom->nlocal, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    const int itype = atom->type[i];
    for (int n = 0; n < bonds->count(i); n++) {
      if (bonds->bond_state(i, n) != FixTMSPHBond::INTACT) continue;
      const size_t at = slices.at(i / WIDTH, i % WIDTH, n);
      const int j = slices.partner[at], jtype = atom->type[j];
      double ki = k[itype], kj = k[jtype];
      if (substances[itype].orthotropic || substances[jtype].orthotropic) {
        double X[3];
        bonds->reference_vector(i, j, X);
        const auto e = typename DirectionalConductivity<D>::Vector(X).normalized();
        if (substances[itype].orthotropic) ki = directional[itype](e);
        if (substances[jtype].orthotropic) kj = directional[jtype](e);
      }
      double base = (all_norms[i] + all_norms[j]) * bonds->weight(i, j);
      if (corrected(i, j)) {
        double X[3];
        bonds->reference_vector(i, j, X);
        base *= correction(i, j, X);
      }
      const bool across = itype != jtype && !tables;
      conductances[at] = (float) (base * (across ? in_series(ki, all_depths[i], kj, all_depths[j])
                                                 : harmonic_mean(ki, kj)));
      sums[i] += tables ? base * harmonic_mean(most[itype], most[jtype]) : conductances[at];
    }
  }
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixTMSPHHeat::stored(int column) const
{
  std::vector<double> values(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) values[i] = norms->astore[i][column];
  return values;
}

/* ----------------------------------------------------------------------
   false if the following is 1
------------------------------------------------------------------------- */

bool FixTMSPHHeat::corrected(int i, int j) const
{
  return evened || face_row[i] != NONE || face_row[j] != NONE;
}

/* ----------------------------------------------------------------------
   factor to the conductance of a bond with reference vector X from i to j
------------------------------------------------------------------------- */

double FixTMSPHHeat::correction(int i, int j, const double *X) const
{
  if (!corrected(i, j)) return 1.0;
  if (evened) return evening(i, j, X);
  return domain->dimension == 2 ? 0.5 * (boost<2>(i, X) + boost<2>(j, X))
                                : 0.5 * (boost<3>(i, X) + boost<3>(j, X));
}

/* ----------------------------------------------------------------------
   a body on a lattice has none
------------------------------------------------------------------------- */

void FixTMSPHHeat::share_multipliers()
{
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal && !mine; i++)
    for (int a = 0; a < domain->dimension; a++) mine |= norms->astore[i][MULTIPLIER + a] != 0.0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  evened = any != 0;
  for (int a = 0; a < domain->dimension && evened; a++) {
    multipliers[a] = stored(MULTIPLIER + a);
    ghosts.complete(multipliers[a]);
  }
}

/* ----------------------------------------------------------------------
   after an exchange of particles all are found anew; bonds that have gone since
   no longer conduct
------------------------------------------------------------------------- */

void FixTMSPHHeat::follow()
{
  if (version != bonds->layout_version()) {
    version = bonds->layout_version();
    all_norms = stored(NORM);
    ghosts.complete(all_norms);
    all_depths = stored(DEPTH);
    ghosts.complete(all_depths);
    share_multipliers();
    share_layers();
    domain->dimension == 2 ? find_conductances<2>() : find_conductances<3>();
  } else if (removals != bonds->removals())
    drop_conductances();
  removals = bonds->removals();
}

/* ----------------------------------------------------------------------
   the sums stay as bounds: with fewer bonds the stable step is only longer
------------------------------------------------------------------------- */

void FixTMSPHHeat::drop_conductances()
{
  const Slices &slices = bonds->layout();
  for (int i = 0; i < atom->nlocal; i++)
    for (int n = 0; n < bonds->count(i); n++)
      if (bonds->bond_state(i, n) != FixTMSPHBond::INTACT)
        conductances[slices.at(i / WIDTH, i % WIDTH, n)] = 0.0f;
}

/* ----------------------------------------------------------------------
   n.K.n: the flux along n in a field that varies along n only
------------------------------------------------------------------------- */

double FixTMSPHHeat::conductivity(int i, const double *direction) const
{
  const Substance &s = substances[atom->type[i]];
  if (!s.orthotropic) return s.conductivity(atom->temperature[i]);
  double k = 0.0;
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++) k += direction[a] * s.principal[3 * a + b] * direction[b];
  return k;
}
