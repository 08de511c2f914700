/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Where particles touch a wall, and the forces that hold them there. Shapes are
   in tmsph_wall_shape.h, the laws in tmsph_contact_law.h.
------------------------------------------------------------------------- */

#include "tmsph_wall_places.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_contact_hold.h"
#include "tmsph_last_force.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <optional>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Totals = TMSPHContactTotals;

// a particle that just touches, but for round-off, is not held, and nothing of it is remembered;
// gap in half cells: round-off

static constexpr double JUST_TOUCHES = 1.0e-9;

/* ---------------------------------------------------------------------- */

static double dot(const Point &a, const Point &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ----------------------------------------------------------------------
   anchors, side, force, stamp, the anchors
------------------------------------------------------------------------- */

int TMSPHWallMemory::pack(double *buf) const
{
  double *p = buf;
  *p++ = ubuf(count).d;
  *p++ = ubuf(side).d;
  p = std::copy_n(force, 3, p);
  *p++ = ubuf((int64_t) stamp).d;
  for (int n = 0; n < count; n++) {
    *p++ = ubuf(anchors[n].piece).d;
    p = std::copy_n(anchors[n].point.data(), 3, p);
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

int TMSPHWallMemory::unpack(const double *buf)
{
  const double *p = buf;
  const auto take = [&p](double *to) {
    std::copy_n(p, 3, to);
    p += 3;
  };
  count = (int) ubuf(*p++).i;
  side = (int) ubuf(*p++).i;
  take(force);
  stamp = (std::uint64_t) ubuf(*p++).i;
  for (int n = 0; n < count; n++) {
    anchors[n].piece = (int) ubuf(*p++).i;
    take(anchors[n].point.data());
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallPlaces::init()
{
  prescribing = TMSPHLastForce::prescribing(lmp);
}

/* ---------------------------------------------------------------------- */

void TMSPHWallPlaces::find(double dt)
{
  touching.clear();
  std::optional<TMSPHLastForce::Prescribed> prescribed;
  if (dt > 0.0) prescribed.emplace(lmp, prescribing);
  const auto &images = candidates.images;
  for (size_t n = 0; n < images.size();) {
    const int i = images[n].i;
    Touching t, other;
    t.places = 0;
    for (; n < images.size() && images[n].i == i; n++)
      if (touch(images[n], other) && (t.places == 0 || nearer(other.place[0], t.place[0])))
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

bool TMSPHWallPlaces::touch(const TMSPHWallCandidates::Candidate &c, Touching &t) const
{
  const double *x = atom->x[c.i];
  t.i = c.i;
  for (int k = 0; k < 3; k++) t.x[k] = x[k] + c.shift[k];
  if (domain->dimension == 2) t.x[2] = 0.0;
  const Point body = scene.motion.to_body(t.x);
  const TMSPHWallMemory *memory = memories.find(atom->tag[c.i]);
  t.side = !scene.both_sides ? 1 : memory ? memory->side : scene.shape->side_of(body);
  t.places = scene.shape->touches(body, TMSPHWallScene::REACH * scene.gap(c.i), t.side, t.place);
  return t.places > 0;
}

/* ---------------------------------------------------------------------- */

double TMSPHWallPlaces::stiffness(int i, double penetration, double dt) const
{
  const HalfCell cell = {plane_modulus(scene.pair->elastic(i)), scene.pair->bonds()->spacing(i)};
  const double spring =
      half_cells(&cell, 1, scene.stiffness, penetration) * atom->vfrac[i] / cell.spacing;
  return scene.law.stiffness(spring, scene.stiffness, atom->rmass[i], dt);
}

/* ---------------------------------------------------------------------- */

void TMSPHWallPlaces::predict(Touching &t, double dt) const
{
  const int i = t.i;
  const double ahead = scene.law.ahead(dt), gap = scene.gap(i);
  const Point v = scene.motion.velocity_at(t.x);
  double deepest = -gap;
  for (int a = 0; a < 3; a++) t.a[a] = atom->f[i][a] / atom->rmass[i] - drive.acceleration(a);
  for (int p = 0; p < t.places; p++) {
    t.place[p].normal = scene.motion.turned(t.place[p].normal);
    t.penetration[p] = t.predicted[p] = gap - t.place[p].gap;
    deepest = std::max(deepest, t.penetration[p]);
    for (int a = 0; a < 3; a++)
      t.predicted[p] -= t.place[p].normal[a] * ahead * (atom->v[i][a] - v[a] + ahead * t.a[a]);
  }
  t.stiffness = stiffness(i, deepest, dt > 0.0 ? dt : update->dt);
}

/* ---------------------------------------------------------------------- */

std::vector<double> TMSPHWallPlaces::stiffnesses() const
{
  std::vector<double> all;
  for (const Touching &t : touching)
    if (t.predicted[0] > 0.0 || (t.places == 2 && t.predicted[1] > 0.0)) all.push_back(t.stiffness);
  return all;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallPlaces::hold(double dt, double dragged)
{
  for (const Touching &t : touching) hold_one(t, dt, dragged);
}

/* ---------------------------------------------------------------------- */

void TMSPHWallPlaces::hold_one(const Touching &t, double dt, double dragged)
{
  const int i = t.i;
  const double m = atom->rmass[i], k = t.stiffness;
  const double ahead = scene.law.ahead(dt);
  const double q = ahead * ahead * k / m + dragged;

  double normal[2] = {}, closing[2] = {};
  if (scene.law.damping > 0.0 && dt > 0.0) {
    const Point wall = scene.motion.velocity_at(t.x);
    for (int p = 0; p < t.places; p++)
      for (int a = 0; a < 3; a++) closing[p] -= t.place[p].normal[a] * (atom->v[i][a] - wall[a]);
  }
  const double cosine = t.places == 2 ? dot(t.place[0].normal, t.place[1].normal) : 0.0;
  hold_across(scene.law, k, q, k / m, t.places, cosine, t.predicted, closing, normal);

  const double least = JUST_TOUCHES * scene.gap(i);
  bool held = false;
  for (int p = 0; p < t.places; p++)
    held = held || std::max(t.penetration[p], t.predicted[p]) > least;
  if (!held) {
    memories.erase(atom->tag[i]);
    return;
  }

  TMSPHWallMemory &memory = memories.of(atom->tag[i]);
  if (memory.side == 0) memory.side = t.side;
  Anchor anchors[2];
  char taken[2] = {};
  Point pushed = {0.0, 0.0, 0.0}, force = {0.0, 0.0, 0.0};
  for (int p = 0; p < t.places; p++)
    for (int a = 0; a < 3; a++) pushed[a] += normal[p] * t.place[p].normal[a];
  for (int p = 0; p < t.places; p++) {
    const int which = anchor_for(memory.count, taken, t.places, [&](int n) {
      return memory.anchors[n].piece == t.place[p].piece;
    });
    anchors[p] = {t.place[p].piece, scene.motion.to_body(t.x)};
    if (which >= 0) {
      taken[which] = 1;
      anchors[p].point = moved_along(t, memory.anchors[which].point);
    }
    const Point exerted = rub(t, p, ahead, q, normal[p], pushed, anchors[p]);
    for (int a = 0; a < 3; a++) force[a] += exerted[a];
  }
  totals[Totals::TOUCHING] += 1.0;
  memory.count = t.places;
  std::copy_n(anchors, t.places, memory.anchors);
  for (int a = 0; a < 3; a++) {
    memory.force[a] = force[a];
    atom->f[i][a] += force[a];
  }
}

/* ----------------------------------------------------------------------
   an anchor goes with the particle from one piece to the next, and from one image to another
------------------------------------------------------------------------- */

Point TMSPHWallPlaces::moved_along(const Touching &t, const Point &anchor) const
{
  Point origin = scene.motion.to_space(anchor);
  candidates.to_image_near(t.x, origin);
  return scene.motion.to_body(origin);
}

/* ----------------------------------------------------------------------
   friction at place p
   @param pushed force by all places along their normals
   @param anchor goes along if the particle slides
   @return       force of this place on the particle
------------------------------------------------------------------------- */

Point TMSPHWallPlaces::rub(const Touching &t, int p, double ahead, double q, double normal,
                           const Point &pushed, Anchor &anchor)
{
  const int i = t.i;
  const WallTouch &place = t.place[p];
  const double m = atom->rmass[i], k = t.stiffness;
  const Point wall = scene.motion.velocity_at(t.x), origin = scene.motion.to_space(anchor.point);
  Point slip = {};
  for (int a = 0; a < domain->dimension; a++) {
    slip[a] =
        t.x[a] - origin[a] + ahead * (atom->v[i][a] - wall[a] + ahead * (t.a[a] + pushed[a] / m));
  }
  const double along = dot(slip, place.normal);
  for (int a = 0; a < 3; a++) slip[a] -= along * place.normal[a];
  const double kt = scene.law.shear_ratio(TANGENTIAL) * k;
  const Friction<3> friction = hold_along<3>(kt, q * kt / k, scene.friction * normal, slip.data());
  Point moved;
  for (int a = 0; a < 3; a++) moved[a] = origin[a] + friction.excess[a];
  anchor.point = scene.motion.to_body(moved);
  totals.add_place(friction.work, t.penetration[p], held_energy<3>(k, kt, normal, friction.force));

  const Point centre = scene.motion.centre();
  Point arm, force;
  for (int a = 0; a < 3; a++) {
    arm[a] = t.x[a] - place.gap * place.normal[a] - (scene.turns ? centre[a] : 0.0);
    force[a] = normal * place.normal[a] - friction.force[a];
  }
  for (int a = 0; a < 3; a++) {
    totals[Totals::FORCE + a] -= force[a];
    totals[Totals::TORQUE + a] -=
        arm[(a + 1) % 3] * force[(a + 2) % 3] - arm[(a + 2) % 3] * force[(a + 1) % 3];
  }
  return force;
}

/* ---------------------------------------------------------------------- */

std::vector<Point> TMSPHWallPlaces::forces() const
{
  std::vector<Point> all;
  for (const Touching &t : touching)
    if (const TMSPHWallMemory *memory = memories.find(atom->tag[t.i]))
      all.push_back({memory->force[0], memory->force[1], memory->force[2]});
  return all;
}

/* ---------------------------------------------------------------------- */

double TMSPHWallPlaces::overlap(double tolerance) const
{
  double deepest = 0.0;
  for (const Touching &t : touching)
    for (int p = 0; p < t.places; p++)
      if (t.penetration[p] > tolerance * scene.gap(t.i))
        deepest = std::max(deepest, t.penetration[p]);
  return deepest;
}
