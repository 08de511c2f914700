/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of the own side of an interface between two materials, for output and
   for the breaking of bonds.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "fix_tmsph_bond.h"
#include "tmsph_one_sided_fit.h"
#include "tmsph_sweep.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ----------------------------------------------------------------------
   particles with bonds to another material: their reported stress comes from
   the bonds to their own; a phase one particle thick falls back to all bonds
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::build_own_side()
{
  const int nlocal = atom->nlocal;
  const int *type = atom->type;
  own_side.particle.clear();
  own_side.valid.clear();
  own_side.offset.assign(1, 0);
  own_side_lane.assign(nlocal, -1);
  std::vector<int> members;
  for (int i = 0; i < nlocal; i++) {
    bool mixed = false;
    for (const auto &bond : bond_fix->family(i, FixTMSPHBond::FORMED))
      mixed = mixed || type[bond.j] != type[i];
    if (mixed) members.push_back(i);
  }
  for (size_t first = 0; first < members.size(); first += WIDTH) {
    const int n = std::min<size_t>(WIDTH, members.size() - first);
    int rows = 0;
    for (int l = 0; l < WIDTH; l++) {
      const int i = members[first + (l < n ? l : 0)];
      own_side.particle.push_back(i);
      if (l < n) {
        own_side_lane[i] = first + l;
        rows = std::max(rows, bond_fix->count(i));
      }
    }
    own_side.valid.push_back(n);
    own_side.offset.push_back(own_side.offset.back() + rows);
  }
  const size_t size = (size_t) own_side.offset.back() * WIDTH;
  own_side.weight.assign(size, 0.0f);
  own_side.partner.assign(size, 0);
  own_side.fit.assign(size * D, 0.0);
  own_side.own.assign((size_t) own_side.count() * CONSTANTS<D> * WIDTH, 0.0);
  for (int q = 0; q < own_side.count(); q++)    // pads: no bonds, any partner
    for (int l = own_side.valid[q]; l < WIDTH; l++)
      for (int b = 0; b < own_side.offset[q + 1] - own_side.offset[q]; b++)
        own_side.partner[own_side.at(q, l, b)] = own_side.particle[q * WIDTH + l];
  for (int i : members) fill_own_side<D>(i);
}

/* ---------------------------------------------------------------------- */

template <int D> void PairTMSPH::fill_own_side(int i)
{
  const int q = own_side_lane[i] / WIDTH, l = own_side_lane[i] % WIDTH;
  const int rows = own_side.offset[q + 1] - own_side.offset[q];
  const Slices &all = slices();
  for (const bool own_only : {true, false}) {
    for (int k = 0; k < rows; k++) {
      const size_t at = own_side.at(q, l, k);
      const bool here = k < bond_fix->count(i);
      const int j = here ? bond_fix->partner_index(i, k) : i;
      own_side.partner[at] = j;
      own_side.weight[at] = here && (!own_only || atom->type[j] == atom->type[i])
          ? all.weight[all.at(i / WIDTH, i % WIDTH, k)]
          : 0.0f;
    }
    update_shape<D>(own_side, q, l);
    fit_own_side<D>(q, l, own_only);
    if (own_side.own[(size_t) q * CONSTANTS<D> * WIDTH + l] != 0.0) return;
  }
}

/* ----------------------------------------------------------------------
   a linear fit where neighbors stand all around, or are too few for another
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::fit_own_side(int q, int l, bool one_sided)
{
  using R = Rows<D>;
  const int i = own_side.particle[q * WIDTH + l];
  const double *mine = kinematic.data() + (size_t) i * R::KINEMATIC + R::X;
  const double *own = own_side.own.data() + (size_t) q * CONSTANTS<D> * WIDTH + l;
  Eigen::Matrix<double, D, D> inverse;
  for (int a = 0, entry = 0; a < D; a++)
    for (int b = a; b < D; b++) inverse(a, b) = inverse(b, a) = own[WIDTH * entry++];
  std::vector<size_t> places;
  std::vector<double> weights;
  for (int b = own_side.offset[q]; b < own_side.offset[q + 1]; b++) {
    const size_t at = (size_t) b * WIDTH + l;
    for (int k = 0; k < D; k++) own_side.fit[((size_t) b * D + k) * WIDTH + l] = 0.0;
    if (own_side.weight[at] == 0.0f) continue;
    places.push_back(b);
    weights.push_back(own_side.weight[at]);
  }
  Eigen::Matrix<double, D, Eigen::Dynamic> X(D, places.size()), g(D, places.size());
  for (size_t n = 0; n < places.size(); n++) {
    const int j = own_side.partner[places[n] * WIDTH + l];
    const double *his = kinematic.data() + (size_t) j * R::KINEMATIC + R::X;
    for (int k = 0; k < D; k++) X(k, n) = his[k] - mine[k];
  }
  const double spacing = bond_fix->spacing(i);
  if (inverse.isZero(0.0) || !one_sided || !one_sided_fit<D>(X, weights, spacing, g))
    for (size_t n = 0; n < places.size(); n++) g.col(n) = weights[n] * (inverse * X.col(n));
  for (size_t n = 0; n < places.size(); n++)
    for (int k = 0; k < D; k++) own_side.fit[(places[n] * D + k) * WIDTH + l] = g(k, n);
}

/* ----------------------------------------------------------------------
   own-side stress of the local particles, replacing that over all bonds
------------------------------------------------------------------------- */

template <int D> void PairTMSPH::own_side_stress(bool inverted_breaks)
{
  GradientOutput out;
  out.stress = stress.data();
  out.inverted_breaks = inverted_breaks;
  std::vector<double> fitted(averaging ? own_side_lane.size() * D * D : 0);
  if (averaging) out.gradient = fitted.data();
  gradient_sweep<D>(on, own_side, 0, own_side.count(), kinematic.data(), out);
  if (!averaging) return;
  for (int i = 0; i < atom->nlocal; i++) {
    const auto &from = own_side_lane[i] >= 0 ? fitted : gradient;
    add_pressure_to_stress<D>(i, from.data() + (size_t) D * D * i);
  }
}

// for pair_tmsph.cpp

template void PairTMSPH::build_own_side<2>();
template void PairTMSPH::build_own_side<3>();
template void PairTMSPH::fill_own_side<2>(int);
template void PairTMSPH::fill_own_side<3>(int);
template void PairTMSPH::own_side_stress<2>(bool);
template void PairTMSPH::own_side_stress<3>(bool);
