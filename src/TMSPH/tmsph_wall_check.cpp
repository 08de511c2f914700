/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Does a wall stand where it makes sense when it starts: a warning at most, with the remedy.
------------------------------------------------------------------------- */

#include "tmsph_wall_check.h"

#include "atom.h"
#include "domain.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

static constexpr double ROUND_OFF = 1.0e-6;    // of half a cell: what positions and spacings lose

/* ---------------------------------------------------------------------- */

void TMSPHWallCheck::warn(const TMSPHWallPlaces &places) const
{
  const char *edge = domain->dimension == 2 ? "(volume/thickness)^(1/2)" : "volume^(1/3)";
  bigint cut;
  const double depth = depth_in_body(cut);
  if (depth > 0.0) {
    scene.pair->warn_once(
        fmt::format("Wall {} stands {:.3g} deep in the body and crosses {} bonds: put it outside, "
                    "half a cell, half of {}, from the surface particles",
                    scene.id, depth, cut, edge));
    return;
  }
  if (!scene.both_sides && all_behind()) {
    scene.pair->warn_once(
        fmt::format("Wall {} has all particles behind it: {}, or use 'side both'", scene.id,
                    domain->dimension == 2 ? "what it holds belongs to its left, so swap its ends"
                                           : "turn its normal to the particles"));
    return;
  }
  const double deepest = places.overlap(ROUND_OFF);
  double all;
  MPI_Allreduce(&deepest, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  if (all > 0.0)
    scene.pair->warn_once(
        fmt::format("Particles overlap wall {} from the start, by up to {:.3g}, and are pushed "
                    "out: half a cell, half of {}, belongs between a surface particle and a wall",
                    scene.id, all, edge));
}

/* ----------------------------------------------------------------------
   A bond between two particles that are both more than half a cell from the wall and on different
   sides of it has its middle in the body.
   @param bonds_cut all bonds that cross it
   @return largest distance of the nearer end of such a bond, plus half a cell; 0: none
------------------------------------------------------------------------- */

double TMSPHWallCheck::depth_in_body(bigint &bonds_cut) const
{
  const auto *bonds = scene.pair->bonds();
  const double horizon = scene.pair->horizon();
  double mine = 0.0, depth;
  bigint crossing = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & scene.groupbit)) continue;
    const Point here = candidates.position_of(i), from = scene.motion.to_body(here);
    const double distance = scene.shape->distance(from);
    if (distance > horizon) continue;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE)) {
      const int j = bond.j;
      if (!(atom->mask[j] & scene.groupbit)) continue;
      Point there = here;
      for (int a = 0; a < domain->dimension; a++) there[a] += atom->x[j][a] - atom->x[i][a];
      const Point to = scene.motion.to_body(there);
      if (!cuts(from, to)) continue;
      crossing++;
      const double nearer = std::min(distance, scene.shape->distance(to));
      if (nearer > (1.0 + ROUND_OFF) * scene.gap(i)) mine = std::max(mine, nearer + scene.gap(i));
    }
  }
  MPI_Allreduce(&mine, &depth, 1, MPI_DOUBLE, MPI_MAX, world);
  MPI_Allreduce(&crossing, &bonds_cut, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  bonds_cut /= 2;
  return depth;
}

/* ----------------------------------------------------------------------
   Bisection for where the side changes: is that on the wall, or beyond its end?
------------------------------------------------------------------------- */

bool TMSPHWallCheck::cuts(Point from, Point to) const
{
  static constexpr int HALVINGS = 20;    // to 1e-6 of the bond, below the 1e-3 that is asked for
  const int side = scene.shape->side_of(from);
  if (side == scene.shape->side_of(to)) return false;
  double length = 0.0;
  for (int a = 0; a < 3; a++) length = std::max(length, std::fabs(to[a] - from[a]));
  Point middle;
  for (int k = 0; k < HALVINGS; k++) {
    for (int a = 0; a < 3; a++) middle[a] = 0.5 * (from[a] + to[a]);
    (scene.shape->side_of(middle) == side ? from : to) = middle;
  }
  WallTouch found[2];
  return scene.shape->touches(middle, 1.0e-3 * length, 1, found) > 0;
}

/* ---------------------------------------------------------------------- */

bool TMSPHWallCheck::all_behind() const
{
  bigint mine[2] = {}, all[2];    // behind, in front
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & scene.groupbit) {
      const Point body = scene.motion.to_body(candidates.position_of(i));
      mine[scene.shape->side_of(body) > 0]++;
    }
  MPI_Allreduce(mine, all, 2, MPI_LMP_BIGINT, MPI_SUM, world);
  return all[0] > 0 && all[1] == 0;
}
