/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_stepper.h"

#include "atom.h"
#include "error.h"
#include "tmsph_heat_flows.h"
#include "tmsph_heat_ledger.h"
#include "tmsph_rkl2.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// below this fraction of the stable step the error of explicit Euler in time is far below that of
// the lattice in space

static constexpr double SMALL_STEP = 0.1;

/* ---------------------------------------------------------------------- */

TMSPHHeatStepper::TMSPHHeatStepper(LAMMPS *lmp, TMSPHHeatFlows &equation, TMSPHHeatLedger &books) :
    Pointers(lmp), flows(equation), ledger(books)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatStepper::advance(double duration)
{
  attempt(duration);
  commit(duration);
}

/* ----------------------------------------------------------------------
   an attempt that turns out too long is taken back, the next call starts from
   what went well before
------------------------------------------------------------------------- */

int TMSPHHeatStepper::advance(int most, double largest_change, double time_scale)
{
  const bigint now = update->ntimestep;
  const double *T = atom->temperature;
  const std::vector<double> before(T, T + atom->nlocal);
  const auto books_before = ledger.books();
  int steps = comfortable > most / 2 ? most : 2 * comfortable;
  for (;;) {
    const double duration = steps * time_scale * update->dt;
    update->ntimestep = now + steps;    // for variables
    attempt(duration);
    update->ntimestep = now;
    double mine = 0.0, change;
    for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, std::fabs(T[i] - before[i]));
    MPI_Allreduce(&mine, &change, 1, MPI_DOUBLE, MPI_MAX, world);
    if (steps == 1 || change <= largest_change) {
      commit(duration);
      break;
    }
    std::copy(before.begin(), before.end(), atom->temperature);
    ledger.restore(books_before);
    // factors of step size control: Hairer, Norsett, Wanner, Solving ODEs I, 1993, Sect. II.4
    steps = std::max(1, (int) (steps * std::max(0.1, 0.9 * largest_change / change)));
  }
  comfortable = steps;
  return steps;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatStepper::attempt(double duration)
{
  flows.prepare(duration);
  if (!rkl2 && duration > flows.stable_step())
    error->all(
        FLERR,
        "The heat step {:.4g} (timestep x every x time/scale) of fix tmsph/heat is above the "
        "stable one of explicit stepping, {:.4g}: shorten it, or use 'subcycle rkl2'",
        duration, flows.stable_step());
  const int nlocal = atom->nlocal;
  const double *T = atom->temperature;
  const std::vector<double> before(T, T + nlocal);
  flows.start(y, ledger.size());
  step(duration, y);
  flows.put_temperatures(y);
  double mine = 0.0, change;
  for (int i = 0; i < nlocal; i++) {
    const double d = std::fabs(T[i] - before[i]);
    if (!(d <= mine)) mine = std::isfinite(d) ? d : HUGE_VAL;
  }
  MPI_Allreduce(&mine, &change, 1, MPI_DOUBLE, MPI_MAX, world);
  if (!std::isfinite(change))
    error->all(FLERR,
               "A temperature of fix tmsph/heat is no number any more on step {}: check the "
               "values given to its boundaries and sources",
               update->ntimestep);
  fastest = change / duration;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatStepper::commit(double duration)
{
  ledger.enter(y.data() + atom->nlocal, duration);
  std::copy(flows.power().begin(), flows.power().end(), atom->heatflow);
  time += duration;
}

/* ----------------------------------------------------------------------
   RKL2 can leave the range of the temperatures at a jump, which the equation
   never does without sources: then shorter steps are taken, down to explicit
   Euler, which cannot.
------------------------------------------------------------------------- */

void TMSPHHeatStepper::step(double duration, std::vector<double> &values)
{
  const double stable = flows.stable_step();
  if (!rkl2 || duration <= SMALL_STEP * stable) return euler_step(duration, values);
  const TMSPHHeatFlows::Range mine = flows.range_with_outside(values);
  double range[2];
  MPI_Allreduce(mine.data(), range, 2, MPI_DOUBLE, MPI_MAX, world);
  // what some hundreds of roundings leave
  const double rounding = 1.0e-13 * std::max(std::fabs(range[0]), std::fabs(range[1]));

  const std::vector<double> start(values);
  super_step(duration, values);
  const auto moves = flows.bounds_move();
  const TMSPHHeatFlows::Range now = flows.range(values);
  int leaves = 0, any;
  for (int side = 0; side < 2; side++)
    if (!moves[side] && now[side] > range[side] + rounding) leaves = 1;
  MPI_Allreduce(&leaves, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;
  values = start;
  const bool shortest = duration <= stable;
  for (int half = 0; half < 2; half++)
    shortest ? euler_step(0.5 * duration, values) : step(0.5 * duration, values);
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatStepper::euler_step(double duration, std::vector<double> &values)
{
  std::vector<double> rate(values.size());
  flows.rates(values, rate);
  for (size_t n = 0; n < values.size(); n++) values[n] += duration * rate[n];
}

/* ----------------------------------------------------------------------
   The stages as distances from the start of the step, of which Y_0 has none:
   what is at rest stays so to the bit.
------------------------------------------------------------------------- */

void TMSPHHeatStepper::super_step(double duration, std::vector<double> &values)
{
  const size_t size = values.size();
  const TMSPH::Rkl2 scheme(duration / flows.stable_step());
  const std::vector<double> y0(values);
  std::vector<double> rate0(size), rate, last(size, 0.0), before_last(size, 0.0);
  flows.rates(y0, rate0);
  rate = rate0;
  for (int j = 1; j <= scheme.stages; j++) {
    const TMSPH::Rkl2::Stage c = scheme.stage(j);
    if (j > 1) flows.rates(values, rate);
    for (size_t n = 0; n < size; n++) {
      const double way = c.mu * last[n] + c.nu * before_last[n] +
          duration * (c.mu_rate * rate[n] + c.gamma_rate * rate0[n]);
      before_last[n] = last[n];
      last[n] = way;
      values[n] = y0[n] + way;
    }
  }
}
