/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The stable time step of the present state of pair style tmsph.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_random.h"
#include "tmsph_stable_step.h"

using namespace LAMMPS_NS;
using namespace TMSPH;

// longest trial displacement in horizons: far below strains that change the stiffness, far above
// round-off of the forces

static constexpr double TRIAL = 1.0e-6;

static constexpr int SEED = 7919;    // of the trial displacements: any number

/* ----------------------------------------------------------------------
   random multiples of the bonds, which turn along with the body; partners of broken ones may be out
   of reach, on how many processors decides
------------------------------------------------------------------------- */

static std::vector<double> trial_displacements(const FixTMSPHBond &bonds, const Atom &atom, int D)
{
  std::vector<double> trial(D * (size_t) atom.nlocal);
  for (int i = 0; i < atom.nlocal; i++)
    for (int n = 0; n < bonds.count(i); n++) {
      if (bonds.bond_state(i, n) != FixTMSPHBond::INTACT) continue;
      double X[3];
      bonds.reference_vector(i, bonds.partner_index(i, n), X);
      const double part = uniform_random(atom.tag[i], SEED, bonds.partner_tag(i, n)) - 0.5;
      for (int k = 0; k < D; k++) trial[D * (size_t) i + k] += part * X[k];
    }
  return trial;
}

/* ---------------------------------------------------------------------- */

double PairTMSPH::stable_timestep()
{
  return domain->dimension == 2 ? estimate_timestep<2>() : estimate_timestep<3>();
}

/* ----------------------------------------------------------------------
   the velocities that the last step took may be wanted yet, as the work of viscosity
------------------------------------------------------------------------- */

template <int D> double PairTMSPH::estimate_timestep()
{
  if (prepared.laid_out_anew(*bond_fix)) prepare<D>();
  const std::vector<double> velocities = rows.velocities<D>();
  Viscosity linear = viscosity;
  linear.alpha2 = 0.0;
  const auto forces = [&](const std::vector<double> &trial, double push, double dt,
                          std::vector<double> &f) {
    rows.move<D>(*this, expands());
    rows.try_move<D>(trial, push, 2.0 / dt);
    GradientOutput out;
    out.force_row = rows.force();
    find_gradients<D>(out, averaging.on());
    complete_rows<D>();
    f.assign(trial.size(), 0.0);
    find_forces<D>(linear, f.data(), D);
  };
  const double dt =
      stable_step(trial_displacements(*bond_fix, *atom, D), D, atom->rmass, TRIAL * horizon(),
                  horizon() / wave_speed(material(1)), world, forces);
  if (on.viscosity) rows.put_velocities<D>(velocities);
  rows.move<D>(*this, expands());
  return dt;
}
