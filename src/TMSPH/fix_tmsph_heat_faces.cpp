/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Flat faces of bodies on lattices in fix tmsph/heat: shares of their areas, and
   conduction along them.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "domain.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "pair_tmsph.h"
#include "tmsph_kernel.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// less than this share of a pull is round-off of single precision

static constexpr double NOTHING = 1.0e-4;

// a flat face ends at other ones: in so many steps of a horizon along it no curved rim, whose steps
// have short flat stretches too

static constexpr int STEPS_ALONG = 6;

/* ----------------------------------------------------------------------
   Layers of the particles near the surface; they are stored.
   @param second sum_j V_j w R^2 becomes that of the lattice where faces are found
------------------------------------------------------------------------- */

template <int D>
void FixTMSPHHeat::find_layers(const std::vector<char> &near, std::vector<double> &second)
{
  std::vector<double> rough(atom->nlocal, 0.0);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!near[i]) continue;
    const double horizon = pair->horizon(atom->type[i], atom->type[i]), V = atom->vfrac[i];
    const auto weight = [&](double R) {
      return V * V * kernel_slope(pair->kernel_of_bonds(), D, R, horizon);
    };
    LatticeFaces<D> family(horizon);
    for (int k = 0; k < bonds->count(i); k++) {
      const int j = bonds->partner_index(i, k);
      if (j == i || bonds->bond_state(i, k) == FixTMSPHBond::UNBONDED) continue;
      double X[3];
      bonds->reference_vector(i, j, X);
      family.add(X);
    }
    rough[i] = !family.find(weight);
    if (family.found().empty()) continue;
    double *to = make_faces(i);
    for (const Layer<D> &layer : family.found()) {
      layer.put(to);
      to += Layer<D>::SIZE;
    }
    second[i] = family.second_moment(weight) / V;
  }
  share_layers();
  for (int step = 0; step < STEPS_ALONG && faced; step++) drop_steps<D>(rough);
  share_layers();
}

template void FixTMSPHHeat::find_layers<2>(const std::vector<char> &, std::vector<double> &);
template void FixTMSPHHeat::find_layers<3>(const std::vector<char> &, std::vector<double> &);

/* ----------------------------------------------------------------------
   forgets the faces along which a partner is that does not know what bounds it
   @param rough such particles; more of them after this
------------------------------------------------------------------------- */

template <int D> void FixTMSPHHeat::drop_steps(std::vector<double> &rough)
{
  ghosts.complete(rough);
  std::vector<double> more(rough.begin(), rough.begin() + atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    const int count = count_faces(i);
    for (int k = 0; k < count; k++) {
      const Layer<D> own = layer<D>(i, k);
      for (int n = 0; n < bonds->count(i) && !more[i]; n++) {
        const int j = bonds->partner_index(i, n);
        if (j == i || bonds->bond_state(i, n) == FixTMSPHBond::UNBONDED || !rough[j]) continue;
        double X[3];
        bonds->reference_vector(i, j, X);
        more[i] = own.along(X);
      }
    }
    if (more[i]) face_row[i] = NONE;
  }
  rough = more;
}

/* ----------------------------------------------------------------------
   factor to the conductance of a bond of i along faces
------------------------------------------------------------------------- */

template <int D> double FixTMSPHHeat::boost(int i, const double *X) const
{
  double factor = 1.0;
  const int count = count_faces(i);
  for (int k = 0; k < count; k++) {
    const Layer<D> found = layer<D>(i, k);
    if (found.along(X)) factor *= 1.0 + found.boost;
  }
  return factor;
}

template double FixTMSPHHeat::boost<2>(int, const double *) const;
template double FixTMSPHHeat::boost<3>(int, const double *) const;

/* ----------------------------------------------------------------------
   The pull of a particle divided among its faces: a linear field stays steady, as
   with the whole. Of two opposite faces the pull is the difference; what the
   bonds that it lacks would bring is the sum. With cracks what is left of
   the pull belongs to them.
   @return false if the particle has no flat faces
------------------------------------------------------------------------- */

template <int D>
bool FixTMSPHHeat::share_faces(int i, const Pull &pull, bool cracks,
                               std::vector<SurfaceShare> &shares)
{
  using Vector = Eigen::Matrix<double, D, 1>;
  std::vector<Layer<D>> own;
  for (int k = 0; k < count_faces(i); k++) own.push_back(layer<D>(i, k));
  if (own.empty()) return false;
  bool cracked = false;
  for (int k = 0; k < bonds->count(i) && cracks; k++) {
    const int state = bonds->bond_state(i, k);
    cracked = cracked || state == FixTMSPHBond::BROKEN || state == FixTMSPHBond::CUT;
  }
  if (cracked && pull.surface.exposure == Exposure::LOOSE) return true;

  const Eigen::Map<const Vector> whole(pull.conducted);
  Eigen::Matrix<double, D, Eigen::Dynamic> normals(D, own.size());
  for (size_t k = 0; k < own.size(); k++) normals.col(k) = own[k].normal;
  const Eigen::VectorXd along = normals.colPivHouseholderQr().solve(whole);
  const auto add = [&](const Vector &normal, double depth, double area) {
    if (!(area > 0.0)) return;
    SurfaceShare share = {i, Surface(), area, true};
    share.surface.exposure = Exposure::SURFACE;
    share.surface.depth = depth;
    for (int a = 0; a < D; a++) share.surface.normal[a] = normal[a];
    shares.push_back(share);
  };
  const double half = 0.5 * bonds->spacing(i);
  for (size_t k = 0; k < own.size(); k++) {
    const Layer<D> &layer = own[k];
    if (layer.below > 0.0) {
      const double both =
          std::max(2.0 * norms->astore[i][NORM] * layer.missing, std::fabs(along[k]));
      add(layer.normal, layer.above, 0.5 * (both + along[k]));
      add(-layer.normal, layer.below, 0.5 * (both - along[k]));
    } else {
      add(layer.normal, layer.above, along[k]);
      if (cracked) add(-layer.normal, half, -along[k]);
    }
  }
  const Vector rest = whole - normals * along;
  const double length = rest.norm();
  if (cracked && length > NOTHING * whole.norm()) add(rest / length, half, length);
  return true;
}

template bool FixTMSPHHeat::share_faces<2>(int, const Pull &, bool, std::vector<SurfaceShare> &);
template bool FixTMSPHHeat::share_faces<3>(int, const Pull &, bool, std::vector<SurfaceShare> &);
