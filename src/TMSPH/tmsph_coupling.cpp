/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Forces across the interfaces of nearly incompressible materials.
------------------------------------------------------------------------- */

#include "tmsph_coupling.h"

#include "domain.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

// a particle is no nearer to the interface than this, in spacings: two ends at 0 would have no
// mean. Those next to an interface of a lattice are at 0.5; 0.01 does the same for inclusions in
// unittest/verification/test_incompressible.py

static constexpr double LEAST_DEPTH = 0.05;

/* ---------------------------------------------------------------------- */

void TMSPHCoupling::init()
{
  const int d = domain->dimension;
  if (on()) depth_of = InterfaceDepth(materials.kernel_of_bonds(), d, materials.horizon());
  rows.set_columns(d * d + 1);
}

/* ---------------------------------------------------------------------- */

int TMSPHCoupling::doubles_per_ghost() const
{
  return on() ? rows.columns() : 0;
}

/* ---------------------------------------------------------------------- */

void TMSPHCoupling::lay_out(FixTMSPHBond &bonds)
{
  crossing.clear();
  if (!on()) return;
  Slices &layout = bonds.layout();
  for (int i = 0; i < atom->nlocal; i++) {
    Crossing one;
    one.i = i;
    for (const auto &bond : bonds.family(i, FixTMSPHBond::FORMED)) {
      if (!averaging.coupled(atom->type[i], atom->type[bond.j])) continue;
      layout.weight[layout.at(i, bond.k)] = 0.0f;
      one.bonds.push_back({bond.k, bond.j, 0.0, {}});
    }
    if (!one.bonds.empty()) crossing.push_back(std::move(one));
  }
  for (auto &one : crossing) update(bonds, one);
}

/* ---------------------------------------------------------------------- */

void TMSPHCoupling::follow(const FixTMSPHBond &bonds, const std::vector<int> &touched)
{
  for (auto &one : crossing)
    if (std::binary_search(touched.begin(), touched.end(), one.i)) update(bonds, one);
}

/* ----------------------------------------------------------------------
   stiffness of the bonds across that are intact, and the depth under the interface
------------------------------------------------------------------------- */

void TMSPHCoupling::update(const FixTMSPHBond &bonds, Crossing &one) const
{
  const double horizon = materials.horizon();
  const int i = one.i, type = atom->type[i];
  double own = bonds.kernel_mass(i, i, horizon), whole = own;
  for (const auto &bond : bonds.family(i, FixTMSPHBond::WHOLE)) {
    const double mass = bonds.kernel_mass(i, bond.j, horizon);
    const bool same = materials.same_material(type, atom->type[bond.j]);
    if (same) own += mass;
    if (same || averaging.coupled(type, atom->type[bond.j])) whole += mass;
  }
  one.depth = std::max(depth_of(own / whole), LEAST_DEPTH * bonds.spacing(i));
  for (auto &bond : one.bonds)
    bond.stiffness = bonds.bond_state(i, bond.k) != FixTMSPHBond::INTACT
        ? 0.0
        : coupling_stiffness(materials.material(type).young,
                             materials.material(atom->type[bond.j]).young) *
            (double) bonds.weight(i, bond.j) / bonds.body_thickness();
}

/* ----------------------------------------------------------------------
   whole displacement gradients of both ends and their depths
------------------------------------------------------------------------- */

template <int D>
void TMSPHCoupling::fill_rows(const FixTMSPHBond &bonds, bool bond_mode, const double *gradients)
{
  rows.fill(atom->nlocal + atom->nghost, 0.0);
  for (const auto &one : crossing) {
    const double a = bond_mode ? materials.thermal_strain(one.i) : 0.0;
    const double *H = gradients + (size_t) D * D * one.i;
    double *row = rows[one.i];
    if (*bonds.layout().constants<D>(one.i) == 0.0) continue;
    for (int k = 0; k < D * D; k++) row[k] = (1.0 + a) * H[k] + (k % (D + 1) == 0 ? a : 0.0);
    row[D * D] = one.depth;
  }
  ghosts.send(rows, 0, rows.columns());
}

/* ----------------------------------------------------------------------
   @return what its bonds put into the force row, before its own shape matrix
------------------------------------------------------------------------- */

template <int D>
Matrix<D, double> TMSPHCoupling::find_force(Crossing &one, const double *kinematic) const
{
  using R = Rows<D>;
  const double *mine = rows[one.i];
  const double *here = kinematic + (size_t) R::KINEMATIC * one.i;
  Matrix<D, double> moment{};
  one.force.fill(0.0);
  one.energy = 0.0;
  for (auto &bond : one.bonds) {
    const double *his = rows[bond.j];
    const double *there = kinematic + (size_t) R::KINEMATIC * bond.j;
    const double depth = mine[D * D] + his[D * D];
    if (bond.stiffness == 0.0 || depth == 0.0) continue;
    const double si = mine[D * D] / depth, sj = his[D * D] / depth;
    double X[D], square = 0.0;
    for (int k = 0; k < D; k++) X[k] = there[R::X + k] - here[R::X + k];
    for (int a = 0; a < D; a++) {
      double r = there[R::U + a] - here[R::U + a];
      for (int b = 0; b < D; b++) r -= (si * mine[D * a + b] + sj * his[D * a + b]) * X[b];
      const double t = bond.stiffness * r;
      bond.force[a] = t;
      one.force[a] += t;
      square += r * r;
      for (int b = 0; b < D; b++) moment[a][b] += si * t * X[b];
    }
    one.energy += 0.25 * bond.stiffness * square;
  }
  return moment;
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHCoupling::find_forces(const FixTMSPHBond &bonds, ThermalStrain thermal,
                                const double *kinematic, const double *gradients, double *force_row)
{
  using R = Rows<D>;
  const bool bond_mode = thermal == ThermalStrain::BOND;
  fill_rows<D>(bonds, bond_mode, gradients);
  for (auto &one : crossing) {
    const Matrix<D, double> moment = find_force<D>(one, kinematic);
    const double *own = bonds.layout().constants<D>(one.i);
    const double stretch = bond_mode ? 1.0 + materials.thermal_strain(one.i) : 1.0;
    const Matrix<D, double> B = product(moment, shape_inverse<D>(own));
    double *row = force_row + (size_t) one.i * R::FORCE + R::B;
    for (int k = 0; k < D * D; k++) row[k] -= stretch * B[k / D][k % D];
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHCoupling::add_forces(double *f, int stride) const
{
  for (const auto &one : crossing)
    for (int k = 0; k < D; k++) f[(size_t) stride * one.i + k] += one.force[k];
}

/* ---------------------------------------------------------------------- */

void TMSPHCoupling::add_energy(double &total, double *each) const
{
  for (const auto &one : crossing) {
    total += one.energy;
    if (each) each[one.i] += one.energy;
  }
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHCoupling::add_virial(const double *kinematic, double *each, double *total) const
{
  using R = Rows<D>;
  static constexpr int PLACE[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  for (const auto &one : crossing)
    for (const auto &bond : one.bonds) {
      if (bond.stiffness == 0.0) continue;
      const double *here = kinematic + (size_t) R::KINEMATIC * one.i;
      const double *there = kinematic + (size_t) R::KINEMATIC * bond.j;
      for (int a = 0; a < D; a++)
        for (int b = a; b < D; b++) {
          const auto x = [&](int k) {
            return there[R::X + k] - here[R::X + k] + (there[R::U + k] - here[R::U + k]);
          };
          const double v = -0.25 * (x(a) * bond.force[b] + x(b) * bond.force[a]);
          if (each) each[6 * (size_t) one.i + PLACE[a][b]] += v;
          if (total) total[PLACE[a][b]] += v;
        }
    }
}

namespace LAMMPS_NS {
template void TMSPHCoupling::find_forces<2>(const FixTMSPHBond &, ThermalStrain, const double *,
                                            const double *, double *);
template void TMSPHCoupling::find_forces<3>(const FixTMSPHBond &, ThermalStrain, const double *,
                                            const double *, double *);
template void TMSPHCoupling::add_forces<2>(double *, int) const;
template void TMSPHCoupling::add_forces<3>(double *, int) const;
template void TMSPHCoupling::add_virial<2>(const double *, double *, double *) const;
template void TMSPHCoupling::add_virial<3>(const double *, double *, double *) const;
}    // namespace LAMMPS_NS
