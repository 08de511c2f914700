/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_flows.h"

#include "atom.h"
#include "fix.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_heat_contacts.h"
#include "tmsph_heat_materials.h"
#include "tmsph_heat_network.h"
#include "tmsph_heat_sources.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

TMSPHHeatFlows::TMSPHHeatFlows(LAMMPS *lmp, const TMSPHHeatMaterials &given,
                               TMSPHHeatNetwork &bonds, TMSPHHeatContacts &touching,
                               TMSPHHeatSources &inside, TMSPHGhostSender &sender) :
    Pointers(lmp),
    materials(given), network(bonds), contacts(touching), sources(inside), ghosts(sender)
{
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatFlows::init(const std::vector<TMSPHHeatBoundary *> &present, int steps)
{
  boundaries = present;
  every = steps;
}

/* ----------------------------------------------------------------------
   on which variables will be asked again
------------------------------------------------------------------------- */

bigint TMSPHHeatFlows::next_step() const
{
  return (update->ntimestep / every + 1) * every;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatFlows::prepare(double duration)
{
  network.follow();
  list_exchanges(duration);
  sources.evaluate(next_step());
  contacts.find_bridges(materials, network.norms());
  find_stable_step();
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatFlows::list_exchanges(double duration)
{
  const int nlocal = atom->nlocal;
  held.assign(nlocal, NOT_HELD);
  exchanges.clear();
  first_exchange.assign(1, 0);
  for (size_t b = 0; b < boundaries.size(); b++) {
    if (boundaries[b]->holds_temperature()) {
      boundaries[b]->hold_temperature();
      const int groupbit = boundaries[b]->fix().groupbit;
      for (int i = 0; i < nlocal; i++)
        if (atom->mask[i] & groupbit) held[i] = b;
    } else
      boundaries[b]->list_exchanges(exchanges);
    first_exchange.push_back(exchanges.size());
  }
  if (duration > 0.0) contacts.list_friction(duration, exchanges);
  first_exchange.push_back(exchanges.size());
}

/* ----------------------------------------------------------------------
   Gershgorin: lambda_max <= 2 max (sum of conductances/capacity). Up to 2/lambda_max explicit
   Euler takes means of temperatures with positive weights.
------------------------------------------------------------------------- */

void TMSPHHeatFlows::find_stable_step()
{
  std::vector<double> sums(network.sums());
  for (const TMSPHHeatExchange &e : exchanges) sums[e.i] += e.conductance;
  for (const auto &b : contacts.bridges()) sums[b.i] += b.conductance;
  double mine = 0.0, largest;
  for (int i = 0; i < atom->nlocal; i++) {
    const double heat = materials.specific_heat(atom->type[i]).smallest();
    if (!is_held(i)) mine = std::max(mine, sums[i] / (heat * atom->rmass[i]));
  }
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  stable = largest > 0.0 ? 1.0 / largest : HUGE_VAL;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatFlows::start(std::vector<double> &y, int accounts) const
{
  y.assign(atom->nlocal + accounts, 0.0);
  for (int i = 0; i < atom->nlocal; i++) y[i] = materials.enthalpy(i, atom->temperature[i]);
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatFlows::rates(const std::vector<double> &y, std::vector<double> &rate)
{
  const int nlocal = atom->nlocal;
  put_temperatures(y);
  const double *T = atom->temperature;
  powers.resize(nlocal);
  network.conduct(T, powers.data());
  applied++;
  for (const auto &b : contacts.bridges()) powers[b.i] += b.conductance * (T[b.j] - T[b.i]);
  std::fill(rate.begin() + nlocal, rate.end(), 0.0);
  const int accounts = rate.size() - nlocal;    // of the boundaries, then of all sources
  for (int b = 0; b < accounts; b++)
    for (int n = first_exchange[b]; n < first_exchange[b + 1]; n++) {
      const TMSPHHeatExchange &e = exchanges[n];
      const double gain = e.conductance * (e.outside - T[e.i]) + e.power;
      powers[e.i] += gain;
      rate[nlocal + b] += gain;
    }
  const std::vector<double> &source = sources.power();
  if (!source.empty())
    for (int i = 0; i < nlocal; i++) {
      const double gain = source[i] * atom->vfrac[i];
      powers[i] += gain;
      rate.back() += gain;
    }
  for (int i = 0; i < nlocal; i++) {
    const bool free = !is_held(i);
    if (!free) rate[nlocal + held[i]] -= powers[i];
    rate[i] = free ? powers[i] / atom->rmass[i] : 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatFlows::put_temperatures(const std::vector<double> &y)
{
  double *T = atom->temperature;
  for (int i = 0; i < atom->nlocal; i++)
    if (!is_held(i)) T[i] = materials.temperature(i, y[i]);
  ghosts.send(T, 1, 1);
}

/* ---------------------------------------------------------------------- */

static void include(TMSPHHeatFlows::Range &range, double T)
{
  range[0] = std::max(range[0], -T);
  range[1] = std::max(range[1], T);
}

/* ---------------------------------------------------------------------- */

TMSPHHeatFlows::Range TMSPHHeatFlows::range(const std::vector<double> &y) const
{
  Range found = {-HUGE_VAL, -HUGE_VAL};
  for (int i = 0; i < atom->nlocal; i++) include(found, materials.temperature(i, y[i]));
  return found;
}

/* ---------------------------------------------------------------------- */

TMSPHHeatFlows::Range TMSPHHeatFlows::range_with_outside(const std::vector<double> &y) const
{
  Range found = range(y);
  for (const TMSPHHeatExchange &e : exchanges)
    if (e.conductance > 0.0) include(found, e.outside);
  return found;
}

/* ---------------------------------------------------------------------- */

std::array<bool, 2> TMSPHHeatFlows::bounds_move() const
{
  int mine[2] = {sources.cool(), sources.heat()}, any[2];
  for (const TMSPHHeatExchange &e : exchanges) {
    mine[0] = mine[0] || e.power < 0.0;
    mine[1] = mine[1] || e.power > 0.0;
  }
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, world);
  return {any[0] != 0, any[1] != 0};
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatFlows::bytes() const
{
  return powers.capacity() * sizeof(double) + held.capacity() * sizeof(int) +
      exchanges.capacity() * sizeof(TMSPHHeatExchange);
}
