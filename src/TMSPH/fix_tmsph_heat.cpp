/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Conduction of heat: what a step needs, heat content and output. The stepping itself is
   in fix_tmsph_heat_step.cpp.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_store_atom.h"
#include "fix_tmsph_bond.h"
#include "fix_tmsph_heat_boundary.h"
#include "force.h"
#include "input.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_conduction.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::setmask()
{
  // the second for the setup before tmsph/quasistatic advances it

  return PRE_FORCE | MIN_PRE_FORCE | (viscous ? END_OF_STEP : 0);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::post_constructor()
{
  norms_id = std::string(id) + "_TMSPH_NORM";
  norms = dynamic_cast<FixStoreAtom *>(modify->add_fix(
      fmt::format("{} all STORE/ATOM {} 0 0 1", norms_id, MULTIPLIER + domain->dimension)));
}

/* ---------------------------------------------------------------------- */

FixTMSPHHeat::~FixTMSPHHeat()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  if (modify->nfix && modify->get_fix_by_id(norms_id)) modify->delete_fix(norms_id);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix tmsph/heat needs pair style tmsph");
  if (modify->get_fix_by_style("^tmsph/heat$").size() > 1)
    error->all(FLERR, "More than one fix tmsph/heat: give all types in a single one");
  bonds = pair->bonds();
  version = -1;
  if (crosses || friction) pair->heat_crosses_contacts();
  boundaries.clear();
  for (Fix *fix : modify->get_fix_by_style("^tmsph/heat/boundary$"))
    boundaries.push_back(static_cast<FixTMSPHHeatBoundary *>(fix));
  open_accounts();
  for (int type = 1; type <= atom->ntypes; type++) {
    const std::string &name = substances[type].source_variable;
    if (name.empty()) continue;
    const int found = input->variable->find(name.c_str());
    if (found < 0)
      error->all(FLERR, "Variable {} of fix tmsph/heat source does not exist: define it first",
                 name);
    if (!input->variable->equalstyle(found) && !input->variable->atomstyle(found))
      error->all(FLERR, "Variable {} of fix tmsph/heat source must be of equal or atom style",
                 name);
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::setup_pre_force(int /*vflag*/)
{
  if ((crosses || friction) && !pair->contact_of_surfaces())
    error->all(FLERR, "Fix tmsph/heat {} needs to know what touches: add a fix tmsph/contact",
               crosses ? "contact" : "friction");
  find_norms();
  prepare(0.0);
}

/* ----------------------------------------------------------------------
   the temperatures of a step are there before its forces
------------------------------------------------------------------------- */

void FixTMSPHHeat::pre_force(int /*vflag*/)
{
  if (update->ntimestep % every != 0) return;
  if (friction) collect_friction();
  const double duration = every * time_scale * update->dt;
  prepare(duration);
  std::vector<double> y;
  attempt(duration, y);
  commit(duration, y);
}

/* ----------------------------------------------------------------------
   what viscosity took in this step; ghosts learn of it for the stresses of outputs
------------------------------------------------------------------------- */

void FixTMSPHHeat::end_of_step()
{
  std::vector<double> taken;
  pair->viscous_heat(taken);
  double *T = atom->temperature, sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const double energy = taken[i] * update->dt;
    if (held[i] != NOT_HELD) continue;
    sum += energy;
    T[i] = substances[atom->type[i]].specific_heat.temperature_at(enthalpy(i, T[i]) +
                                                                  energy / atom->rmass[i]);
  }
  accounts[source_account()].energy += sum;
  ghosts.send(T, 1, 1);
}

/* ----------------------------------------------------------------------
   quasi-static stepping: an attempt that turns out too long is taken back, the
   next call starts from what went well before
------------------------------------------------------------------------- */

int FixTMSPHHeat::advance(int most, double largest_change)
{
  const bigint now = update->ntimestep;
  const double *T = atom->temperature;
  const std::vector<double> before(T, T + atom->nlocal);
  const std::vector<Account> accounts_before(accounts);
  std::vector<double> y;
  int steps = comfortable > most / 2 ? most : 2 * comfortable;
  if (friction) collect_friction();
  for (;;) {
    const double duration = steps * time_scale * update->dt;
    update->ntimestep = now + steps;    // for variables
    prepare(duration);
    attempt(duration, y);
    update->ntimestep = now;
    double mine = 0.0, change;
    for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, std::fabs(T[i] - before[i]));
    MPI_Allreduce(&mine, &change, 1, MPI_DOUBLE, MPI_MAX, world);
    if (steps == 1 || change <= largest_change) {
      commit(duration, y);
      break;
    }
    std::copy(before.begin(), before.end(), atom->temperature);
    accounts = accounts_before;
    steps = std::max(1, (int) (steps * std::max(0.1, 0.9 * largest_change / change)));
  }
  comfortable = steps;
  return steps;
}

/* ----------------------------------------------------------------------
   @param y enthalpies of the local particles, then energies of the accounts
------------------------------------------------------------------------- */

void FixTMSPHHeat::attempt(double duration, std::vector<double> &y)
{
  const int nlocal = atom->nlocal;
  const double *T = atom->temperature;
  const std::vector<double> before(T, T + nlocal);
  y.assign(nlocal + accounts.size(), 0.0);
  for (int i = 0; i < nlocal; i++) y[i] = enthalpy(i, T[i]);
  step(duration, y);
  put_temperatures(y);
  double mine = 0.0, change;
  for (int i = 0; i < nlocal; i++) {
    const double d = std::fabs(T[i] - before[i]);
    if (!(d <= mine)) mine = std::isfinite(d) ? d : HUGE_VAL;
  }
  MPI_Allreduce(&mine, &change, 1, MPI_DOUBLE, MPI_MAX, world);
  if (!std::isfinite(change))
    error->all(FLERR, "A temperature of fix tmsph/heat is no number any more on step {}: check the "
                      "values given to its boundaries and sources", update->ntimestep);
  fastest = change / duration;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::commit(double duration, const std::vector<double> &y)
{
  const int nlocal = atom->nlocal;
  for (size_t n = 0; n < accounts.size(); n++) {
    accounts[n].energy += y[nlocal + n];
    accounts[n].power = y[nlocal + n] / duration;
  }
  std::copy(power.begin(), power.end(), atom->heatflow);
  covered += duration;
  rubbed.clear();
}

/* ----------------------------------------------------------------------
   energies that friction took since the last advance
------------------------------------------------------------------------- */

void FixTMSPHHeat::collect_friction()
{
  std::vector<TMSPHSurfaceContact::Rubbing> rubbings;
  pair->contact_of_surfaces()->rubbings(rubbings);
  rubbed.clear();
  for (const auto &r : rubbings) rubbed.push_back({r.i, 0.0, 0.0, r.work});
}

/* ----------------------------------------------------------------------
   what acts from outside during an advance
------------------------------------------------------------------------- */

void FixTMSPHHeat::prepare(double duration)
{
  const int nlocal = atom->nlocal;
  follow();
  held.assign(nlocal, NOT_HELD);
  exchanges.clear();
  first_exchange.assign(1, 0);
  heats = cools = false;
  for (size_t b = 0; b < boundaries.size(); b++) {
    if (boundaries[b]->holds_temperature()) {
      boundaries[b]->hold_temperature();
      for (int i = 0; i < nlocal; i++)
        if (atom->mask[i] & boundaries[b]->groupbit) held[i] = b;
    } else
      boundaries[b]->list_exchanges(*this, exchanges);
    first_exchange.push_back(exchanges.size());
  }
  if (duration > 0.0)
    for (const Exchange &r : rubbed) exchanges.push_back({r.i, 0.0, 0.0, r.power / duration});
  first_exchange.push_back(exchanges.size());
  for (const Exchange &e : exchanges) {
    heats = heats || e.power > 0.0;
    cools = cools || e.power < 0.0;
  }
  evaluate_sources();
  bridges.clear();
  if (crosses) find_bridges();

  // Gershgorin: lambda_max <= 2 max (sum of conductances/capacity). Up to 2/lambda_max explicit
  // Euler takes means of temperatures with positive weights

  std::vector<double> all(sums);
  for (const Exchange &e : exchanges) all[e.i] += e.conductance;
  for (const Bridge &b : bridges) all[b.i] += b.conductance;
  double mine = 0.0, largest;
  for (int i = 0; i < nlocal; i++) {
    const double heat = substances[atom->type[i]].specific_heat.smallest();
    if (held[i] == NOT_HELD) mine = std::max(mine, all[i] / (heat * atom->rmass[i]));
  }
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  stable = largest > 0.0 ? 1.0 / largest : HUGE_VAL;

  if (!rkl2 && duration > stable)
    error->all(
        FLERR,
        "The heat step {:.4g} (timestep x every x time/scale) of fix tmsph/heat is above the "
        "stable one of explicit stepping, {:.4g}: shorten it, or use 'subcycle rkl2'",
        duration, stable);
}

/* ----------------------------------------------------------------------
   on which variables will be asked again
------------------------------------------------------------------------- */

bigint FixTMSPHHeat::next_step() const
{
  return (update->ntimestep / every + 1) * every;
}

/* ----------------------------------------------------------------------
   power per volume
------------------------------------------------------------------------- */

void FixTMSPHHeat::evaluate_sources()
{
  const int nlocal = atom->nlocal;
  source_of.clear();
  for (int type = 1; type <= atom->ntypes; type++) {
    Substance &s = substances[type];
    std::vector<double> each;
    if (!s.source_variable.empty()) {
      const int variable = input->variable->find(s.source_variable.c_str());
      modify->clearstep_compute();
      if (input->variable->equalstyle(variable))
        s.source = input->variable->compute_equal(variable);
      else {
        each.resize(nlocal);
        input->variable->compute_atom(variable, 0, each.data(), 1, 0);
      }
      modify->addstep_compute(next_step());
    }
    if (each.empty() && s.source == 0.0) continue;
    source_of.resize(nlocal);
    for (int i = 0; i < nlocal; i++) {
      if (atom->type[i] != type || !(atom->mask[i] & groupbit)) continue;
      source_of[i] = each.empty() ? s.source : each[i];
      heats = heats || source_of[i] > 0.0;
      cools = cools || source_of[i] < 0.0;
    }
  }
}

/* ----------------------------------------------------------------------
   Through pairs that press on each other: the area A = 2 c W D of the surface
   that is theirs, as for bonds across a plane, and on it in series both half
   distances and the gap.
------------------------------------------------------------------------- */

void FixTMSPHHeat::find_bridges()
{
  std::vector<TMSPHSurfaceContact::Touch> touches;
  pair->contact_of_surfaces()->touches(touches);
  const auto k = [this](int i) {
    return substances[atom->type[i]].conductivity(atom->temperature[i]);
  };
  for (const auto &t : touches) {
    const double h = gap[atom->type[t.i]][atom->type[t.j]];
    if (h == 0.0) continue;
    const double area = (all_norms[t.i] + all_norms[t.j]) * t.weight * t.distance;
    const double resistance = t.distance / TMSPH::harmonic_mean(k(t.i), k(t.j)) + 1.0 / h;
    bridges.push_back({t.i, t.j, area / resistance});
  }
}

/* ----------------------------------------------------------------------
   energy per mass
------------------------------------------------------------------------- */

double FixTMSPHHeat::enthalpy(int i, double temperature) const
{
  return substances[atom->type[i]].specific_heat.integral(temperature);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHeat::content() const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    sum += atom->rmass[i] * enthalpy(i, atom->temperature[i]);
  return sum;
}

/* ----------------------------------------------------------------------
   A boundary keeps its account from run to run. Those that are gone leave their energy in
   the sum. A restart file has them in the order of the fixes.
------------------------------------------------------------------------- */

void FixTMSPHHeat::open_accounts()
{
  std::vector<Account> opened(boundaries.size() + 1);
  const bool restarted = account_ids.empty() && accounts.size() == opened.size();
  for (size_t a = 0; a + 1 < accounts.size(); a++) {
    size_t b = restarted ? a : 0;
    while (!restarted && b < boundaries.size() &&
           !(boundaries[b]->has_account && boundaries[b]->id == account_ids[a]))
      b++;
    if (b < boundaries.size())
      opened[b] = accounts[a];
    else
      former_energy += accounts[a].energy;
  }
  if (!accounts.empty()) opened.back() = accounts.back();
  accounts.swap(opened);
  account_ids.clear();
  for (auto boundary : boundaries) {
    boundary->has_account = true;
    account_ids.emplace_back(boundary->id);
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::bring(const FixTMSPHHeatBoundary *boundary, double energy)
{
  const auto found = std::find(boundaries.begin(), boundaries.end(), boundary);
  if (found != boundaries.end()) accounts[found - boundaries.begin()].energy += energy;
}

/* ---------------------------------------------------------------------- */

FixTMSPHHeat::Account FixTMSPHHeat::account(const FixTMSPHHeatBoundary *boundary) const
{
  const auto found = std::find(boundaries.begin(), boundaries.end(), boundary);
  return found == boundaries.end() ? Account() : accounts[found - boundaries.begin()];
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHeat::compute_scalar()
{
  double mine = content();
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   1 power of boundaries, 2 their energy so far, 3 and 4 the same of sources,
   5 largest rate of a temperature, 6 stable explicit step, 7 time covered,
   8 applications of the operator
------------------------------------------------------------------------- */

double FixTMSPHHeat::compute_vector(int n)
{
  if (n == 4) return fastest;
  if (n == 5) return stable;
  if (n == 6) return covered;
  if (n == 7) return applications;
  double mine = n == 1 ? former_energy : 0.0, all;
  for (int a = 0; a < (int) accounts.size(); a++)
    if ((a == source_account()) == (n > 1))
      mine += n % 2 ? accounts[a].energy : accounts[a].power;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}
