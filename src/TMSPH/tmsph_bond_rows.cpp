/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The two rows that the sweeps read at both ends of a bond: see tmsph_sweep.h.
------------------------------------------------------------------------- */

#include "tmsph_bond_rows.h"

#include "domain.h"
#include "tmsph_stop.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHBondRows::lay_out(const TMSPHMaterials &materials, const FixTMSPHBond &bonds)
{
  using R = Rows<D>;
  const int nall = atom->nlocal + atom->nghost;
  kinematic_row.assign((size_t) nall * R::KINEMATIC, 0.0);
  force_row.assign((size_t) nall * R::FORCE, 0.0);
  for (int i = 0; i < nall; i++) {
    const double density = atom->rmass[i] / atom->vfrac[i];
    double *row = kinematic_row.data() + (size_t) i * R::KINEMATIC;
    for (int k = 0; k < D; k++) row[R::X + k] = bonds.reference(i)[k];
    row[R::YOUNG] = materials.elastic(i).young;
    double *end = D == 2 ? row : force_row.data() + (size_t) i * R::FORCE;
    end[R::SPEED] = std::sqrt(materials.elastic(i).wave_modulus / density);
    end[R::DENSITY] = density;
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHBondRows::move(const TMSPHMaterials &materials, bool heated)
{
  using R = Rows<D>;
  double **x = atom->x;
  const int nall = atom->nlocal + atom->nghost;
  for (int i = 0; i < nall; i++) {
    double *row = kinematic_row.data() + (size_t) i * R::KINEMATIC;
    for (int k = 0; k < D; k++) row[R::U + k] = x[i][k] - row[R::X + k];
  }
  if (!heated) return;
  bool possible = true;
  for (int i = 0; i < nall; i++) {
    const double push = materials.thermal_push(i);
    kinematic_row[(size_t) i * R::KINEMATIC + R::THERMAL] = push;
    possible &= push > -materials.elastic(i).young;    // false for NaN
  }
  if (!possible) stop_thermal(lmp, materials);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHBondRows::take_velocities(const FixTMSPHBond &bonds)
{
  static constexpr double REST[3] = {0.0, 0.0, 0.0};
  const bool minimizing = update->whichflag == 2;    // looks for equilibrium: nothing moves
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = minimizing ? REST : update->setupflag ? bonds.setup_velocity(i) : atom->v[i];
    std::copy_n(v, D, force<D>(i) + Rows<D>::V);
  }
  stepped = !minimizing;
  box_moves = stepped && box.carries_velocities();
}

/* ---------------------------------------------------------------------- */

const double *TMSPHBondRows::step_velocity(int i) const
{
  if (!stepped) return nullptr;
  return force_row.data() +
      (domain->dimension == 2 ? (size_t) i * Rows<2>::FORCE + Rows<2>::V
                              : (size_t) i * Rows<3>::FORCE + Rows<3>::V);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHBondRows::try_move(const std::vector<double> &trial, double push, double rate)
{
  using R = Rows<D>;
  box_moves = false;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < D; k++) {
      const double p = push * trial[D * (size_t) i + k];
      kinematic_row[(size_t) i * R::KINEMATIC + R::U + k] += p;
      force_row[(size_t) i * R::FORCE + R::V + k] = rate * p;
    }
  ghosts.send(kinematic() + R::U, R::KINEMATIC, D);
}

/* ---------------------------------------------------------------------- */

template <int D> std::vector<double> TMSPHBondRows::velocities() const
{
  std::vector<double> v((size_t) D * atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++)
    std::copy_n(force_row.data() + (size_t) i * Rows<D>::FORCE + Rows<D>::V, D,
                v.data() + (size_t) D * i);
  return v;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHBondRows::put_velocities(const std::vector<double> &v)
{
  for (int i = 0; i < atom->nlocal; i++)
    std::copy_n(v.data() + (size_t) D * i, D, force<D>(i) + Rows<D>::V);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHBondRows::send_forces(int columns)
{
  sends_velocities = box_moves;
  ghosts.send(force(), Rows<D>::FORCE, columns);
  sends_velocities = false;
}

/* ---------------------------------------------------------------------- */

void TMSPHBondRows::add_rate(int n, const int *list, double *buf, const int *pbc) const
{
  if (!sends_velocities) return;
  const int first = domain->dimension == 2 ? Rows<2>::V : Rows<3>::V;
  box.add_rate(pbc, n, list, buf + first, ghosts.count());
}

namespace LAMMPS_NS {
template void TMSPHBondRows::lay_out<2>(const TMSPHMaterials &, const FixTMSPHBond &);
template void TMSPHBondRows::lay_out<3>(const TMSPHMaterials &, const FixTMSPHBond &);
template void TMSPHBondRows::move<2>(const TMSPHMaterials &, bool);
template void TMSPHBondRows::move<3>(const TMSPHMaterials &, bool);
template void TMSPHBondRows::take_velocities<2>(const FixTMSPHBond &);
template void TMSPHBondRows::take_velocities<3>(const FixTMSPHBond &);
template void TMSPHBondRows::try_move<2>(const std::vector<double> &, double, double);
template void TMSPHBondRows::try_move<3>(const std::vector<double> &, double, double);
template std::vector<double> TMSPHBondRows::velocities<2>() const;
template std::vector<double> TMSPHBondRows::velocities<3>() const;
template void TMSPHBondRows::put_velocities<2>(const std::vector<double> &);
template void TMSPHBondRows::put_velocities<3>(const std::vector<double> &);
template void TMSPHBondRows::send_forces<2>(int);
template void TMSPHBondRows::send_forces<3>(int);
}    // namespace LAMMPS_NS
