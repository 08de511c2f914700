/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which particles, or images of them, may touch a wall, and where they do.
------------------------------------------------------------------------- */

#include "fix_tmsph_wall.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "neighbor.h"
#include "pair_tmsph.h"
#include "tmsph_last_force.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <optional>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ----------------------------------------------------------------------
   In a periodic direction a wall is there once in each period, or goes on without end if it spans
   one. A longer one is there as it is given.
------------------------------------------------------------------------- */

void FixTMSPHWall::find_periods()
{
  Bounds bounds = shape->bounds();
  double square = 0.0;
  for (int k = 0; k < 3; k++) {
    middle[k] = std::isfinite(bounds.length(k)) ? 0.5 * (bounds.low[k] + bounds.high[k]) : 0.0;
    square += bounds.length(k) * bounds.length(k);
  }
  for (int k = 0; k < 3 && turns; k++) {    // at any angle
    bounds.low[k] = middle[k] - 0.5 * std::sqrt(square);
    bounds.high[k] = middle[k] + 0.5 * std::sqrt(square);
  }
  for (int k = 0; k < domain->dimension; k++) {
    const double length = domain->periodicity[k] ? domain->prd[k] : 0.0;
    const bool endless = shape->goes_on(k, turns ? 0.0 : length);
    repeats[k] = !endless && bounds.repeats(k, length);
    if (endless || repeats[k] || length == 0.0 || warned || comm->me) continue;
    error->warning(FLERR,
                   "Wall {} is longer than the periodic box in {} and is there only as it is "
                   "given: particles that cross this boundary come to another part of it; make the "
                   "boundary non-periodic, or let the wall end one period from where it starts",
                   id, "xyz"[k]);
  }
  warned = true;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::list_candidates()
{
  const bool moved = version != pair->bonds()->layout_version();
  double nearest = HUGE_VAL;
  version = pair->bonds()->layout_version();
  candidates.clear();
  travel = skin = farthest = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) skin = std::max(skin, 2.0 * gap_of(i));
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) list_images(i, (1.0 + REACH) * gap_of(i) + skin, nearest);
  for (auto m = memories.begin(); m != memories.end();) {    // of particles that are gone
    const int i = atom->map(m->first);
    const bool here = i >= 0 && i < atom->nlocal && (atom->mask[i] & groupbit);
    m = here ? std::next(m) : memories.erase(m);
  }
  if (moved) measure_clearance(nearest);
}

/* ----------------------------------------------------------------------
   How near particles are to the reach of the wall, after an exchange of them, and how far from its
   pivot (collective). Until the next one the wall covers its way.
------------------------------------------------------------------------- */

void FixTMSPHWall::measure_clearance(double nearest)
{
  const double mine[2] = {-nearest, farthest};
  double all[2];
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MAX, world);
  clearance = -all[0];
  radius = all[1] + neighbor->skin;
  way = 0.0;
}

/* ----------------------------------------------------------------------
   Before particles have moved half of LAMMPS's skin they are exchanged, if it looks at each step;
   the other half is to spare.
------------------------------------------------------------------------- */

bool FixTMSPHWall::may_press() const
{
  const bool bounded = neighbor->every == 1 && neighbor->delay == 0 && neighbor->dist_check &&
      !neighbor->build_once && !neighbor->includegroup;
  return !bounded || clearance < way + neighbor->skin;
}

/* ----------------------------------------------------------------------
   of the image that is nearest to the middle of the wall; in 2-D in its plane
------------------------------------------------------------------------- */

Point FixTMSPHWall::position_of(int i) const
{
  const double *x = atom->x[i];
  Point near = {x[0], x[1], domain->dimension == 3 ? x[2] : 0.0};
  const Point wall = motion.to_space(middle);
  for (int k = 0; k < 3; k++)
    if (repeats[k])
      near[k] += domain->prd[k] * std::round((wall[k] - near[k]) / domain->prd[k]);
  return near;
}

/* ----------------------------------------------------------------------
   @param within  distance from the wall
   @param nearest of a particle to the reach of the wall if it were twice as large as it is cold
------------------------------------------------------------------------- */

void FixTMSPHWall::list_images(int i, double within, double &nearest)
{
  const double reach = REACH * pair->bonds()->spacing(i);
  const Point near = position_of(i), centre = motion.centre();
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
        const double distance = shape->distance(motion.to_body(image));
        nearest = std::min(nearest, distance - reach);
        if (distance < within) candidates.push_back({i, shift});
      }
}

/* ----------------------------------------------------------------------
   no particle has come nearer than the sum of the largest steps so far
------------------------------------------------------------------------- */

void FixTMSPHWall::follow()
{
  double square = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *v = atom->v[i];
    square = std::max(square, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  travel += update->dt * std::sqrt(square);
  if (version == pair->bonds()->layout_version() && travel < skin) return;
  list_candidates();
}

/* ----------------------------------------------------------------------
   takes point p to its periodic image that is nearest to x
------------------------------------------------------------------------- */

void FixTMSPHWall::to_image_near(const Point &x, Point &p) const
{
  for (int k = 0; k < domain->dimension; k++)
    if (domain->periodicity[k])
      p[k] += domain->prd[k] * std::round((x[k] - p[k]) / domain->prd[k]);
}

/* ----------------------------------------------------------------------
   where the candidates touch, and how deep they would be at the end of the step
   without contact; dt = 0: as they are
------------------------------------------------------------------------- */

void FixTMSPHWall::find_touching(double dt)
{
  touching.clear();
  std::optional<TMSPHLastForce::Prescribed> prescribed;
  if (dt > 0.0) prescribed.emplace(lmp, prescribing);
  for (size_t n = 0; n < candidates.size();) {
    const int i = candidates[n].i;
    Touching t, other;
    t.places = 0;
    for (; n < candidates.size() && candidates[n].i == i; n++)
      if (touch(candidates[n], other) && (t.places == 0 || nearer(other.place[0], t.place[0])))
        t = other;
    if (t.places == 0) {
      memories.erase(atom->tag[i]);
      continue;
    }
    predict(t, dt);
    touching.push_back(t);
  }
}

/* ----------------------------------------------------------------------
   @return false if it does not reach
------------------------------------------------------------------------- */

bool FixTMSPHWall::touch(const Candidate &c, Touching &t) const
{
  const double *x = atom->x[c.i];
  t.i = c.i;
  for (int k = 0; k < 3; k++) t.x[k] = x[k] + c.shift[k];
  if (domain->dimension == 2) t.x[2] = 0.0;
  const Point body = motion.to_body(t.x);
  const auto found = memories.find(atom->tag[c.i]);
  t.side = !both_sides ? 1 : found != memories.end() ? found->second.side : shape->side_of(body);
  t.places = shape->touches(body, REACH * gap_of(c.i), t.side, t.place);
  return t.places > 0;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::predict(Touching &t, double dt) const
{
  const int i = t.i;
  const double ahead = law.ahead(dt), gap = gap_of(i);
  const Point v = motion.velocity_at(t.x);
  double deepest = -gap;
  for (int a = 0; a < 3; a++)
    t.a[a] = atom->f[i][a] / atom->rmass[i] - (is_free[a] ? load[a].value / mass : 0.0);
  for (int p = 0; p < t.places; p++) {
    t.place[p].normal = motion.turned(t.place[p].normal);
    t.penetration[p] = t.predicted[p] = gap - t.place[p].gap;
    deepest = std::max(deepest, t.penetration[p]);
    for (int a = 0; a < 3; a++)
      t.predicted[p] -=
          t.place[p].normal[a] * ahead * (atom->v[i][a] - v[a] + ahead * t.a[a]);
  }
  t.stiffness = stiffness_of(i, deepest, dt > 0.0 ? dt : update->dt);
}
