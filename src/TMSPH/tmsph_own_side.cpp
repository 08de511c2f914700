/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress of the own side of an interface between two materials, for output and
   for the breaking of bonds.
------------------------------------------------------------------------- */

#include "tmsph_own_side.h"

#include "tmsph_one_sided_fit.h"
#include "tmsph_shape.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOwnSide::lay_out(const FixTMSPHBond &bonds, const Atom &atom, const double *kinematic)
{
  const int nlocal = atom.nlocal;
  const int *type = atom.type;
  slices.particle.clear();
  slices.valid.clear();
  slices.offset.assign(1, 0);
  lane.assign(nlocal, -1);
  std::vector<int> members;
  for (int i = 0; i < nlocal; i++) {
    bool mixed = false;
    for (const auto &bond : bonds.family(i, FixTMSPHBond::FORMED))
      mixed = mixed || type[bond.j] != type[i];
    if (mixed) members.push_back(i);
  }
  for (size_t first = 0; first < members.size(); first += LANES) {
    const int n = std::min<size_t>(LANES, members.size() - first);
    int rows = 0;
    for (int l = 0; l < LANES; l++) {
      const int i = members[first + (l < n ? l : 0)];
      slices.particle.push_back(i);
      if (l < n) {
        lane[i] = first + l;
        rows = std::max(rows, bonds.count(i));
      }
    }
    slices.valid.push_back(n);
    slices.offset.push_back(slices.offset.back() + rows);
  }
  const size_t size = (size_t) slices.offset.back() * LANES;
  slices.weight.assign(size, 0.0f);
  slices.partner.assign(size, 0);
  slices.fit.assign(size * D, 0.0);
  slices.own.assign((size_t) slices.count() * CONSTANTS<D> * LANES, 0.0);
  for (int q = 0; q < slices.count(); q++)    // pads: no bonds, any partner
    for (int l = slices.valid[q]; l < LANES; l++)
      for (int b = 0; b < slices.offset[q + 1] - slices.offset[q]; b++)
        slices.partner[slices.at(q, l, b)] = slices.particle[q * LANES + l];
  for (int i : members) fill<D>(i, bonds, atom, kinematic);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOwnSide::follow(int i, const FixTMSPHBond &bonds, const Atom &atom,
                          const double *kinematic)
{
  if (lane[i] >= 0) fill<D>(i, bonds, atom, kinematic);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOwnSide::fill(int i, const FixTMSPHBond &bonds, const Atom &atom, const double *kinematic)
{
  const int q = lane[i] / LANES, l = lane[i] % LANES;
  const int rows = slices.offset[q + 1] - slices.offset[q];
  const Slices &whole = bonds.layout();
  const double *const constants = whole.constants<D>(i) + LANES * SYMMETRIC<D>;
  const ParticleConstants same = {constants[0], constants[LANES], constants[2 * LANES], 0.0};
  for (const bool own_only : {true, false}) {
    for (int k = 0; k < rows; k++) {
      const size_t at = slices.at(q, l, k);
      const bool here = k < bonds.count(i);
      const int j = here ? bonds.partner_index(i, k) : i;
      slices.partner[at] = j;
      slices.weight[at] =
          here && (!own_only || atom.type[j] == atom.type[i]) ? whole.weight[whole.at(i, k)] : 0.0f;
    }
    update_shape<D>(slices, q, l, kinematic, bonds.interior_kappa(), same);
    fit<D>(q, l, own_only, bonds.spacing(i), kinematic);
    if (slices.own[(size_t) q * CONSTANTS<D> * LANES + l] != 0.0) return;
  }
}

/* ----------------------------------------------------------------------
   a linear fit where neighbors stand all around, or are too few for another
------------------------------------------------------------------------- */

template <int D>
void TMSPHOwnSide::fit(int q, int l, bool one_sided, double spacing, const double *kinematic)
{
  using R = Rows<D>;
  const int i = slices.particle[q * LANES + l];
  const double *mine = kinematic + (size_t) i * R::KINEMATIC + R::X;
  const double *own = slices.own.data() + (size_t) q * CONSTANTS<D> * LANES + l;
  Eigen::Matrix<double, D, D> inverse;
  for (int a = 0, entry = 0; a < D; a++)
    for (int b = a; b < D; b++) inverse(a, b) = inverse(b, a) = own[LANES * entry++];
  std::vector<size_t> places;
  std::vector<double> weights;
  for (int b = slices.offset[q]; b < slices.offset[q + 1]; b++) {
    const size_t at = (size_t) b * LANES + l;
    for (int k = 0; k < D; k++) slices.fit[((size_t) b * D + k) * LANES + l] = 0.0;
    if (slices.weight[at] == 0.0f) continue;
    places.push_back(b);
    weights.push_back(slices.weight[at]);
  }
  Eigen::Matrix<double, D, Eigen::Dynamic> X(D, places.size()), g(D, places.size());
  for (size_t n = 0; n < places.size(); n++) {
    const int j = slices.partner[places[n] * LANES + l];
    const double *his = kinematic + (size_t) j * R::KINEMATIC + R::X;
    for (int k = 0; k < D; k++) X(k, n) = his[k] - mine[k];
  }
  if (inverse.isZero(0.0) || !one_sided || !one_sided_fit<D>(X, weights, spacing, g))
    for (size_t n = 0; n < places.size(); n++) g.col(n) = weights[n] * (inverse * X.col(n));
  for (size_t n = 0; n < places.size(); n++)
    for (int k = 0; k < D; k++) slices.fit[(places[n] * D + k) * LANES + l] = g(k, n);
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOwnSide::find_stress(const Features &on, const double *kinematic,
                               const GradientOutput &out) const
{
  gradient_sweep<D>(on, slices, 0, slices.count(), kinematic, out);
}

namespace LAMMPS_NS {
template void TMSPHOwnSide::lay_out<2>(const FixTMSPHBond &, const Atom &, const double *);
template void TMSPHOwnSide::lay_out<3>(const FixTMSPHBond &, const Atom &, const double *);
template void TMSPHOwnSide::follow<2>(int, const FixTMSPHBond &, const Atom &, const double *);
template void TMSPHOwnSide::follow<3>(int, const FixTMSPHBond &, const Atom &, const double *);
template void TMSPHOwnSide::find_stress<2>(const Features &, const double *,
                                           const GradientOutput &) const;
template void TMSPHOwnSide::find_stress<3>(const Features &, const double *,
                                           const GradientOutput &) const;
}    // namespace LAMMPS_NS
