/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Force evaluation of pair style tmsph. The equations and the loops over
   bonds are in tmsph_sweep.h; here they meet LAMMPS's arrays.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "domain.h"
#include "fix_tmsph_bond.h"
#include "tmsph_pi.h"
#include "update.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// A shape matrix whose smallest eigenvalue is a smaller part than this of those in the interior of
// the intact body cannot tell strains apart. Bonds add positive semidefinite terms, so that this
// eigenvalue only falls as they break: a particle that has lost its stress never gets it back in a
// state that it reached without. By its own largest eigenvalue it would, when a heavy bond goes.

static constexpr double SINGULAR = 0.02;

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
   one force evaluation; with a break test, bonds break between the sweeps
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::evaluate()
{
  const int nlocal = atom->nlocal;
  if (prepared_version != bond_fix->layout_version()) prepare<D>();
  the_box.meet_forces();
  update_kinematics<D>();
  if (on.viscosity) update_velocities<D>();

  const bool testing = break_test && break_test->due();
  if (testing) stress.resize((size_t) STRESS_ROW<D> * (nlocal + atom->nghost));
  int inverted = -1;
  GradientOutput out;
  out.force_row = force_row.data();
  out.inverted = &inverted;
  if (testing) {
    out.stress = stress.data();
    out.inverted_breaks = true;
  }
  if (contact || averaging) {
    gradient.resize((size_t) D * D * nlocal);
    out.gradient = gradient.data();
  }
  gradient_sweep<D>(on, slices(), 0, slices().count(), kinematic.data(), out);
  if (inverted >= 0) stop_inverted(inverted);
  if (averaging) find_pressures<D>();
  if (testing) test_bonds<D>();
  if (averaging) complete_rows<D>();
  send(FORCE_ROWS);

  bond_forces<D>(viscosity, atom->f[0], 3);
  if (vflag_either) {
    if (vflag_atom) rows.assign(6 * (size_t) nlocal, 0.0);
    double *const each = vflag_atom ? rows.data() : nullptr;
    double *const total = vflag_global ? virial : nullptr;
    virial_sweep<D>(on, slices(), viscosity, kinematic.data(), force_row.data(), each, total);
    if (coupling) add_coupling_virial<D>(each, total);
    if (vflag_atom)
      for (int i = 0; i < nlocal; i++)
        for (int k = 0; k < 6; k++) vatom[i][k] += rows[6 * (size_t) i + k];
  }
  if (break_test) {
    const double repulsion = break_test->repel(vflag_global ? virial : nullptr);
    if (eflag_global) eng_vdwl += repulsion;
  }

  if (eflag_either) {
    if (eflag_atom) rows.resize(nlocal);
    double energy =
        energy_sweep<D>(on, slices(), kinematic.data(), eflag_atom ? rows.data() : nullptr);
    for (int i = 0; averaging && i < nlocal; i++) {
      energy += dilatation_energy(i);
      if (eflag_atom) rows[i] += dilatation_energy(i);
    }
    for (const auto &one : crossing) {
      energy += one.energy;
      if (eflag_atom) rows[one.i] += one.energy;
    }
    if (eflag_global) eng_vdwl += energy;
    if (eflag_atom)
      for (int i = 0; i < nlocal; i++) eatom[i] += rows[i];
  }
}

/* ----------------------------------------------------------------------
   what averaging adds to the force rows
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::complete_rows()
{
  add_pressures<D>();
  if (coupling) couple_materials<D>();
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::bond_forces(const Viscosity &viscous, double *f, int stride)
{
  force_sweep<D>(on, slices(), viscous, kinematic.data(), force_row.data(), f, stride);
  for (const auto &one : crossing)
    for (int k = 0; k < D; k++) f[(size_t) stride * one.i + k] += one.force[k];
}

/* ----------------------------------------------------------------------
   after an exchange of particles: rows, shape matrices, material constants
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::prepare()
{
  using R = Rows<D>;
  const int nall = atom->nlocal + atom->nghost;
  kinematic.assign((size_t) nall * R::KINEMATIC, 0.0);
  force_row.assign((size_t) nall * R::FORCE, 0.0);
  for (int i = 0; i < nall; i++) {
    const double density = atom->rmass[i] / atom->vfrac[i];
    double *row = kinematic.data() + (size_t) i * R::KINEMATIC;
    for (int k = 0; k < D; k++) row[R::X + k] = bond_fix->reference(i)[k];
    row[R::YOUNG] = elastic(i).young;
    double *end = D == 2 ? row : force_row.data() + (size_t) i * R::FORCE;
    end[R::SPEED] = std::sqrt(elastic(i).wave_modulus / density);
    end[R::DENSITY] = density;
  }
  lay_out_coupling<D>();
  build_own_side<D>();
  Slices &all = slices();
  all.own.resize((size_t) all.count() * CONSTANTS<D> * WIDTH);
  for (int q = 0; q < all.count(); q++)
    for (int l = 0; l < WIDTH; l++) update_shape<D>(all, q, l);
  lay_out_averaging();
  viscosity.kappa = bond_fix->interior_kappa();
  prepared_version = bond_fix->layout_version();
}

/* ----------------------------------------------------------------------
   constants of the particle in lane l of slice q from its remaining bonds:
   Kbar^-1 V lambda mu chi; Kbar^-1 and chi are 0 where Kbar is singular
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::update_shape(Slices &bonds, int q, int l)
{
  using R = Rows<D>;
  const int i = bonds.particle[q * WIDTH + l];
  const double *mine = kinematic.data() + (size_t) i * R::KINEMATIC + R::X;
  Eigen::Matrix<double, D, D> K = Eigen::Matrix<double, D, D>::Zero();
  for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
    const size_t at = (size_t) b * WIDTH + l;
    const double *his = kinematic.data() + (size_t) bonds.partner[at] * R::KINEMATIC + R::X;
    Eigen::Matrix<double, D, 1> X;
    for (int k = 0; k < D; k++) X[k] = his[k] - mine[k];
    K += (double) bonds.weight[at] * X * X.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> eigen;
  eigen.computeDirect(K, Eigen::EigenvaluesOnly);
  const auto &value = eigen.eigenvalues();
  const bool singular = !(value[0] > SINGULAR * atom->vfrac[i] * bond_fix->interior_kappa());
  const Elastic &m = elastic(i);
  double *own = bonds.own.data() + (size_t) q * CONSTANTS<D> * WIDTH + l;
  Eigen::Matrix<double, D, D> inverse = Eigen::Matrix<double, D, D>::Zero();
  if (!singular) inverse = K.inverse();
  int entry = 0;
  for (int a = 0; a < D; a++)
    for (int b = a; b < D; b++) own[WIDTH * entry++] = inverse(a, b);
  own[WIDTH * entry++] = atom->vfrac[i];
  own[WIDTH * entry++] = averaged(atom->type[i]) ? 0.0 : m.lambda;    // see find_pressures()
  own[WIDTH * entry++] = m.shear;
  own[WIDTH * entry++] = singular ? 0.0 : chosen.hourglass * m.young / bond_fix->body_thickness();
}

/* ----------------------------------------------------------------------
   displacements, and thermal strains where there are any, of all particles
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::update_kinematics()
{
  using R = Rows<D>;
  double **x = atom->x;
  const int nall = atom->nlocal + atom->nghost;
  for (int i = 0; i < nall; i++) {
    double *row = kinematic.data() + (size_t) i * R::KINEMATIC;
    for (int k = 0; k < D; k++) row[R::U + k] = x[i][k] - row[R::X + k];
  }
  if (on.thermal == ThermalStrain::NONE) return;
  bool possible = true;
  for (int i = 0; i < nall; i++) {
    const double push = thermal_push(i);
    kinematic[(size_t) i * R::KINEMATIC + R::THERMAL] = push;
    possible &= push > -elastic(i).young;    // false for NaN
  }
  if (!possible) stop_thermal();
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::update_velocities()
{
  using R = Rows<D>;
  static constexpr double REST[3] = {0.0, 0.0, 0.0};
  const bool minimizing = update->whichflag == 2;    // looks for equilibrium: nothing moves
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = minimizing ? REST
        : update->setupflag      ? bond_fix->setup_velocity(i)
                                 : atom->v[i];
    std::copy_n(v, D, force_row.data() + (size_t) i * R::FORCE + R::V);
  }
  stepped = !minimizing;
  box_moves = stepped && the_box.carries_velocities();
}

/* ---------------------------------------------------------------------- */

const double *PairTMSPH::step_velocity(int i) const
{
  if (!stepped) return nullptr;
  return force_row.data() + (domain->dimension == 2 ? (size_t) i * Rows<2>::FORCE + Rows<2>::V
                                                    : (size_t) i * Rows<3>::FORCE + Rows<3>::V);
}

/* ----------------------------------------------------------------------
   all bonds are tested on the same stresses and break together; then the
   particles that lost one get new shape matrices, gradients and stresses
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::test_bonds()
{
  own_side_stress<D>(true);
  add_surface_stress();
  send(STRESS);
  touched.clear();
  break_test->break_bonds(stress.data(), touched);
  int broke = !touched.empty(), broke_anywhere = broke;
  if (averaging) MPI_Allreduce(&broke, &broke_anywhere, 1, MPI_INT, MPI_MAX, world);
  if (!broke_anywhere) return;
  std::sort(touched.begin(), touched.end());
  drop_near(touched);
  GradientOutput out;
  out.force_row = force_row.data();
  if (contact || averaging) out.gradient = gradient.data();
  int last_slice = -1;
  for (int i : touched) {
    update_shape<D>(slices(), i / WIDTH, i % WIDTH);
    if (own_side_lane[i] >= 0) fill_own_side<D>(i);
    bond_fix->update_damage(i);
  }
  for (int i : touched) {
    const int q = i / WIDTH;
    if (q != last_slice) gradient_sweep<D>(on, slices(), q, q + 1, kinematic.data(), out);
    last_slice = q;
  }
  for (auto &one : crossing)
    if (std::binary_search(touched.begin(), touched.end(), one.i)) update_crossing<D>(one);
  if (averaging) find_pressures<D>();
}

/* ----------------------------------------------------------------------
   so many particles share the ball of the horizon; the volumes of particles may contain
   a thickness
------------------------------------------------------------------------- */

double PairTMSPH::spacing() const
{
  const int family = bond_fix->family_sizes().second + 1;
  return horizon() * (domain->dimension == 2 ? std::sqrt(PI / family)
                                          : std::cbrt(4.0 * PI / (3.0 * family)));
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::viscous_heat(std::vector<double> &power)
{
  power.assign(atom->nlocal, 0.0);
  if (!on.viscosity) return;
  if (domain->dimension == 2)
    viscous_heat_sweep<2>(on, slices(), viscosity, kinematic.data(), force_row.data(),
                          power.data());
  else
    viscous_heat_sweep<3>(on, slices(), viscosity, kinematic.data(), force_row.data(),
                          power.data());
}

/* ---------------------------------------------------------------------- */

PairTMSPH::Fields PairTMSPH::fields()
{
  const auto fill = [this](auto dimension) {
    constexpr int D = decltype(dimension)::value;
    if (prepared_version != bond_fix->layout_version()) prepare<D>();
    update_kinematics<D>();
    stress.resize((size_t) STRESS_ROW<D> * (atom->nlocal + atom->nghost));
    gradient.resize((size_t) D * D * atom->nlocal);
    GradientOutput out;
    out.stress = stress.data();
    out.gradient = gradient.data();
    gradient_sweep<D>(on, slices(), 0, slices().count(), kinematic.data(), out);
    if (averaging) find_pressures<D>();
    own_side_stress<D>(false);
    add_surface_stress();
  };
  if (domain->dimension == 2)
    fill(std::integral_constant<int, 2>());
  else
    fill(std::integral_constant<int, 3>());
  return {stress.data(), gradient.data()};
}

/* ----------------------------------------------------------------------
   under uniform stress in the interior f_ij = 2 W_ij/kappa sigma X_ij, and half of f u' is
   the energy; summed over all bonds this is the strain energy of the body
------------------------------------------------------------------------- */

double PairTMSPH::bond_energy(int i, int k, const double *stress) const
{
  const int D = domain->dimension;
  const int j = bond_fix->partner_index(i, k);
  double X[3], work = 0.0;
  bond_fix->reference_vector(i, j, X);
  const int row[3][3] = {{0, D, D + 1}, {D, 1, D + 2}, {D + 1, D + 2, 2}};
  const double theta = (thermal_push(i) + thermal_push(j)) / (elastic(i).young + elastic(j).young);
  for (int a = 0; a < D; a++) {
    const double u = (atom->x[j][a] - bond_fix->reference(j)[a]) -
        (atom->x[i][a] - bond_fix->reference(i)[a]) - theta * X[a];
    for (int b = 0; b < D; b++) work += u * stress[row[a][b]] * X[b];
  }
  return bond_fix->weight(i, j) * work / bond_fix->interior_kappa();
}

/* ---------------------------------------------------------------------- */

int PairTMSPH::stress_size() const
{
  return domain->dimension == 2 ? STRESS_ROW<2> : STRESS_ROW<3>;
}

/* ---------------------------------------------------------------------- */

Slices &PairTMSPH::slices()
{
  return bond_fix->layout();
}

/* ---------------------------------------------------------------------- */

double PairTMSPH::memory_usage()
{
  const size_t doubles = kinematic.capacity() + force_row.capacity() + stress.capacity() +
      gradient.capacity() + rows.capacity() + exchanged.capacity() + mean_dilatation.capacity() +
      pressure.capacity() + coupling_row.capacity() + surfaces.rows.capacity();
  return Pair::memory_usage() + doubles * sizeof(double) + own_side.bytes() +
      own_side_lane.capacity() * sizeof(int) + surfaces.near.capacity() * sizeof(Near) +
      surfaces.spans.capacity() * sizeof(Span) + surfaces.across.capacity() * sizeof(Across);
}

// for pair_tmsph_own_side.cpp

template void PairTMSPH::complete_rows<2>();
template void PairTMSPH::complete_rows<3>();
template void PairTMSPH::bond_forces<2>(const Viscosity &, double *, int);
template void PairTMSPH::bond_forces<3>(const Viscosity &, double *, int);
template void PairTMSPH::update_shape<2>(Slices &, int, int);
template void PairTMSPH::update_shape<3>(Slices &, int, int);
