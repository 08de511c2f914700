/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stepping of fix tmsph/heat: explicit Euler, or RKL2 of tmsph_rkl2.h.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "fix_tmsph_bond.h"
#include "pair_tmsph.h"
#include "tmsph_heat_sweep.h"
#include "tmsph_rkl2.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// below this share of the stable step the error of explicit Euler in time is far below that of
// the lattice in space

static constexpr double SMALL_STEP = 0.1;

/* ----------------------------------------------------------------------
   RKL2 can leave the range of the temperatures at a jump, which the equation
   never does without sources: then shorter steps are taken, down to explicit
   Euler, which cannot.
   @param y enthalpies of the local particles and energies of the accounts
------------------------------------------------------------------------- */

void FixTMSPHHeat::step(double duration, std::vector<double> &y)
{
  if (!rkl2 || duration <= SMALL_STEP * stable) return euler_step(duration, y);
  const int nlocal = atom->nlocal;
  const auto temperature = [&](int i) {
    const Substance &s = substances[atom->type[i]];
    return s.specific_heat.temperature_at(y[i]);
  };
  double mine[2] = {-HUGE_VAL, -HUGE_VAL}, range[2];    // minus the lowest, the highest
  const auto include = [&mine](double T) {
    mine[0] = std::max(mine[0], -T);
    mine[1] = std::max(mine[1], T);
  };
  for (int i = 0; i < nlocal; i++) include(temperature(i));
  for (const Exchange &e : exchanges)
    if (e.conductance > 0.0) include(e.outside);
  MPI_Allreduce(mine, range, 2, MPI_DOUBLE, MPI_MAX, world);
  const double rounding = 1.0e-13 * std::max(std::fabs(range[0]), std::fabs(range[1]));

  const std::vector<double> start(y);
  super_step(duration, y);
  int leaves = 0, any, moved[2] = {cools, heats}, move[2];
  MPI_Allreduce(moved, move, 2, MPI_INT, MPI_MAX, world);
  for (int i = 0; i < nlocal; i++) {
    const double T = temperature(i);
    if ((!move[0] && -T > range[0] + rounding) || (!move[1] && T > range[1] + rounding)) leaves = 1;
  }
  MPI_Allreduce(&leaves, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any) return;
  y = start;
  const bool shortest = duration <= stable;
  for (int half = 0; half < 2; half++)
    shortest ? euler_step(0.5 * duration, y) : step(0.5 * duration, y);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::euler_step(double duration, std::vector<double> &y)
{
  std::vector<double> rate(y.size());
  rates(y, rate);
  for (size_t n = 0; n < y.size(); n++) y[n] += duration * rate[n];
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::super_step(double duration, std::vector<double> &y)
{
  const size_t size = y.size();
  const TMSPH::Rkl2 scheme(duration / stable);
  const std::vector<double> y0(y);
  std::vector<double> rate0(size), rate(size), last(y), before_last(size);
  rates(y0, rate0);
  for (int j = 1; j <= scheme.stages; j++) {
    const TMSPH::Rkl2::Stage c = scheme.stage(j);
    if (j == 1)
      rate = rate0;
    else
      rates(last, rate);
    for (size_t n = 0; n < size; n++)
      y[n] = c.mu * last[n] + c.nu * before_last[n] + (1.0 - c.mu - c.nu) * y0[n] +
          duration * (c.mu_rate * rate[n] + c.gamma_rate * rate0[n]);
    std::swap(before_last, last);
    last = y;
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::rates(const std::vector<double> &y, std::vector<double> &rate)
{
  const int nlocal = atom->nlocal;
  put_temperatures(y);
  const double *T = atom->temperature;
  if (tables) {
    conductivities.resize(nlocal + atom->nghost);
    for (int i = 0; i < nlocal + atom->nghost; i++)
      conductivities[i] = substances[atom->type[i]].conductivity(T[i]);
  }
  power.resize(nlocal);
  TMSPH::heat_sweep(bonds->layout(), conductances.data(), T,
                    tables ? conductivities.data() : nullptr, power.data());
  applications++;
  for (const Bridge &b : bridges) power[b.i] += b.conductance * (T[b.j] - T[b.i]);
  std::fill(rate.begin() + nlocal, rate.end(), 0.0);
  for (size_t b = 0; b < accounts.size(); b++)
    for (int n = first_exchange[b]; n < first_exchange[b + 1]; n++) {
      const Exchange &e = exchanges[n];
      const double gain = e.conductance * (e.outside - T[e.i]) + e.power;
      power[e.i] += gain;
      rate[nlocal + b] += gain;
    }
  if (!source_of.empty())
    for (int i = 0; i < nlocal; i++) {
      const double gain = source_of[i] * atom->vfrac[i];
      power[i] += gain;
      rate[nlocal + source_account()] += gain;
    }
  for (int i = 0; i < nlocal; i++) {
    const bool free = held[i] == NOT_HELD;
    if (!free) rate[nlocal + held[i]] -= power[i];
    rate[i] = free ? power[i] / atom->rmass[i] : 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::put_temperatures(const std::vector<double> &y)
{
  for (int i = 0; i < atom->nlocal; i++)
    if (held[i] == NOT_HELD)
      atom->temperature[i] = substances[atom->type[i]].specific_heat.temperature_at(y[i]);
  ghosts.send(atom->temperature, 1, 1);
}
