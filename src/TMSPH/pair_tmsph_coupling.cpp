/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Interfaces of nearly incompressible materials in pair style tmsph: see
   tmsph_interface.h. A fit across such an interface would mix the strains of
   both sides, and lambda times its error would be many times the stress.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "fix_tmsph_bond.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// a particle is no nearer to the interface than this, in spacings

static constexpr double LEAST_DEPTH = 0.05;

/* ---------------------------------------------------------------------- */

bool PairTMSPH::coupled(int itype, int jtype) const
{
  return !same_material(itype, jtype) && bonded(itype, jtype) &&
      (averaged(itype) || averaged(jtype));
}

/* ----------------------------------------------------------------------
   local particles with bonds across, which leave the sweeps
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::lay_out_coupling()
{
  crossing.clear();
  if (!coupling) return;
  Slices &all = slices();
  for (int i = 0; i < atom->nlocal; i++) {
    Crossing one;
    one.i = i;
    for (const auto &bond : bond_fix->family(i, FixTMSPHBond::FORMED)) {
      if (!coupled(atom->type[i], atom->type[bond.j])) continue;
      all.weight[all.at(i / WIDTH, i % WIDTH, bond.k)] = 0.0f;
      one.bonds.push_back({bond.k, bond.j, 0.0, {}});
    }
    if (!one.bonds.empty()) crossing.push_back(std::move(one));
  }
  for (auto &one : crossing) update_crossing<D>(one);
}

/* ----------------------------------------------------------------------
   stiffness of the bonds across that are intact, and the depth under the interface
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::update_crossing(Crossing &one)
{
  const int i = one.i, type = atom->type[i];
  double own = bond_fix->kernel_mass(i, i, horizon()), all = own;
  for (const auto &bond : bond_fix->family(i, FixTMSPHBond::WHOLE)) {
    const double mass = bond_fix->kernel_mass(i, bond.j, horizon());
    const bool same = same_material(type, atom->type[bond.j]);
    if (same) own += mass;
    if (same || coupled(type, atom->type[bond.j])) all += mass;
  }
  one.depth = std::max(interface_depth(own / all), LEAST_DEPTH * bond_fix->spacing(i));
  for (auto &bond : one.bonds)
    bond.stiffness = bond_fix->bond_state(i, bond.k) != FixTMSPHBond::INTACT
        ? 0.0
        : coupling_stiffness(material(type).young, material(atom->type[bond.j]).young) *
            (double) bond_fix->weight(i, bond.j) / bond_fix->body_thickness();
}

/* ----------------------------------------------------------------------
   after the gradient sweep: forces of the bonds across, and what they put into
   the force rows through the gradients of both sides
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::couple_materials()
{
  using R = Rows<D>;
  constexpr int N = D * D + 1;    // G and the depth; 0: no gradient
  const size_t nall = atom->nlocal + atom->nghost;
  const bool bond_mode = on.thermal == ThermalStrain::BOND;
  coupling_row.assign(nall * N, 0.0);
  for (const auto &one : crossing) {
    const double a = bond_mode ? thermal_strain(one.i) : 0.0;
    const double *H = gradient.data() + (size_t) D * D * one.i;
    double *row = coupling_row.data() + (size_t) N * one.i;
    if (*own_constants<D>(one.i) == 0.0) continue;
    for (int k = 0; k < D * D; k++) row[k] = (1.0 + a) * H[k] + (k % (D + 1) == 0 ? a : 0.0);
    row[D * D] = one.depth;
  }
  send(COUPLING);
  for (auto &one : crossing) {
    const int i = one.i;
    const double *mine = coupling_row.data() + (size_t) N * i;
    const double *here = kinematic.data() + (size_t) R::KINEMATIC * i;
    Matrix<D, double> moment{};
    one.force.fill(0.0);
    one.energy = 0.0;
    for (auto &bond : one.bonds) {
      const double *his = coupling_row.data() + (size_t) N * bond.j;
      const double *there = kinematic.data() + (size_t) R::KINEMATIC * bond.j;
      const double depth = mine[D * D] + his[D * D];
      if (bond.stiffness == 0.0 || depth == 0.0) continue;
      const double si = mine[D * D] / depth, sj = his[D * D] / depth;
      double X[D], square = 0.0;
      for (int k = 0; k < D; k++) X[k] = there[R::X + k] - here[R::X + k];
      for (int a = 0; a < D; a++) {
        double r = there[R::U + a] - here[R::U + a];
        for (int b = 0; b < D; b++)
          r -= (si * mine[D * a + b] + sj * his[D * a + b]) * X[b];
        const double t = bond.stiffness * r;
        bond.force[a] = t;
        one.force[a] += t;
        square += r * r;
        for (int b = 0; b < D; b++) moment[a][b] += si * t * X[b];
      }
      one.energy += 0.25 * bond.stiffness * square;
    }
    const double *own = own_constants<D>(i);
    const double stretch = bond_mode ? 1.0 + thermal_strain(i) : 1.0;
    const Matrix<D, double> B = product(moment, shape_inverse<D>(own));
    double *row = force_row.data() + (size_t) i * R::FORCE + R::B;
    for (int k = 0; k < D * D; k++) row[k] -= stretch * B[k / D][k % D];
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::add_coupling_virial(double *each, double *total) const
{
  using R = Rows<D>;
  static constexpr int PLACE[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  for (const auto &one : crossing)
    for (const auto &bond : one.bonds) {
      if (bond.stiffness == 0.0) continue;
      const double *here = kinematic.data() + (size_t) R::KINEMATIC * one.i;
      const double *there = kinematic.data() + (size_t) R::KINEMATIC * bond.j;
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

// for pair_tmsph.cpp and the others

template void PairTMSPH::lay_out_coupling<2>();
template void PairTMSPH::lay_out_coupling<3>();
template void PairTMSPH::update_crossing<2>(Crossing &);
template void PairTMSPH::update_crossing<3>(Crossing &);
template void PairTMSPH::couple_materials<2>();
template void PairTMSPH::couple_materials<3>();
template void PairTMSPH::add_coupling_virial<2>(double *, double *) const;
template void PairTMSPH::add_coupling_virial<3>(double *, double *) const;
