/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Surfaces of bodies near their particles in the reference state.
------------------------------------------------------------------------- */

#include "tmsph_contact_surfaces.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "region.h"
#include "tmsph_region_surface.h"

using namespace LAMMPS_NS;
using namespace TMSPH;

// cosine of the angle between the outward normals of two particles that are certainly on the same
// side of a surface, at least: 26 degrees, by which a side turns within a horizon of 3 spacings if
// its radius is 6.6 spacings; for a warning only

static constexpr double SAME_SIDE = 0.9;

/* ---------------------------------------------------------------------- */

void TMSPHContactSurfaces::init()
{
  watch.forget();
  regions.clear();
  if (scene.segments && !region_ids.empty())
    error->all(FLERR,
               "Fix tmsph/contact surface is for method kernel: method segment takes the "
               "outlines of the bodies");
  for (const std::string &name : region_ids) {
    Region *region = domain->get_region_by_id(name);
    if (!region)
      error->all(FLERR,
                 "Region {} of fix tmsph/contact surface does not exist: define it with the "
                 "command region",
                 name);
    if (region->dynamic || region->varshape)
      error->all(FLERR,
                 "Region {} of fix tmsph/contact surface moves: give the surface of a body in "
                 "the reference positions; it then moves with the body",
                 name);
    regions.push_back(region);
  }
}

/* ----------------------------------------------------------------------
   the nearest surface of a region within the horizon of local or ghost particle i
   in the reference positions, or INSIDE
------------------------------------------------------------------------- */

Surface TMSPHContactSurfaces::given(int i) const
{
  Surface s;
  s.depth = scene.pair->horizon();
  for (Region *region : regions) take_nearest_surface(*region, *scene.bonds, i, s);
  return s;
}

/* ---------------------------------------------------------------------- */

template <int D>
bool TMSPHContactSurfaces::take_given(int low, int high, const double *X, PairGeometry &geometry)
{
  if (regions.empty()) return false;
  const Surface one = given(low), other = given(high);
  if (one.exposure != Exposure::GIVEN || other.exposure != Exposure::GIVEN) return false;
  double facing = 0.0, apart = 0.0;
  for (int a = 0; a < D; a++) {
    facing += one.normal[a] * other.normal[a];
    apart += 0.5 * (one.normal[a] - other.normal[a]) * X[a];
  }
  const double square = 0.5 * (1.0 - facing);    // of the length of half the difference: of "lean"
  if (facing > SAME_SIDE && !sides_checked) {
    sides_checked = true;
    error->warning(FLERR,
                   "Particles {} and {} are not bonded but on the same side of the surface of "
                   "fix tmsph/contact: give the region by which they got their types",
                   atom->tag[low], atom->tag[high]);
  }
  if (facing > FACING || apart <= 0.0) return false;
  for (int a = 0; a < 3; a++) {
    geometry.normal_low[a] = one.normal[a];
    geometry.normal_high[a] = -other.normal[a];
  }
  geometry.distance = apart / square;
  geometry.depth = one.depth / (one.depth + other.depth);
  return true;
}

template bool TMSPHContactSurfaces::take_given<2>(int, int, const double *, PairGeometry &);
template bool TMSPHContactSurfaces::take_given<3>(int, int, const double *, PairGeometry &);

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactSurfaces::find()
{
  const FixTMSPHBond &bonds = *scene.bonds;
  if (!watch.laid_out_anew(bonds) && !watch.removed(bonds)) return;
  watch.see(bonds);
  surfaces.assign(atom->nlocal, Surface());
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & scene.groupbit)) continue;
    surfaces[i] = given(i);
    if (surfaces[i].exposure == Exposure::GIVEN) continue;
    OwnSurface<D> own;
    for (const auto &bond : bonds.family(i, FixTMSPHBond::WHOLE)) {
      double X[3];
      bonds.reference_vector(i, bond.j, X);
      own.add(X, bonds.weight(i, bond.j));
    }
    surfaces[i] = own.find(bonds.spacing(i));
  }
}

template void TMSPHContactSurfaces::find<2>();
template void TMSPHContactSurfaces::find<3>();
