/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What moves a wall.
------------------------------------------------------------------------- */

#include "tmsph_wall_drive.h"

#include "domain.h"
#include "error.h"
#include "input.h"
#include "modify.h"
#include "tmsph_collective.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

static double dot(const Point &a, const Point &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---------------------------------------------------------------------- */

std::vector<TMSPHWord> TMSPHWallDrive::words()
{
  const bool flat = domain->dimension == 2;
  return {{"velocity", flat ? "vx vy" : "vx vy vz",
           [this](TMSPHValues &v) {
             for (int a = 0; a < domain->dimension; a++) velocity[a] = number_or_variable(v);
           }},
          {"rotation", flat ? "px py omega" : "px py pz ax ay az omega",
           [this](TMSPHValues &v) { read_rotation(v); }},
          {"load", flat ? "fx fy mass M" : "fx fy fz mass M",
           [this](TMSPHValues &v) { read_load(v); }}};
}

/* ---------------------------------------------------------------------- */

TMSPHWallDrive::Given TMSPHWallDrive::number_or_variable(TMSPHValues &values)
{
  Given given;
  if (!values.variable(given.variable)) given.value = values.number();
  return given;
}

/* ----------------------------------------------------------------------
   pivot, in 3-D axis, angular velocity
------------------------------------------------------------------------- */

void TMSPHWallDrive::read_rotation(TMSPHValues &values)
{
  RigidMotion &motion = scene.motion;
  scene.turns = true;
  for (int a = 0; a < domain->dimension; a++) motion.pivot[a] = values.number();
  if (domain->dimension == 3) {
    for (double &component : motion.axis) component = values.number();
    const double length = std::sqrt(dot(motion.axis, motion.axis));
    if (!(length > 0.0)) error->all(FLERR, "The axis of fix tmsph/wall rotation has no length");
    for (double &component : motion.axis) component /= length;
  }
  spin = number_or_variable(values);
}

/* ----------------------------------------------------------------------
   a force or NULL in each direction, mass M
------------------------------------------------------------------------- */

void TMSPHWallDrive::read_load(TMSPHValues &values)
{
  bool any = false;
  for (int a = 0; a < domain->dimension; a++) {
    is_free[a] = !values.word("NULL");
    any = any || is_free[a];
    if (is_free[a]) load[a] = number_or_variable(values);
  }
  if (!any)
    error->all(FLERR,
               "All components of fix tmsph/wall load are NULL: give the force of at "
               "least one direction");
  if (!values.word("mass"))
    error->all(FLERR,
               "Fix tmsph/wall load needs the mass of the wall after its {} components, "
               "not '{}'",
               domain->dimension, *values.rest());
  mass = values.number();
  if (!(mass > 0.0)) values.reject(fmt::format("mass {}", values.rest()[-1]), "must be positive");
}

/* ---------------------------------------------------------------------- */

void TMSPHWallDrive::init()
{
  varies = false;
  for (Given *given : {velocity, velocity + 1, velocity + 2, load, load + 1, load + 2, &spin}) {
    if (given->variable.empty()) continue;
    given->index = input->variable->find(given->variable.c_str());
    if (given->index < 0)
      error->all(FLERR, "Variable {} of fix tmsph/wall does not exist: define it first",
                 given->variable);
    if (!input->variable->equalstyle(given->index))
      error->all(FLERR, "Variable {} of fix tmsph/wall must be of equal style", given->variable);
    varies = true;
  }
}

/* ---------------------------------------------------------------------- */

double TMSPHWallDrive::value_of(Given &given)
{
  if (given.index < 0) return given.value;
  given.value = input->variable->compute_equal(given.index);
  if (!std::isfinite(given.value))
    error->all(FLERR, "Variable {} of fix tmsph/wall {} is {} on step {}", given.variable, scene.id,
               given.value, update->ntimestep);
  return given.value;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallDrive::evaluate()
{
  if (varies) modify->clearstep_compute();
  for (int a = 0; a < 3; a++) {
    if (is_free[a])
      value_of(load[a]);
    else
      scene.motion.velocity[a] = value_of(velocity[a]);
  }
  scene.motion.spin = value_of(spin);
  if (varies) modify->addstep_compute(update->ntimestep + 1);
}

/* ---------------------------------------------------------------------- */

std::pair<double, double> TMSPHWallDrive::move(double duration)
{
  RigidMotion &motion = scene.motion;
  const RigidMotion before = motion;
  evaluate();
  for (int a = 0; a < 3; a++)
    motion.shift[a] += duration *
        (is_free[a] ? motion.velocity[a] : 0.5 * (before.velocity[a] + motion.velocity[a]));
  motion.angle += duration * 0.5 * (before.spin + motion.spin);
  const Point &v = before.velocity, &w = motion.velocity;
  return {std::sqrt(std::max(dot(v, v), dot(w, w))),
          std::max(std::fabs(before.spin), std::fabs(motion.spin))};
}

/* ---------------------------------------------------------------------- */

double TMSPHWallDrive::dragged(const std::vector<double> &stiffnesses, double dt) const
{
  return dt * dt * fixed_point_sum(stiffnesses, world) / mass;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallDrive::push(const std::vector<Point> &forces, double dt)
{
  const Point sum = fixed_point_sum(forces, world);
  for (int a = 0; a < 3; a++)
    if (is_free[a]) scene.motion.velocity[a] += dt * (load[a].value - sum[a]) / mass;
}

/* ---------------------------------------------------------------------- */

std::vector<double> TMSPHWallDrive::loads() const
{
  return {load[0].value, load[1].value, load[2].value};
}

/* ----------------------------------------------------------------------
   numbers are those of the input
------------------------------------------------------------------------- */

void TMSPHWallDrive::take_loads(const double *values)
{
  for (int a = 0; a < 3; a++)
    if (!load[a].variable.empty()) load[a].value = values[a];
}
