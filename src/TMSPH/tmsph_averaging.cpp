/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Averaged dilatation of nearly incompressible materials: who averages, and the
   pressures. tmsph_dilatation.h has the equations.
------------------------------------------------------------------------- */

#include "tmsph_averaging.h"

#include "error.h"
#include "tmsph_dilatation.h"

using namespace LAMMPS_NS;
using namespace TMSPH;

// above these Poisson's ratios the stresses are off by more than 5 %, by lambda times errors of
// the dilatation: without averaging, with it, and with it next to another material
// (doc/report/incompressible.md)

static constexpr double MAX_PLAIN = 0.45, MAX_AVERAGED = 0.4999, MAX_COUPLED = 0.499;

/* ----------------------------------------------------------------------
   plane stress needs no averaging: its lambda stays finite. The Almansi law has
   no energy to derive it from.
------------------------------------------------------------------------- */

bool TMSPHAveraging::averages(int type) const
{
  const TMSPHSettings &chosen = materials.words();
  if (chosen.dilatation == Dilatation::PLAIN || chosen.plane == Plane::STRESS ||
      !std::holds_alternative<StVenantKirchhoff>(chosen.law))
    return false;
  return chosen.dilatation == Dilatation::AVERAGED ||
      materials.material(type).poisson > AVERAGED_ABOVE;
}

/* ---------------------------------------------------------------------- */

bool TMSPHAveraging::coupled(int itype, int jtype) const
{
  return !materials.same_material(itype, jtype) && materials.bonded(itype, jtype) &&
      (averages(itype) || averages(jtype));
}

/* ---------------------------------------------------------------------- */

void TMSPHAveraging::init()
{
  averaging = coupling = false;
  const int n = atom->ntypes;
  for (int i = 1; i <= n; i++) {
    const double nu = materials.material(i).poisson;
    bool beside_another = false;
    for (int j = 1; j <= n; j++) beside_another = beside_another || coupled(i, j);
    if (!averages(i)) {
      if (nu > MAX_PLAIN && materials.words().plane == Plane::STRAIN)
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
}

/* ---------------------------------------------------------------------- */

ParticleConstants TMSPHAveraging::constants(int i, double thickness) const
{
  const Elastic &m = materials.elastic(i);
  return {atom->vfrac[i], averages(atom->type[i]) ? 0.0 : m.lambda, m.shear,
          materials.material(atom->type[i]).hourglass * m.young / thickness};
}

/* ----------------------------------------------------------------------
   M_ij of all bonds to the own material, rounded once and alike at both ends
------------------------------------------------------------------------- */

void TMSPHAveraging::lay_out(FixTMSPHBond &bonds) const
{
  Slices &all = bonds.layout();
  if (!averaging) {
    std::vector<float>().swap(all.averaging);
    return;
  }
  const double kappa = bonds.interior_kappa();
  all.averaging.assign(all.weight.size(), 0.0f);
  for (int q = 0; q < all.count(); q++)
    for (int l = 0; l < all.valid[q]; l++) {
      const int i = all.particle[q * LANES + l];
      if (!averages(atom->type[i])) continue;
      for (const auto &bond : bonds.family(i, FixTMSPHBond::WHOLE))
        if (materials.same_material(atom->type[i], atom->type[bond.j]))
          all.averaging[all.at(q, l, bond.k)] =
              (float) (atom->vfrac[i] / kappa * bonds.kernel_mass(i, bond.j, materials.horizon()));
    }
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHAveraging::find_pressures(const FixTMSPHBond &bonds, ThermalStrain thermal,
                                    const double *gradients)
{
  const int nlocal = atom->nlocal;
  const Slices &all = bonds.layout();
  exchanged.resize((size_t) nlocal + atom->nghost);
  mean_dilatation.resize(nlocal);
  pressure.resize(nlocal);
  for (int i = 0; i < nlocal; i++) {
    exchanged[i] = 0.0;
    const int type = atom->type[i];
    // without a shape matrix there is no strain, and a thermal one would be spurious
    if (!averages(type) || *all.constants<D>(i) == 0.0) continue;
    exchanged[i] = trace_of_strain<D>(gradients + (size_t) D * D * i);
    if (thermal == ThermalStrain::CONSTITUTIVE) exchanged[i] -= D * materials.thermal_strain(i);
  }
  ghosts.send(exchanged.data(), 1, 1);
  average_sweep<D>(all, exchanged.data(), mean_dilatation.data());
  for (int i = 0; i < nlocal; i++)    // 0 for materials that do not average
    exchanged[i] = materials.elastic(i).lambda * mean_dilatation[i];
  ghosts.send(exchanged.data(), 1, 1);
  average_sweep<D>(all, exchanged.data(), pressure.data());
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHAveraging::add_to_forces(const FixTMSPHBond &bonds, const double *gradients,
                                   double *force_row) const
{
  for (int i = 0; i < atom->nlocal; i++)
    add_pressure<D>(pressure[i], gradients + (size_t) D * D * i, bonds.layout().constants<D>(i),
                    force_row + (size_t) i * Rows<D>::FORCE);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHAveraging::add_to_stress(ThermalStrain thermal, const double *gradients,
                                   double *stress) const
{
  for (int i = 0; i < atom->nlocal; i++) {
    const double stretch = thermal == ThermalStrain::BOND ? 1.0 + materials.thermal_strain(i) : 1.0;
    add_pressure_stress<D>(pressure[i], gradients + (size_t) D * D * i, stretch,
                           stress + (size_t) STRESS_ROW<D> * i);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHAveraging::add_energy(double &total, double *each) const
{
  for (int i = 0; averaging && i < atom->nlocal; i++) {
    const double mean = mean_dilatation[i];
    const double energy = 0.5 * atom->vfrac[i] * materials.elastic(i).lambda * mean * mean;
    total += energy;
    if (each) each[i] += energy;
  }
}

namespace LAMMPS_NS {
template void TMSPHAveraging::find_pressures<2>(const FixTMSPHBond &, ThermalStrain,
                                                const double *);
template void TMSPHAveraging::find_pressures<3>(const FixTMSPHBond &, ThermalStrain,
                                                const double *);
template void TMSPHAveraging::add_to_forces<2>(const FixTMSPHBond &, const double *,
                                               double *) const;
template void TMSPHAveraging::add_to_forces<3>(const FixTMSPHBond &, const double *,
                                               double *) const;
template void TMSPHAveraging::add_to_stress<2>(ThermalStrain, const double *, double *) const;
template void TMSPHAveraging::add_to_stress<3>(ThermalStrain, const double *, double *) const;
}    // namespace LAMMPS_NS
