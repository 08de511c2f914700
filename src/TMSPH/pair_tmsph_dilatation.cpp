/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Averaged dilatation of nearly incompressible materials in pair style tmsph:
   tmsph_dilatation.h has the equations.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "tmsph_dilatation.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// above these Poisson's ratios the stresses are off by more than 5 %, by lambda times errors of
// the dilatation: without averaging, with it, and with it next to another material

static constexpr double MAX_PLAIN = 0.45, MAX_AVERAGED = 0.4999, MAX_COUPLED = 0.499;

/* ----------------------------------------------------------------------
   plane stress needs no averaging: its lambda stays finite. The Almansi law has
   no energy to derive it from.
------------------------------------------------------------------------- */

bool PairTMSPH::averaged(int type) const
{
  if (chosen.dilatation == Dilatation::PLAIN || chosen.plane == Plane::STRESS ||
      !std::holds_alternative<StVenantKirchhoff>(on.law))
    return false;
  return chosen.dilatation == Dilatation::AVERAGED || material(type).poisson > AVERAGED_ABOVE;
}

/* ----------------------------------------------------------------------
   who averages, the same on all processors; and is that enough
------------------------------------------------------------------------- */

void PairTMSPH::init_dilatation()
{
  averaging = coupling = false;
  const int n = atom->ntypes;
  for (int i = 1; i <= n; i++) {
    const double nu = material(i).poisson;
    bool beside_another = false;
    for (int j = 1; j <= n; j++) beside_another = beside_another || coupled(i, j);
    if (!averaged(i)) {
      if (nu > MAX_PLAIN && chosen.plane == Plane::STRAIN)
        error->all(FLERR,
                   "Poisson's ratio {} of type {} is above {}: its stresses lock unless pair_style "
                   "tmsph has 'dilatation auto' or 'averaged', and 'law svk'",
                   nu, i, MAX_PLAIN);
      continue;
    }
    if (nu > MAX_AVERAGED)
      error->all(FLERR,
                 "Poisson's ratio {} of type {} is above {}, the largest with averaged "
                 "dilatation: use that, it is as good as incompressible",
                 nu, i, MAX_AVERAGED);
    if (beside_another && nu > MAX_COUPLED)
      error->all(FLERR,
                 "Poisson's ratio {} of type {}, which is bonded to another type, is above {}: use "
                 "that at most, or 'pair_coeff I J none' where only contact acts between them",
                 nu, i, MAX_COUPLED);
    averaging = true;
    coupling = coupling || beside_another;
  }
  if (coupling) interface_depth = InterfaceDepth(chosen.kernel, domain->dimension, horizon());
}

/* ----------------------------------------------------------------------
   M_ij of all bonds to the own material, rounded once and alike at both ends
------------------------------------------------------------------------- */

void PairTMSPH::lay_out_averaging()
{
  Slices &all = slices();
  if (!averaging) {
    std::vector<float>().swap(all.averaging);
    return;
  }
  const double kappa = bond_fix->interior_kappa();
  all.averaging.assign(all.weight.size(), 0.0f);
  for (int q = 0; q < all.count(); q++)
    for (int l = 0; l < all.valid[q]; l++) {
      const int i = all.particle[q * WIDTH + l];
      if (!averaged(atom->type[i])) continue;
      for (const auto &bond : bond_fix->family(i, FixTMSPHBond::WHOLE))
        if (same_material(atom->type[i], atom->type[bond.j]))
          all.averaging[all.at(q, l, bond.k)] =
              (float) (atom->vfrac[i] / kappa * bond_fix->kernel_mass(i, bond.j, horizon()));
    }
}

/* ----------------------------------------------------------------------
   from the gradients of the present force evaluation: mean dilatations and
   pressures (positive in tension) of the local particles
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::find_pressures()
{
  const int nlocal = atom->nlocal;
  const size_t nall = nlocal + atom->nghost;
  exchanged.resize(nall);
  mean_dilatation.resize(nlocal);
  pressure.resize(nlocal);
  for (int i = 0; i < nlocal; i++) {
    exchanged[i] = 0.0;
    const int type = atom->type[i];
    // without a shape matrix there is no strain, and a thermal one would be spurious
    if (!averaged(type) || *own_constants<D>(i) == 0.0) continue;
    exchanged[i] = trace_of_strain<D>(gradient.data() + (size_t) D * D * i);
    if (on.thermal == ThermalStrain::CONSTITUTIVE) exchanged[i] -= D * thermal_strain(i);
  }
  send(AVERAGE);
  average_sweep<D>(slices(), exchanged.data(), mean_dilatation.data());
  for (int i = 0; i < nlocal; i++)    // 0 for materials that do not average
    exchanged[i] = elastic(i).lambda * mean_dilatation[i];
  send(AVERAGE);
  average_sweep<D>(slices(), exchanged.data(), pressure.data());
}

/* ----------------------------------------------------------------------
   the pressures enter the force rows
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::add_pressures()
{
  for (int i = 0; i < atom->nlocal; i++)
    add_pressure<D>(pressure[i], gradient.data() + (size_t) D * D * i, own_constants<D>(i),
                    force_row.data() + (size_t) i * Rows<D>::FORCE);
}

/* ----------------------------------------------------------------------
   share of the pressures in the stress of local particle i, whose reported
   stress belongs to the gradient H
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::add_pressure_to_stress(int i, const double *H)
{
  const double stretch = on.thermal == ThermalStrain::BOND ? 1.0 + thermal_strain(i) : 1.0;
  add_pressure_stress<D>(pressure[i], H, stretch, stress.data() + (size_t) STRESS_ROW<D> * i);
}

/* ----------------------------------------------------------------------
   lambda/2 thetabar^2 of local particle i, times its volume
------------------------------------------------------------------------- */

double PairTMSPH::dilatation_energy(int i) const
{
  const double mean = mean_dilatation[i];
  return 0.5 * atom->vfrac[i] * elastic(i).lambda * mean * mean;
}

// for pair_tmsph.cpp and the others

template void PairTMSPH::find_pressures<2>();
template void PairTMSPH::find_pressures<3>();
template void PairTMSPH::add_pressures<2>();
template void PairTMSPH::add_pressures<3>();
template void PairTMSPH::add_pressure_to_stress<2>(int, const double *);
template void PairTMSPH::add_pressure_to_stress<3>(int, const double *);
