/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Regions of LAMMPS as the shapes of bodies.
------------------------------------------------------------------------- */

#include "tmsph_region_shapes.h"

#include "domain.h"
#include "error.h"
#include "region.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using TMSPH::TangentPlane;

// how far beyond a surface its other side is looked for, as a part of the reach, and how far a
// region may leave the box, as a part of a cell

static constexpr double BEYOND = 1.0e-3;

/* ---------------------------------------------------------------------- */

template <int D> typename TMSPHRegionShapes<D>::Vector TMSPHRegionShapes<D>::wrapped(Vector X) const
{
  for (int k = 0; k < D; k++)
    if (domain->periodicity[k])
      X[k] -= domain->prd[k] * std::floor((X[k] - domain->boxlo[k]) / domain->prd[k]);
  return X;
}

/* ---------------------------------------------------------------------- */

template <int D> bool TMSPHRegionShapes<D>::inside(int body, const Vector &X) const
{
  const Vector at = wrapped(X);
  return regions[body]->match(at[0], at[1], D == 3 ? at[D - 1] : 0.0);
}

/* ----------------------------------------------------------------------
   of the region at X, a point inside; in 2-D the lines in which they cut the plane
------------------------------------------------------------------------- */

template <int D>
std::vector<TangentPlane<D>> TMSPHRegionShapes<D>::tangents(int body, const Vector &X,
                                                            double reach) const
{
  constexpr double STEEPEST = 0.9;    // nearly parallel to the plane: its ends in 2-D
  Region *const region = regions[body];
  std::vector<TangentPlane<D>> found;
  const int count = region->surface(X[0], X[1], D == 3 ? X[D - 1] : 0.0, reach);
  for (int n = 0; n < count; n++) {
    const Region::Contact &c = region->contact[n];
    const double out[3] = {-c.delx, -c.dely, -c.delz};
    if (!(c.r > 0.0) || (D == 2 && std::fabs(out[2]) > STEEPEST * c.r)) continue;
    TangentPlane<D> plane;
    for (int k = 0; k < D; k++) plane.normal[k] = out[k];
    plane.depth = c.r * c.r / plane.normal.norm();
    plane.normal.normalize();
    plane.beyond = TangentPlane<D>::NOTHING;
    found.push_back(plane);
  }
  return found;
}

/* ---------------------------------------------------------------------- */

template <int D>
std::vector<TangentPlane<D>> TMSPHRegionShapes<D>::planes(int body, const Vector &X,
                                                          double reach) const
{
  std::vector<TangentPlane<D>> surface;
  for (TangentPlane<D> &plane : tangents(body, wrapped(X), reach)) {
    const Vector across = X + (plane.depth + BEYOND * reach) * plane.normal;
    if (inside(body, across)) continue;
    for (int other = 0; other < (int) regions.size(); other++)
      if (inside(other, across)) plane.beyond = other;
    surface.push_back(plane);
  }
  return surface;
}

/* ----------------------------------------------------------------------
   part of a cell with the surface in it that is inside: exact where the surface is flat and along
   the cell's sides, else without bias
------------------------------------------------------------------------- */

template <int D>
double TMSPHRegionShapes<D>::part_inside(int body, const Vector &middle, const Vector &edges,
                                         bool &crossed) const
{
  Region *const region = regions[body];
  const double reach = 0.5 * edges.norm();
  const bool in = region->match(middle[0], middle[1], D == 3 ? middle[D - 1] : 0.0);
  // what is out of a region is in one whose sides are exchanged
  if (!in) region->interior ^= 1;
  const auto surface = tangents(body, middle, reach);
  if (!in) region->interior ^= 1;
  crossed = !surface.empty();
  double part = 1.0;
  for (const TangentPlane<D> &plane : surface)
    part *= std::min(0.5 + plane.depth / plane.normal.cwiseAbs().dot(edges), 1.0);
  return in ? part : 1.0 - part;
}

/* ----------------------------------------------------------------------
   cells that the surface may pass through are divided; large ones anyway, as regions do not tell
   their surface to a point in their very middle
------------------------------------------------------------------------- */

template <int D>
double TMSPHRegionShapes<D>::size_within(int body, const Vector &low, const Vector &high,
                                         double cell) const
{
  constexpr double LARGE = 16.0;    // two spacings, with cells of an eighth of one
  const Vector edges = high - low, middle = 0.5 * (low + high);
  int longest;
  const double length = edges.maxCoeff(&longest);
  if (length <= LARGE * cell) {
    bool crossed;
    const double part = part_inside(body, middle, edges, crossed);
    if (!crossed || length <= cell) return part * edges.prod();
  }
  Vector end = high, start = low;
  end[longest] = start[longest] = middle[longest];
  return size_within(body, low, end, cell) + size_within(body, start, high, cell);
}

/* ---------------------------------------------------------------------- */

template <int D> double TMSPHRegionShapes<D>::size(int body, double cell) const
{
  constexpr double FAR = 1.0e19;    // INF of a region is 1e20
  const Region &region = *regions[body];
  const double extent[2][3] = {{region.extent_xlo, region.extent_ylo, region.extent_zlo},
                               {region.extent_xhi, region.extent_yhi, region.extent_zhi}};
  const bool known = region.bboxflag && !region.dynamic && !region.varshape;
  Vector low, high;
  for (int k = 0; k < D; k++) {
    low[k] = domain->boxlo[k];
    high[k] = domain->boxhi[k];
  }
  const Vector box[2] = {low, high};
  for (int k = 0; k < D; k++)
    for (int side = 0; side < 2 && !domain->periodicity[k]; side++) {
      const double end = extent[side][k];
      Vector &face = side ? high : low;
      if (known && std::fabs(end) < FAR) {
        const double over = side ? end - box[1][k] : box[0][k] - end;
        if (over > BEYOND * cell && domain->boundary[k][side] == 1)
          error->all(FLERR,
                     "Region {} of tmsph/relax reaches beyond the box in {}: make the box larger",
                     region.id, "xyz"[k]);
        face[k] = end;
        continue;
      }
      Vector from = box[0], to = box[1];
      from[k] = side ? box[1][k] : box[0][k] - cell;
      to[k] = from[k] + cell;
      if (size_within(body, from, to, cell) > BEYOND * (to - from).prod())
        error->all(FLERR,
                   "Region {} of tmsph/relax has no surface in {}, where the box is not periodic: "
                   "end the region there, within the box",
                   region.id, "xyz"[k]);
    }
  return size_within(body, low, high, cell);
}

template class LAMMPS_NS::TMSPHRegionShapes<2>;
template class LAMMPS_NS::TMSPHRegionShapes<3>;
