/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Force evaluation of pair style tmsph. The equations and the loops over
   bonds are in tmsph_sweep.h; here they meet LAMMPS's arrays.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_openings.h"
#include "tmsph_pi.h"
#include "tmsph_stop.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void PairTMSPH::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  if (domain->dimension == 2)
    evaluate<2>();
  else
    evaluate<3>();
}

/* ----------------------------------------------------------------------
   one force evaluation
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::evaluate()
{
  if (prepared.laid_out_anew(*bond_fix)) prepare<D>();
  const bool testing = break_test && break_test->due();

  // bonds that are open leave

  if (openings()) openings()->follow();
  if (testing && opens()) {
    std::vector<int> touched;
    break_test->remove_opened(touched);
    reshape<D>(touched);
  }

  // where the particles are

  the_box.meet_forces();
  rows.move<D>(*this, expands());
  if (on.viscosity) rows.take_velocities<D>(*bond_fix);

  // strains and stresses of particles

  int inverted = -1;
  GradientOutput out;
  out.force_row = rows.force();
  out.inverted = &inverted;
  out.inverted_breaks = testing;
  if (testing) {
    stress.resize((size_t) STRESS_ROW<D> * (atom->nlocal + atom->nghost));
    out.stress = stress.data();
  }
  find_gradients<D>(out, contact || averaging.on() || openings());
  if (inverted >= 0) stop_inverted(lmp, *bond_fix, inverted);

  // breaking; openings in a search for equilibrium

  if (testing)
    test_bonds<D>();
  else if (opens() && update->whichflag == 2)
    openings()->relax<D>(bond_state());

  // forces of bonds, from the rows of both ends

  complete_rows<D>();
  find_forces<D>(viscosity, atom->f[0], 3);
  if (vflag_either) add_virial<D>();

  // forces of debris, energies

  if (break_test) {
    const double repulsion = break_test->repel(vflag_global ? virial : nullptr);
    if (eflag_global) eng_vdwl += repulsion;
  }
  if (eflag_either) add_energy<D>();
}

/* ----------------------------------------------------------------------
   after an exchange of particles: rows, shape matrices, material constants
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::prepare()
{
  rows.lay_out<D>(*this, *bond_fix);
  coupling.lay_out(*bond_fix);
  const double kappa = bond_fix->interior_kappa(), thickness = bond_fix->body_thickness();
  Slices &all = bond_fix->layout();
  all.own.resize((size_t) all.count() * CONSTANTS<D> * LANES);
  for (int q = 0; q < all.count(); q++)
    for (int l = 0; l < LANES; l++)
      update_shape<D>(all, q, l, rows.kinematic(), kappa,
                      averaging.constants(all.particle[q * LANES + l], thickness));
  own_side.lay_out<D>(*bond_fix, *atom, rows.kinematic());
  averaging.lay_out(*bond_fix);
  viscosity.kappa = kappa;
  for (int type = 1; type <= atom->ntypes; type++)
    on.hourglass = on.hourglass || material(type).hourglass > 0.0;
  prepared.see(*bond_fix);
}

/* ----------------------------------------------------------------------
   the gradient sweep, and the pressures that follow from the gradients
   @param keep with gradients of the local particles as output
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::find_gradients(GradientOutput out, bool keep)
{
  if (keep) {
    gradient.resize((size_t) D * D * atom->nlocal);
    out.gradient = gradient.data();
  }
  const Slices &all = bond_fix->layout();
  gradient_sweep<D>(on, all, 0, all.count(), rows.kinematic(), out);
  if (opens())
    openings()->correct<D>({on, all, rows.kinematic(), out.force_row, out.gradient, out.stress});
  if (averaging.on()) averaging.find_pressures<D>(*bond_fix, on.thermal, gradient.data());
}

/* ----------------------------------------------------------------------
   own-side stresses of the local particles, from those over all bonds
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::find_stresses(bool inverted_breaks)
{
  GradientOutput out;
  out.stress = stress.data();
  out.inverted_breaks = inverted_breaks;
  if (averaging.on() || openings()) out.gradient = own_side.start_gradients(gradient);
  own_side.find_stress<D>(on, rows.kinematic(), out);
  if (opens()) openings()->correct_own_side<D>(bond_state());
  if (averaging.on())
    averaging.add_to_stress<D>(on.thermal, out.gradient ? out.gradient : gradient.data(),
                               stress.data());
  pressed.add_stress(*bond_fix, stress.data());
}

/* ----------------------------------------------------------------------
   all bonds are tested on the same stresses and break together
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::test_bonds()
{
  find_stresses<D>(true);
  ghosts.send(stress.data(), STRESS_ROW<D>, STRESS_ROW<D>);
  std::vector<int> touched;
  break_test->break_bonds(stress.data(), touched);
  int broke = !touched.empty(), broke_anywhere = broke;
  if (averaging.on()) MPI_Allreduce(&broke, &broke_anywhere, 1, MPI_INT, MPI_MAX, world);
  if (!broke_anywhere) return;
  std::sort(touched.begin(), touched.end());
  follow<D>(touched);
}

/* ----------------------------------------------------------------------
   what does not depend on the positions of particles that lost a bond
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::reshape(const std::vector<int> &touched)
{
  Slices &all = bond_fix->layout();
  for (int i : touched) {
    update_shape<D>(all, i / LANES, i % LANES, rows.kinematic(), bond_fix->interior_kappa(),
                    averaging.constants(i, bond_fix->body_thickness()));
    own_side.follow<D>(i, *bond_fix, *atom, rows.kinematic());
    bond_fix->update_damage(i);
  }
  pressed.follow(*bond_fix, touched);
  coupling.follow(*bond_fix, touched);
}

/* ----------------------------------------------------------------------
   particles that lost a bond get new shape matrices, gradients and stresses
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::follow(const std::vector<int> &touched)
{
  reshape<D>(touched);
  const Slices &all = bond_fix->layout();
  GradientOutput out;
  out.force_row = rows.force();
  if (contact || averaging.on() || openings()) out.gradient = gradient.data();
  int last_slice = -1;
  for (int i : touched) {
    const int q = i / LANES;
    if (q != last_slice) gradient_sweep<D>(on, all, q, q + 1, rows.kinematic(), out);
    last_slice = q;
  }
  if (opens())
    openings()->correct<D>({on, all, rows.kinematic(), rows.force(), gradient.data(), nullptr});
  if (averaging.on()) averaging.find_pressures<D>(*bond_fix, on.thermal, gradient.data());
}

/* ----------------------------------------------------------------------
   what averaging adds to the force rows; ghosts get them
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::complete_rows()
{
  if (averaging.on()) averaging.add_to_forces<D>(*bond_fix, gradient.data(), rows.force());
  if (coupling.on())
    coupling.find_forces<D>(*bond_fix, on.thermal, rows.kinematic(), gradient.data(), rows.force());
  if (opens()) openings()->finish<D>(bond_state());
  rows.send_forces<D>(Rows<D>::communicated(on));
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::find_forces(const Viscosity &viscous, double *f, int stride)
{
  force_sweep<D>(on, bond_fix->layout(), viscous, rows.kinematic(), rows.force(), f, stride);
  coupling.add_forces<D>(f, stride);
  if (opens()) openings()->add_forces<D>(bond_state(), f, stride, nullptr, nullptr);
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::add_virial()
{
  std::vector<double> virials(vflag_atom ? 6 * (size_t) atom->nlocal : 0);
  double *const each = vflag_atom ? virials.data() : nullptr;
  double *const total = vflag_global ? virial : nullptr;
  virial_sweep<D>(on, bond_fix->layout(), viscosity, rows.kinematic(), rows.force(), each, total);
  coupling.add_virial<D>(rows.kinematic(), each, total);
  if (opens()) openings()->add_forces<D>(bond_state(), nullptr, 0, total, each);
  if (vflag_atom)
    for (int i = 0; i < atom->nlocal; i++)
      for (int k = 0; k < 6; k++) vatom[i][k] += each[6 * (size_t) i + k];
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::add_energy()
{
  std::vector<double> energies(eflag_atom || opens() ? atom->nlocal : 0);
  double *const each = energies.empty() ? nullptr : energies.data();
  double energy = energy_sweep<D>(on, bond_fix->layout(), rows.kinematic(), each);
  if (opens())
    for (const auto &one : openings()->energies()) {
      energy += one.energy - each[one.i];
      each[one.i] = one.energy;
    }
  averaging.add_energy(energy, each);
  coupling.add_energy(energy, each);
  if (eflag_global) eng_vdwl += energy;
  if (eflag_atom)
    for (int i = 0; i < atom->nlocal; i++) eatom[i] += each[i];
}

/* ----------------------------------------------------------------------
   so many particles share the ball of the horizon; the volumes of particles may contain
   a thickness
------------------------------------------------------------------------- */

double PairTMSPH::spacing() const
{
  const int family = bond_fix->family_sizes().second + 1;
  return horizon() *
      (domain->dimension == 2 ? std::sqrt(PI / family) : std::cbrt(4.0 * PI / (3.0 * family)));
}

/* ---------------------------------------------------------------------- */

bool PairTMSPH::opens() const
{
  return openings() && openings()->anywhere();
}

/* ---------------------------------------------------------------------- */

TMSPHBondState PairTMSPH::bond_state()
{
  return {on,           bond_fix->layout(), rows.kinematic(),
          rows.force(), gradient.data(),    stress.data(),
          &own_side};
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::viscous_heat(std::vector<double> &power)
{
  power.assign(atom->nlocal, 0.0);
  if (!on.viscosity) return;
  const Slices &all = bond_fix->layout();
  if (domain->dimension == 2)
    viscous_heat_sweep<2>(on, all, viscosity, rows.kinematic(), rows.force(), power.data());
  else
    viscous_heat_sweep<3>(on, all, viscosity, rows.kinematic(), rows.force(), power.data());
}

/* ---------------------------------------------------------------------- */

TMSPHFields PairTMSPH::fields()
{
  const auto fill = [this](auto dimension) {
    constexpr int D = decltype(dimension)::value;
    if (prepared.laid_out_anew(*bond_fix)) prepare<D>();
    if (openings()) openings()->follow();
    rows.move<D>(*this, expands());
    stress.resize((size_t) STRESS_ROW<D> * (atom->nlocal + atom->nghost));
    GradientOutput out;
    out.stress = stress.data();
    find_gradients<D>(out, true);
    find_stresses<D>(false);
  };
  if (domain->dimension == 2)
    fill(std::integral_constant<int, 2>());
  else
    fill(std::integral_constant<int, 3>());
  return {stress.data(), gradient.data()};
}

// for pair_tmsph_timestep.cpp

template void PairTMSPH::prepare<2>();
template void PairTMSPH::prepare<3>();
template void PairTMSPH::find_gradients<2>(GradientOutput, bool);
template void PairTMSPH::find_gradients<3>(GradientOutput, bool);
template void PairTMSPH::complete_rows<2>();
template void PairTMSPH::complete_rows<3>();
template void PairTMSPH::find_forces<2>(const Viscosity &, double *, int);
template void PairTMSPH::find_forces<3>(const Viscosity &, double *, int);
