/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which particles, or images of them, may touch a wall.
------------------------------------------------------------------------- */

#include "tmsph_wall_candidates.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void TMSPHWallCandidates::init()
{
  watch.forget();
  find_periods();
}

/* ----------------------------------------------------------------------
   In a periodic direction a wall is there once in each period, or goes on without end if it spans
   one. A longer one is there as it is given.
------------------------------------------------------------------------- */

void TMSPHWallCandidates::find_periods()
{
  Bounds bounds = scene.shape->bounds();
  double square = 0.0;
  for (int k = 0; k < 3; k++) {
    middle[k] = std::isfinite(bounds.length(k)) ? 0.5 * (bounds.low[k] + bounds.high[k]) : 0.0;
    square += bounds.length(k) * bounds.length(k);
  }
  for (int k = 0; k < 3 && scene.turns; k++) {    // at any angle
    bounds.low[k] = middle[k] - 0.5 * std::sqrt(square);
    bounds.high[k] = middle[k] + 0.5 * std::sqrt(square);
  }
  for (int k = 0; k < domain->dimension; k++) {
    const double length = domain->periodicity[k] ? domain->prd[k] : 0.0;
    const bool endless = scene.shape->goes_on(k, scene.turns ? 0.0 : length);
    repeats[k] = !endless && bounds.repeats(k, length);
    if (endless || repeats[k] || length == 0.0 || warned || comm->me) continue;
    error->warning(FLERR,
                   "Wall {} is longer than the periodic box in {} and is there only as it is "
                   "given: particles that cross this boundary come to another part of it; make the "
                   "boundary non-periodic, or let the wall end one period from where it starts",
                   scene.id, "xyz"[k]);
  }
  warned = true;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallCandidates::list()
{
  const FixTMSPHBond &bonds = *scene.pair->bonds();
  const bool exchanged = watch.laid_out_anew(bonds);
  double nearest = HUGE_VAL;
  watch.see(bonds);
  images.clear();
  travel = skin = farthest = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & scene.groupbit) skin = std::max(skin, 2.0 * scene.gap(i));
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & scene.groupbit)
      list_images(i, (1.0 + TMSPHWallScene::REACH) * scene.gap(i) + skin, nearest);
  if (exchanged) measure_clearance(nearest);
}

/* ----------------------------------------------------------------------
   How near particles are to the reach of the wall, after an exchange of them, and how far from its
   pivot (collective). Until the next one the wall covers its way.
------------------------------------------------------------------------- */

void TMSPHWallCandidates::measure_clearance(double nearest)
{
  const double mine[2] = {-nearest, farthest};
  double largest[2];
  MPI_Allreduce(mine, largest, 2, MPI_DOUBLE, MPI_MAX, world);
  clearance = -largest[0];
  radius = largest[1] + neighbor->skin;
  way = 0.0;
}

/* ----------------------------------------------------------------------
   Before particles have moved half of LAMMPS's skin they are exchanged, if it looks at each step;
   the other half is to spare.
------------------------------------------------------------------------- */

bool TMSPHWallCandidates::may_touch() const
{
  const bool bounded = neighbor->every == 1 && neighbor->delay == 0 && neighbor->dist_check &&
      !neighbor->build_once && !neighbor->includegroup;
  return !bounded || clearance < way + neighbor->skin;
}

/* ---------------------------------------------------------------------- */

Point TMSPHWallCandidates::position_of(int i) const
{
  const double *x = atom->x[i];
  Point near = {x[0], x[1], domain->dimension == 3 ? x[2] : 0.0};
  const Point wall = scene.motion.to_space(middle);
  for (int k = 0; k < 3; k++)
    if (repeats[k]) near[k] += domain->prd[k] * std::round((wall[k] - near[k]) / domain->prd[k]);
  return near;
}

/* ----------------------------------------------------------------------
   @param within  distance from the wall
   @param nearest of a particle to the reach of the wall if it were twice as large as it is cold
------------------------------------------------------------------------- */

void TMSPHWallCandidates::list_images(int i, double within, double &nearest)
{
  const double reach = TMSPHWallScene::REACH * scene.pair->bonds()->spacing(i);
  const Point near = position_of(i), centre = scene.motion.centre();
  double square = 0.0;
  for (int k = 0; k < 3; k++) square += (near[k] - centre[k]) * (near[k] - centre[k]);
  farthest = std::max(farthest, std::sqrt(square));
  const int most[3] = {repeats[0], repeats[1], repeats[2]};
  for (int nx = -most[0]; nx <= most[0]; nx++)
    for (int ny = -most[1]; ny <= most[1]; ny++)
      for (int nz = -most[2]; nz <= most[2]; nz++) {
        const int n[3] = {nx, ny, nz};
        Point image, shift;
        for (int k = 0; k < 3; k++) {
          image[k] = near[k] + n[k] * domain->prd[k];
          shift[k] = image[k] - atom->x[i][k];
        }
        const double distance = scene.shape->distance(scene.motion.to_body(image));
        nearest = std::min(nearest, distance - reach);
        if (distance < within) images.push_back({i, shift});
      }
}

/* ----------------------------------------------------------------------
   no particle has come nearer than the sum of the largest steps so far
------------------------------------------------------------------------- */

bool TMSPHWallCandidates::outdated()
{
  double square = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    square = std::max(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  travel += update->dt * std::sqrt(square);
  return watch.laid_out_anew(*scene.pair->bonds()) || travel >= skin;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallCandidates::move(double duration, std::pair<double, double> fastest)
{
  const auto [speed, turn] = fastest;
  travel += duration * (speed + turn * (farthest + travel));
  way += duration * (speed + turn * (radius + way));
}

/* ---------------------------------------------------------------------- */

double TMSPHWallCandidates::speed() const
{
  const Point &v = scene.motion.velocity;
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) +
      std::fabs(scene.motion.spin) * farthest;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallCandidates::to_image_near(const Point &x, Point &p) const
{
  for (int k = 0; k < domain->dimension; k++)
    if (domain->periodicity[k]) p[k] += domain->prd[k] * std::round((x[k] - p[k]) / domain->prd[k]);
}
