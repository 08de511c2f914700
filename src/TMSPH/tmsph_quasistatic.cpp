/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_quasistatic.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "finish.h"
#include "fix_tmsph_bond.h"
#include "fix_tmsph_break.h"
#include "fix_tmsph_wall.h"
#include "force.h"
#include "min_tmsph_lbfgs.h"
#include "modify.h"
#include "output.h"
#include "pair_tmsph.h"
#include "timer.h"
#include "tmsph_heat_clock.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

static constexpr double JUMP = 0.98;          // of the way to the first break, since the load
                                              // factor is only nearly proportional to heating
static constexpr double STRENGTH = 2.5e-4;    // of Young's modulus, where none is given: rock with
                                              // 10 MPa and 40 GPa
static constexpr double SILENCE = 5.0;        // s without a line on the screen

/* ----------------------------------------------------------------------
   a minimizer in the place of the user's, which keeps its settings, until the end of a scope
------------------------------------------------------------------------- */

namespace {
class Stand {
 public:
  Stand(Update *place, Min *solver) :
      update(place), former(place->minimize), former_style(place->minimize_style)
  {
    update->minimize = solver;
    update->minimize_style = style;
  }
  ~Stand()
  {
    update->minimize = former;
    update->minimize_style = former_style;
  }

 private:
  Update *update;
  Min *former;
  char *former_style, style[12] = "tmsph/lbfgs";
};
}    // namespace

/* ---------------------------------------------------------------------- */

TMSPHQuasistatic::TMSPHQuasistatic(LAMMPS *lmp) :
    Command(lmp), nsteps(0), change(2.0), residual{1.0e-4, 1.0e-3}, breaking(0.8), jump(true),
    stride(0.01), evaluations(20000), pair(nullptr), rock(nullptr), solver(nullptr), unit(0.0),
    load(-1.0), load_before(-1.0), covered(0), count{0, 0, 0, 0, 0, 0, 0}, life{0, 0, 0.0, 0.0}
{
}

/* ---------------------------------------------------------------------- */

void TMSPHQuasistatic::parse(int narg, char **arg)
{
  if (narg < 1) utils::missing_cmd_args(FLERR, "tmsph/quasistatic", error);
  nsteps = utils::inumeric(FLERR, arg[0], false, lmp);
  if (nsteps < 0)
    error->all(FLERR, "Number of time steps {} of tmsph/quasistatic must not be negative", arg[0]);
  TMSPHWords(lmp, "tmsph/quasistatic",
             {{"change", "dT",
               [this](TMSPHValues &v) {
                 change = v.number(TMSPHRule::positive,
                                   "is out of range: it is a positive temperature "
                                   "difference; 2 degrees is usual");
               }},
              {"residual", "r [r2]",
               [this](TMSPHValues &v) {
                 const auto *rule =
                     "is out of range: it must be positive; 1e-4, and 1e-3 while bonds "
                     "break, is usual";
                 residual[0] = residual[1] = v.number(TMSPHRule::positive, rule);
                 if (v.number_follows()) residual[1] = v.number(TMSPHRule::positive, rule);
               }},
              {"breaking", "f",
               [this](TMSPHValues &v) {
                 breaking = v.number(
                     [](double f) { return f > 0.0 && f <= 1.0; },
                     "is out of range: it must lie above 0 and at most at 1; 0.8 is usual");
               }},
              {"jump", "yes/no", [this](TMSPHValues &v) { jump = v.logical(); }},
              {"stride", "s",
               [this](TMSPHValues &v) {
                 stride = v.number(TMSPHRule::positive,
                                   "is out of range: a wall must be allowed to move; "
                                   "0.01 spacings is usual");
               }},
              {"evaluations", "n",
               [this](TMSPHValues &v) {
                 const char *const given = v.text();
                 evaluations = utils::bnumeric(FLERR, given, false, lmp);
                 if (evaluations < 1)
                   v.reject(given,
                            "is out of range: give the most force evaluations that one equilibrium "
                            "may take");
               }}})
      .read_all(arg + 1, arg + narg);
}

/* ----------------------------------------------------------------------
   what a fix does in a step of time and not in a minimization is missing here
------------------------------------------------------------------------- */

void TMSPHQuasistatic::check_fixes()
{
  clocks.clear();
  walls.clear();
  stops.clear();
  for (const auto &fix : modify->get_fix_list()) {
    if (auto clock = dynamic_cast<TMSPHHeatClock *>(fix)) clocks.push_back(clock);
    const int mask = fix->setmask();
    const bool ours = utils::strmatch(fix->style, "^tmsph/");
    if ((mask & FixConst::END_OF_STEP) && !ours) stops.push_back(fix);
    if (utils::strmatch(fix->style, "^move"))
      error->all(FLERR,
                 "Fix {} of style {} needs steps of time, and tmsph/quasistatic has none: hold the "
                 "particles with fix setforce 0 0 0 and move them with displace_atoms between two "
                 "tmsph/quasistatic",
                 fix->id, fix->style);
    if (auto wall = dynamic_cast<FixTMSPHWall *>(fix)) {
      if (wall->loaded())
        error->all(FLERR,
                   "Fix tmsph/wall {} moves under a load, and tmsph/quasistatic has no law of "
                   "motion for it: prescribe its velocity, or use run",
                   fix->id);
      walls.push_back(wall);
    }
    if (fix->box_change & ~Fix::BOX_CHANGE_DOMAIN)
      error->all(FLERR, "Fix {} of style {} changes the box: tmsph/quasistatic cannot follow it",
                 fix->id, fix->style);
    if (!ours && !fix->time_integrate && (mask & FixConst::POST_FORCE) &&
        !(mask & FixConst::MIN_POST_FORCE) && comm->me == 0)
      error->warning(FLERR, "Fix {} of style {} does not act in tmsph/quasistatic", fix->id,
                     fix->style);
  }
  rock = FixTMSPHBreak::find(lmp);
}

/* ---------------------------------------------------------------------- */

void TMSPHQuasistatic::command(int narg, char **arg)
{
  parse(narg, arg);
  if (!domain->box_exist)
    error->all(FLERR, "Command tmsph/quasistatic before the simulation box is defined");
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Command tmsph/quasistatic needs pair style tmsph");
  if (timer->is_timeout()) return;
  check_fixes();

  MinTMSPHLBFGS lbfgs(lmp);
  Stand stand(update, &lbfgs);
  solver = &lbfgs;
  update->etol = update->ftol = 0.0;
  update->max_eval = MAXSMALLINT;
  update->whichflag = 2;
  update->nsteps = nsteps;
  update->beginstep = update->firststep = update->ntimestep;
  update->endstep = update->laststep = update->firststep + nsteps;
  if (update->laststep < 0) error->all(FLERR, "Too many time steps");

  lmp->init();
  timer->init_timeout();
  lbfgs.setup();

  // those that only average or write do so at the start of a run, but not of a minimization

  for (auto fix : stops)
    if (fix->setmask() == FixConst::END_OF_STEP) fix->setup(0);
  timer->init();
  timer->barrier_start();
  prepare();
  life.start = life.shown = platform::walltime();
  while (update->ntimestep < update->laststep) {
    if (timer->check_timeout(count.steps)) break;
    take_step(next_steps(update->laststep - update->ntimestep));
  }
  timer->barrier_stop();

  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) atom->v[i][k] = 0.0;
  lbfgs.cleanup();
  update->update_time();
  update->nsteps = count.steps;
  update->whichflag = 1;    // statistics as of a run
  Finish finish(lmp);
  finish.end(1);
  tell();

  update->whichflag = 0;
  update->firststep = update->laststep = 0;
  update->beginstep = update->endstep = 0;
}

/* ----------------------------------------------------------------------
   The residual is counted in the force that the smallest tensile strength puts on the section of a
   particle, volume over spacing. The spacing is that of as many particles as the largest family
   has, in the ball of the horizon.
------------------------------------------------------------------------- */

void TMSPHQuasistatic::prepare()
{
  double strength = HUGE_VAL;
  if (rock)
    strength = rock->rocks().tensile_strength();
  else
    for (int type = 1; type <= atom->ntypes; type++)
      strength = std::min(strength, STRENGTH * pair->material(type).young);
  double volume = 0.0, largest;
  for (int i = 0; i < atom->nlocal; i++) volume = std::max(volume, atom->vfrac[i]);
  MPI_Allreduce(&volume, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  unit = strength * largest / pair->spacing() * std::sqrt((double) atom->natoms);
}

/* ---------------------------------------------------------------------- */

bool TMSPHQuasistatic::any_broken() const
{
  return rock && rock->any_damage();
}

/* ----------------------------------------------------------------------
   steps to the next one on which something is written or averaged
------------------------------------------------------------------------- */

int TMSPHQuasistatic::next_stop(int most) const
{
  const bigint now = update->ntimestep;
  bigint next = std::min(output->next, now + most);
  for (const auto fix : stops) next = std::min(next, (now / fix->nevery + 1) * fix->nevery);
  return next - now;
}

/* ----------------------------------------------------------------------
   Until the first break the load factor grows nearly in proportion to the heating, or to time: the
   way to it is taken at once, or up to the next output. Of the two predictions the nearer one.
------------------------------------------------------------------------- */

int TMSPHQuasistatic::next_steps(int most)
{
  double allowed = change;
  most = next_stop(most);
  if (rock && load > 0.0 && load < 1.0 && !any_broken()) {
    double hottest = 0.0, all;
    for (int i = 0; i < atom->nlocal; i++) hottest = std::max(hottest, std::fabs(pair->heating(i)));
    MPI_Allreduce(&hottest, &all, 1, MPI_DOUBLE, MPI_MAX, world);
    const double heating = all * (1.0 / load - 1.0);
    const bool near = JUMP * heating < change;
    if (near)
      allowed = std::min(change, heating);
    else if (jump)
      allowed = JUMP * heating;
    if (jump && load_before >= 0.0 && load > load_before) {
      const double steps = covered * (1.0 - load) / (load - load_before);
      if (steps < most) most = std::max(1.0, near ? std::ceil(steps) : JUMP * steps);
    }
  }
  for (const auto wall : walls) {
    const double steps = stride * pair->spacing() / (wall->speed() * update->dt);
    if (steps < most) most = std::max(1.0, steps);
  }
  for (auto clock : clocks) most = std::min(most, clock->reach(most, allowed));
  for (auto clock : clocks) most = std::min(most, clock->advance(most, allowed));
  return most;
}

/* ----------------------------------------------------------------------
   While bonds break, equilibrium need not be tight: bonds that fail too early are few, since loads
   that have not arrived yet break nothing. Before the clock goes on it must be.
------------------------------------------------------------------------- */

void TMSPHQuasistatic::take_step(int steps)
{
  update->ntimestep += steps;
  count.steps++;
  if (rock) rock->begin_step();
  for (auto wall : walls) wall->move(steps * update->dt);
  const bigint next_restart = output->next_restart;
  output->next_restart = MAXBIGINT;    // or particles would change hands in each force evaluation
  load_before = load;
  extrapolate(steps);
  solver->update_forces();
  bigint &broken = life.broken;
  broken = life.equilibria = 0;
  bool first = true, tight = !rock || !any_broken();
  while (true) {
    find_equilibrium(residual[!tight]);
    if (first) note_rate(steps);
    first = false;
    if (!rock) break;
    rock->test_next(breaking);
    solver->update_forces();
    load = rock->last_test().largest;
    broken += rock->last_test().broken;
    const bool due = rock->last_test().broken > 0;
    if (tight && !due) break;
    tight = !due;
  }
  covered = steps;
  if (broken > 0 && count.broken == 0) count.first_step = update->ntimestep;
  count.broken += broken;
  if (broken > count.avalanche) {
    count.avalanche = broken;
    count.avalanche_step = update->ntimestep;
  }
  output->next_restart = next_restart;
  write_output();
}

/* ----------------------------------------------------------------------
   forget whatever a restart file does not have, and see forces as its setup does
------------------------------------------------------------------------- */

void TMSPHQuasistatic::start_afresh()
{
  solver->forget();
  std::fill_n(solver->extra_vector(RATE), 3 * (size_t) atom->nlocal, 0.0);
  load = load_before = -1.0;
  covered = 0;
  update->setupflag = 1;
  solver->update_forces();
  update->setupflag = 0;
}

/* ----------------------------------------------------------------------
   The start of the search for equilibrium: displacements grow as in the last step before its first
   bond broke. Displacements, not positions: these jump where a particle crosses the box.
------------------------------------------------------------------------- */

void TMSPHQuasistatic::extrapolate(int steps)
{
  double *before = solver->extra_vector(BEFORE);
  const double *rate = solver->extra_vector(RATE);
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) {
      before[3 * i + k] = atom->x[i][k] - pair->bonds()->reference(i)[k];
      atom->x[i][k] += steps * rate[3 * i + k];
    }
}

/* ---------------------------------------------------------------------- */

void TMSPHQuasistatic::note_rate(int steps)
{
  const double *before = solver->extra_vector(BEFORE);
  double *rate = solver->extra_vector(RATE);
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) {
      const double now = atom->x[i][k] - pair->bonds()->reference(i)[k];
      rate[3 * i + k] = (now - before[3 * i + k]) / steps;
    }
}

/* ---------------------------------------------------------------------- */

void TMSPHQuasistatic::find_equilibrium(double rms)
{
  count.equilibria++;
  life.equilibria++;
  if (solver->equilibrate(rms * unit, evaluations, [this]() { show_life(); })) return;
  const double left = solver->force_norm() / unit;    // of all processors
  if (count.failures++ == 0 && comm->me == 0)
    error->warning(FLERR,
                   "Equilibrium on step {} was not found in {} force evaluations; the "
                   "residual is {:.3g}",
                   update->ntimestep, evaluations, left);
}

/* ----------------------------------------------------------------------
   on the screen only: the log has the same lines however long they took
------------------------------------------------------------------------- */

void TMSPHQuasistatic::show_life()
{
  if (comm->me || !screen) return;
  const double now = platform::walltime();
  if (now - life.shown < SILENCE) return;
  life.shown = now;
  const bigint done = update->ntimestep - update->firststep;
  const auto left = (bigint) ((now - life.start) / done * (update->laststep - update->ntimestep));
  fputs(fmt::format("  step {} of {}: {} bonds broken on it, equilibrium {}; about {}:{:02}:{:02} "
                    "remain\n",
                    update->ntimestep, update->laststep, life.broken, life.equilibria, left / 3600,
                    left / 60 % 60, left % 60)
            .c_str(),
        screen);
  fflush(screen);
}

/* ---------------------------------------------------------------------- */

void TMSPHQuasistatic::write_output()
{
  const bigint now = update->ntimestep;
  bool acts = false;
  for (const auto fix : stops) acts = acts || now % fix->nevery == 0;
  if (output->next != now && !acts) return;
  solver->update_all();
  if (acts) modify->end_of_step();
  if (output->next != now) return;
  const bool restart = output->next_restart == now;
  timer->stamp();
  output->write(now);
  timer->stamp(Timer::OUTPUT);
  life.shown = platform::walltime();
  if (restart) start_afresh();
}

/* ---------------------------------------------------------------------- */

void TMSPHQuasistatic::tell() const
{
  if (comm->me) return;
  utils::logmesg(lmp, "Quasi-static: {} equilibria in {} steps, {} force evaluations\n",
                 count.equilibria, count.steps, solver->evaluations());
  if (count.failures) utils::logmesg(lmp, "  {} equilibria were not found\n", count.failures);
  if (count.broken)
    utils::logmesg(lmp, "  {} bonds broke, the first on step {}, most, {}, on step {}\n",
                   count.broken, count.first_step, count.avalanche, count.avalanche_step);
}
