/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_body_surface.h"

#include "domain.h"
#include "fix_tmsph_bond.h"
#include "tmsph_collective.h"
#include "tmsph_conductance_balance.h"
#include "tmsph_conduction_norms.h"
#include "tmsph_flat_faces.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// one-sidedness of the particles in the outermost row of a surface, at least: of a flat one it is
// about 0.45, inside an irregular cloud below 0.15; 0.2 does the same in test_heat_slab, whose
// clouds are jittered by 0.2, 0.35 changes its errors by 1 %

static constexpr double OUTERMOST = 0.25;

// one-sidedness that is more than round-off

static constexpr double EVEN = 1.0e-6;

// one-sidedness inside an irregular cloud, at least: with spacings that vary by a few thousandths;
// 3e-4 to 5e-3 do the same in test_heat_slab

static constexpr double IRREGULAR = 1.0e-3;

// one-sidedness of surfaces in an irregular cloud, in multiples of that inside it: with 4 the
// errors of test_heat_slab change by 6 %, with 2 they are smaller by up to 40 % at 40 particles,
// and with given flux larger by a tenth at 10

static constexpr double FAR_MORE = 3.0;

// of smoothing of normals in irregular clouds: with 1 the errors of given flux in test_heat_slab
// are larger by up to a third, 3 gain nothing

static constexpr int PASSES = 2;

// less than this fraction of a pull is round-off of single precision

static constexpr double NOTHING = 1.0e-4;

/* ---------------------------------------------------------------------- */

TMSPHBodySurface::TMSPHBodySurface(LAMMPS *lmp, const TMSPHConductionNorms &kept,
                                   const TMSPHFlatFaces &flat,
                                   const TMSPHConductanceBalance &balanced,
                                   TMSPHGhostSender &sender) :
    Pointers(lmp),
    norms(kept), faces(flat), balance(balanced), ghosts(sender)
{
}

/* ----------------------------------------------------------------------
   Normal, depth and area of the surface near each local particle. With
     A_i = 2 c V_i |sum_j V_j grad W_ij|
   a field that varies linearly with the depth is steady at each particle near a
   flat surface at the right temperature: what its bonds bring, A_i k dT/dn, is
   what its part of the surface takes.
------------------------------------------------------------------------- */

template <int D> std::vector<BondPull> TMSPHBodySurface::pulls_of_bonds(bool cracks) const
{
  const int nlocal = atom->nlocal;
  const unsigned states = cracks ? FixTMSPHBond::WHOLE : FixTMSPHBond::FORMED;
  std::vector<BondPull> found(nlocal);
  for (int i = 0; i < nlocal; i++) {
    BondPull &pull = found[i];
    const double c = norms.frozen_norm(i);
    OwnSurface<D> own;
    for (const auto &bond : bonds->family(i, states)) {
      const int j = bond.j;
      double X[3];
      bonds->reference_vector(i, j, X);
      double weight = bonds->weight(i, j);
      if (balance.any())
        weight *= 0.5 * (1.0 + norms.norm(j) / norms.norm(i)) * balance.factor(i, j, X);
      own.add(X, weight);
      if (faces.any()) weight *= faces.factor(i, j, X);
      for (int a = 0; a < D; a++) pull.conducted[a] -= 2.0 * c * weight * X[a];
    }
    pull.surface = own.find(bonds->spacing(i), EVEN);
    const Exposure exposure = pull.surface.exposure;
    if (exposure == Exposure::SURFACE) {
      pull.surface.depth = own.depth_of_rows(pull.surface, bonds->spacing(i));
      pull.area = 2.0 * c * own.length_of_sum();
    }
    pull.one_sidedness = own.one_sidedness();
    pull.outermost = exposure == Exposure::LOOSE || pull.one_sidedness > OUTERMOST;
  }
  return found;
}

/* ---------------------------------------------------------------------- */

std::vector<char> TMSPHBodySurface::near(const std::vector<BondPull> &pulls) const
{
  std::vector<double> outermost;
  for (const BondPull &p : pulls) outermost.push_back(p.outermost);
  ghosts.complete(outermost);
  std::vector<char> found(pulls.size());
  for (int i = 0; i < atom->nlocal; i++) {
    found[i] = outermost[i] != 0.0;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED)) {
      if (found[i]) break;
      found[i] = outermost[bond.j] != 0.0;
    }
  }
  return found;
}

/* ----------------------------------------------------------------------
   typical one-sidedness of particles away from any surface: 0 on a lattice
------------------------------------------------------------------------- */

double TMSPHBodySurface::noise_inside(const std::vector<BondPull> &pulls,
                                      const std::vector<char> &near) const
{
  std::vector<double> inside;
  for (size_t i = 0; i < pulls.size(); i++)
    if (!near[i]) inside.push_back(pulls[i].one_sidedness);
  return median(inside, world);
}

/* ---------------------------------------------------------------------- */

bool TMSPHBodySurface::irregular_inside(const std::vector<BondPull> &pulls,
                                        const std::vector<char> &near) const
{
  return noise_inside(pulls, near) >= IRREGULAR;
}

/* ---------------------------------------------------------------------- */

std::vector<BondPull> TMSPHBodySurface::pulls(bool cracks) const
{
  auto found = domain->dimension == 2 ? pulls_of_bonds<2>(cracks) : pulls_of_bonds<3>(cracks);
  const std::vector<char> beside = near(found);
  for (int i = 0; i < atom->nlocal; i++)
    if (!beside[i]) found[i].area = 0.0;
  if (balance.any()) {
    smooth(found, IRREGULAR);
    return found;
  }
  const double noise = noise_inside(found, beside);
  if (noise >= IRREGULAR) smooth(found, FAR_MORE * noise);
  return found;
}

/* ----------------------------------------------------------------------
   In an irregular cloud bonds pull unevenly too: of its particles those make the
   surface whose bonds pull far more so, and what the bonds of a neighborhood
   bring together gives the normal. Along it the pulls of the surface add up to
   those that a field of unit slope brings through the inside, as heat is
   conserved.
   @param least one-sidedness of the surface
------------------------------------------------------------------------- */

void TMSPHBodySurface::smooth(std::vector<BondPull> &pulls, double least) const
{
  // the normal from the pulls of the neighborhood, summed up in two passes: it scatters by less
  // than a hundredth then

  const int nlocal = atom->nlocal;
  std::vector<double> smoothed[3], sums[3];
  for (int k = 0; k < 3; k++)
    for (BondPull &pull : pulls) {
      if (pull.one_sidedness < least) pull.area = 0.0;
      smoothed[k].push_back(pull.area * pull.surface.normal[k]);
    }
  for (int pass = 0; pass < PASSES; pass++)
    for (int k = 0; k < 3; k++) {
      ghosts.complete(smoothed[k]);
      sums[k].assign(nlocal, 0.0);
      for (int i = 0; i < nlocal; i++) {
        if (pulls[i].area == 0.0) continue;
        sums[k][i] = smoothed[k][i];
        for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED))
          sums[k][i] += smoothed[k][bond.j];
      }
      smoothed[k] = sums[k];
    }
  for (int i = 0; i < nlocal; i++) {
    BondPull &pull = pulls[i];
    if (pull.area == 0.0) continue;
    double square = 0.0, along = 0.0;
    for (int k = 0; k < 3; k++) {
      square += smoothed[k][i] * smoothed[k][i];
      along += smoothed[k][i] * pull.surface.normal[k];
    }
    const double length = std::sqrt(square);
    pull.area *= along > 0.0 ? along / length : 0.0;
    for (int k = 0; k < 3 && length > 0.0; k++) pull.surface.normal[k] = smoothed[k][i] / length;
  }
}

/* ----------------------------------------------------------------------
   The pull of a particle divided among its faces: a linear field stays steady, as
   with the whole. Of two opposite faces the pull is the difference; what the
   bonds that it lacks would bring is the sum. With cracks what is left of
   the pull belongs to them.
   @return false if the particle has no flat faces
------------------------------------------------------------------------- */

template <int D>
bool TMSPHBodySurface::divide_among_faces(int i, const BondPull &pull, bool cracks,
                                          std::vector<TMSPHSurfacePiece> &pieces) const
{
  using Vector = Eigen::Matrix<double, D, 1>;
  std::vector<Layer<D>> own;
  for (int k = 0; k < faces.count(i); k++) own.push_back(faces.layer<D>(i, k));
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
    TMSPHSurfacePiece piece = {i, Surface(), area, true};
    piece.surface.exposure = Exposure::SURFACE;
    piece.surface.depth = depth;
    for (int a = 0; a < D; a++) piece.surface.normal[a] = normal[a];
    pieces.push_back(piece);
  };
  const double half = 0.5 * bonds->spacing(i);
  for (size_t k = 0; k < own.size(); k++) {
    const Layer<D> &layer = own[k];
    if (layer.below > 0.0) {
      const double both = std::max(2.0 * norms.frozen_norm(i) * layer.missing, std::fabs(along[k]));
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

/* ----------------------------------------------------------------------
   flat faces of a lattice take their parts each, else there is one piece to a particle
------------------------------------------------------------------------- */

std::vector<TMSPHSurfacePiece> TMSPHBodySurface::pieces(bool cracks) const
{
  const auto found = pulls(cracks);
  const bool plane = domain->dimension == 2;
  std::vector<TMSPHSurfacePiece> list;
  for (int i = 0; i < atom->nlocal; i++) {
    const bool told_apart = faces.any() &&
        (plane ? divide_among_faces<2>(i, found[i], cracks, list)
               : divide_among_faces<3>(i, found[i], cracks, list));
    if (!told_apart && found[i].area > 0.0)
      list.push_back({i, found[i].surface, found[i].area, false});
  }
  return list;
}
