/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Forces and movement of a rigid wall. Shapes are in tmsph_wall_shape.h, the
   laws in tmsph_contact_law.h.
------------------------------------------------------------------------- */

#include "fix_tmsph_wall.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "input.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_last_force.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// a particle that just touches, but for round-off, is not held, and nothing of it is remembered;
// gap in half cells

static constexpr double JUST_TOUCHES = 1.0e-9;

/* ---------------------------------------------------------------------- */

static double dot(const Point &a, const Point &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ----------------------------------------------------------------------
   A sum that does not depend on how the terms are spread over processors: they
   are rounded to whole numbers of a quantum below 1e-12 of the largest.
------------------------------------------------------------------------- */

static void sum_in_any_order(const std::vector<Point> &terms, Point &sum, MPI_Comm world)
{
  double largest = 0.0, largest_of_all;
  for (const Point &t : terms)
    for (double value : t) largest = std::max(largest, std::fabs(value));
  MPI_Allreduce(&largest, &largest_of_all, 1, MPI_DOUBLE, MPI_MAX, world);
  const double quantum = std::ldexp(std::max(largest_of_all, 1.0e-280), -40);
  int64_t counted[3] = {}, all[3];
  for (const Point &t : terms)
    for (int a = 0; a < 3; a++) counted[a] += std::llround(t[a] / quantum);
  MPI_Allreduce(counted, all, 3, MPI_LL, MPI_SUM, world);
  for (int a = 0; a < 3; a++) sum[a] = all[a] * quantum;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHWall::evaluate(Input &input)
{
  if (input.index < 0) return input.value;
  input.value = this->input->variable->compute_equal(input.index);
  if (!std::isfinite(input.value))
    error->all(FLERR, "Variable {} of fix tmsph/wall {} is {} on step {}", input.variable, id,
               input.value, update->ntimestep);
  return input.value;
}

/* ----------------------------------------------------------------------
   velocities of directions that are not free, at the present time
------------------------------------------------------------------------- */

void FixTMSPHWall::evaluate_inputs()
{
  if (varies) modify->clearstep_compute();
  for (int a = 0; a < 3; a++) {
    if (is_free[a])
      evaluate(load[a]);
    else
      motion.velocity[a] = evaluate(velocity[a]);
  }
  motion.spin = evaluate(spin);
  if (varies) modify->addstep_compute(update->ntimestep + 1);
}

/* ----------------------------------------------------------------------
   to the present step: prescribed velocities by the trapezoidal rule, the
   velocity of free directions is that of half a step before
------------------------------------------------------------------------- */

void FixTMSPHWall::move(double duration)
{
  const RigidMotion before = motion;
  evaluate_inputs();
  for (int a = 0; a < 3; a++)
    motion.shift[a] += duration * (is_free[a] ? motion.velocity[a]
                                              : 0.5 * (before.velocity[a] + motion.velocity[a]));
  motion.angle += duration * 0.5 * (before.spin + motion.spin);
  const Point &v = before.velocity, &w = motion.velocity;
  const double speed = std::sqrt(std::max(dot(v, v), dot(w, w)));
  const double turn = std::max(std::fabs(before.spin), std::fabs(motion.spin));
  travel += duration * (speed + turn * (farthest + travel));
  way += duration * (speed + turn * (radius + way));
}

/* ---------------------------------------------------------------------- */

double FixTMSPHWall::speed() const
{
  return std::sqrt(dot(motion.velocity, motion.velocity)) + std::fabs(motion.spin) * farthest;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHWall::gap_of(int i) const
{
  return 0.5 * pair->bonds()->spacing(i) * (1.0 + pair->thermal_strain(i));
}

/* ---------------------------------------------------------------------- */

double FixTMSPHWall::stiffness_of(int i, double penetration, double dt) const
{
  const HalfCell cell = {plane_modulus(pair->elastic(i)), pair->bonds()->spacing(i)};
  const double spring =
      half_cells(&cell, 1, stiffness, penetration) * atom->vfrac[i] / cell.spacing;
  return law.stiffness(spring, stiffness, atom->rmass[i], dt);
}

/* ----------------------------------------------------------------------
   the force on one particle
   @param dragged dt^2/mass of the wall times the stiffness of all that touch it
------------------------------------------------------------------------- */

void FixTMSPHWall::hold(Touching &t, double dt, double dragged)
{
  const int i = t.i;
  const double m = atom->rmass[i], k = t.stiffness;
  const double ahead = law.ahead(dt);
  const double q = ahead * ahead * k / m + dragged;
  const Point &x = t.x;
  const Point wall = motion.velocity_at(x);

  double normal[2] = {};
  if (t.places == 2)
    implicit_corner(k, q, dot(t.place[0].normal, t.place[1].normal), t.predicted, normal);
  else
    normal[0] = implicit_normal(k, q, t.predicted[0]);
  if (law.damping > 0.0 && dt > 0.0)
    for (int p = 0; p < t.places; p++) {
      double closing = 0.0;
      for (int a = 0; a < 3; a++) closing -= t.place[p].normal[a] * (atom->v[i][a] - wall[a]);
      if (t.penetration[p] > 0.0)
        normal[p] = law.normal(normal[p], k, k / m, closing);
    }

  const double least = JUST_TOUCHES * gap_of(i);
  bool held = false;
  for (int p = 0; p < t.places; p++)
    held = held || std::max(t.penetration[p], t.predicted[p]) > least;
  if (!held) {
    memories.erase(atom->tag[i]);
    return;
  }

  Memory &memory = memories[atom->tag[i]];
  if (memory.side == 0) memory.side = t.side;
  Anchor anchors[2];
  bool taken[2] = {false, false};
  Point force = {0.0, 0.0, 0.0};
  for (int p = 0; p < t.places; p++)
    for (int a = 0; a < 3; a++) force[a] += normal[p] * t.place[p].normal[a];

  for (int p = 0; p < t.places; p++) {
    const WallTouch &place = t.place[p];

    // an anchor goes with the particle from one piece to the next

    int which = -1;
    for (int n = 0; n < memory.count; n++)
      if (!taken[n] && (memory.anchors[n].piece == place.piece ||
                        (which < 0 && t.places == 1)))
        which = n;
    anchors[p] = {place.piece, motion.to_body(x)};
    if (which >= 0) {
      taken[which] = true;
      Point origin = motion.to_space(memory.anchors[which].point);
      to_image_near(x, origin);
      anchors[p].point = motion.to_body(origin);
    }
    const Point origin = motion.to_space(anchors[p].point);

    Point slip = {};
    for (int a = 0; a < domain->dimension; a++) {
      slip[a] = x[a] - origin[a] +
          ahead * (atom->v[i][a] - wall[a] + ahead * (t.a[a] + force[a] / m));
    }
    const double along = dot(slip, place.normal);
    for (int a = 0; a < 3; a++) slip[a] -= along * place.normal[a];
    const double kt = law.shear_ratio(TANGENTIAL) * k;
    Point rubbing, excess, moved;
    implicit_friction<3>(kt, q * kt / k, friction * normal[p], slip.data(), rubbing.data(),
                         excess.data());
    for (int a = 0; a < 3; a++) moved[a] = origin[a] + excess[a];
    anchors[p].point = motion.to_body(moved);

    totals[WORK] += dot(rubbing, excess);
    totals[DEEPEST] = std::max(totals[DEEPEST], t.penetration[p]);
    energy += 0.5 * normal[p] * normal[p] / k + 0.5 * dot(rubbing, rubbing) / kt;
    const Point centre = motion.centre();
    Point arm, share;
    for (int a = 0; a < 3; a++) {
      arm[a] = x[a] - place.gap * place.normal[a] - (turns ? centre[a] : 0.0);
      share[a] = normal[p] * place.normal[a] - rubbing[a];
      memory.force[a] = (p > 0 ? memory.force[a] : 0.0) + share[a];
    }
    for (int a = 0; a < 3; a++) {
      totals[FORCE + a] -= share[a];
      totals[TORQUE + a] -= arm[(a + 1) % 3] * share[(a + 2) % 3] -
          arm[(a + 2) % 3] * share[(a + 1) % 3];
    }
  }
  totals[TOUCHES] += 1.0;
  memory.count = t.places;
  std::copy_n(anchors, t.places, memory.anchors);
  for (int a = 0; a < 3; a++) atom->f[i][a] += memory.force[a];
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::act(double dt)
{
  const double work = totals[WORK];
  std::fill(totals, totals + NTOTALS, 0.0);
  totals[WORK] = work;
  energy = 0.0;
  find_touching(dt);
  double dragged = 0.0;
  if (mass > 0.0 && law.predicts) {
    std::vector<Point> stiff;
    for (const Touching &t : touching)
      if (t.predicted[0] > 0.0 || (t.places == 2 && t.predicted[1] > 0.0))
        stiff.push_back({t.stiffness, 0.0, 0.0});
    Point sum;
    sum_in_any_order(stiff, sum, world);
    dragged = dt * dt * sum[0] / mass;
  }
  for (Touching &t : touching) hold(t, dt, dragged);
  if (mass > 0.0) drive(dt);
}

/* ----------------------------------------------------------------------
   the wall itself, in its free directions
------------------------------------------------------------------------- */

void FixTMSPHWall::drive(double dt)
{
  std::vector<Point> forces;
  for (const Touching &t : touching) {
    const auto found = memories.find(atom->tag[t.i]);
    if (found == memories.end()) continue;
    const double *f = found->second.force;
    forces.push_back({f[0], f[1], f[2]});
  }
  Point sum;
  sum_in_any_order(forces, sum, world);
  for (int a = 0; a < 3; a++)
    if (is_free[a]) motion.velocity[a] += dt * (load[a].value - sum[a]) / mass;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::setup(int)
{
  if (!started) evaluate_inputs();
  list_candidates();
  if (started && TMSPHLastForce::untouched(lmp, memories)) {
    for (int i = 0; i < atom->nlocal; i++) {
      const auto found = memories.find(atom->tag[i]);
      if (found == memories.end()) continue;
      for (int a = 0; a < 3; a++) atom->f[i][a] += found->second.force[a];
    }
    return;
  }
  act(0.0);
  if (!started) check_place();
  started = true;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::post_force(int)
{
  move(update->dt);
  follow();
  act(update->dt);
}

/* ----------------------------------------------------------------------
   equilibrium is looked for: the wall stands still, nothing is predicted
------------------------------------------------------------------------- */

void FixTMSPHWall::min_setup(int vflag)
{
  min_post_force(vflag);
}

void FixTMSPHWall::min_post_force(int)
{
  if (!started) evaluate_inputs();
  list_candidates();
  act(0.0);
  if (!started) check_place();
  started = true;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::post_run()
{
  TMSPHLastForce::stamp(lmp, memories);
}

/* ----------------------------------------------------------------------
   energy stored in the contacts
------------------------------------------------------------------------- */

double FixTMSPHWall::compute_scalar()
{
  double all;
  MPI_Allreduce(&energy, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   1-3 force on the wall, 4-6 torque on it, 7 work lost by friction so far, 8
   particles that touch, 9 deepest penetration, 10-12 displacement, 13 angle
------------------------------------------------------------------------- */

double FixTMSPHWall::compute_vector(int n)
{
  if (n == ANGLE) return motion.angle;
  if (n >= DISPLACEMENT) return motion.shift[n - DISPLACEMENT];
  double all;
  MPI_Allreduce(&totals[n], &all, 1, MPI_DOUBLE, n == DEEPEST ? MPI_MAX : MPI_SUM, world);
  return all;
}
