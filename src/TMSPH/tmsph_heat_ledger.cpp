/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_ledger.h"

#include "comm.h"
#include "fix.h"
#include "tmsph_heat_boundary.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void TMSPHHeatLedger::open(const std::vector<TMSPHHeatBoundary *> &present)
{
  const size_t size = present.size();
  std::vector<TMSPHHeatAccount> opened(size + 1);
  const bool restarted = ids.empty() && accounts.size() == opened.size();
  for (size_t a = 0; a + 1 < accounts.size(); a++) {
    size_t b = restarted ? a : 0;
    while (!restarted && b < size && !(present[b]->has_account && present[b]->fix().id == ids[a]))
      b++;
    if (b < size)
      opened[b] = accounts[a];
    else
      former_energy += accounts[a].energy;
  }
  if (!accounts.empty()) opened.back() = accounts.back();
  accounts.swap(opened);
  boundaries.assign(present.begin(), present.end());
  ids.clear();
  for (auto boundary : present) {
    boundary->has_account = true;
    ids.emplace_back(boundary->fix().id);
  }
}

/* ----------------------------------------------------------------------
   the number of its account, or that behind the last boundary
------------------------------------------------------------------------- */

int TMSPHHeatLedger::find(const TMSPHHeatBoundary *boundary) const
{
  return std::find(boundaries.begin(), boundaries.end(), boundary) - boundaries.begin();
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatLedger::enter(const double *energies, double duration)
{
  for (TMSPHHeatAccount &account : accounts) {
    account.energy += *energies;
    account.power = *energies++ / duration;
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatLedger::enter(const TMSPHHeatBoundary *boundary, double energy)
{
  const int found = find(boundary);
  if (found < (int) boundaries.size()) accounts[found].energy += energy;
}

/* ---------------------------------------------------------------------- */

TMSPHHeatAccount TMSPHHeatLedger::account(const TMSPHHeatBoundary *boundary) const
{
  const int found = find(boundary);
  return found < (int) boundaries.size() ? accounts[found] : TMSPHHeatAccount();
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatLedger::total(bool of_sources_only, double TMSPHHeatAccount::*what,
                              double mine) const
{
  double sum;
  for (int a = 0; a < size(); a++)
    if ((a == of_sources()) == of_sources_only) mine += accounts[a].*what;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatLedger::total_power(bool of_sources_only) const
{
  return total(of_sources_only, &TMSPHHeatAccount::power, 0.0);
}

/* ---------------------------------------------------------------------- */

double TMSPHHeatLedger::total_energy(bool of_sources_only) const
{
  return total(of_sources_only, &TMSPHHeatAccount::energy, of_sources_only ? 0.0 : former_energy);
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatLedger::append_to(std::vector<double> &list)
{
  double former;
  MPI_Allreduce(&former_energy, &former, 1, MPI_DOUBLE, MPI_SUM, world);
  former_energy = comm->me == 0 ? former : 0.0;
  list.push_back(former);
  list.push_back(size());
  for (TMSPHHeatAccount &account : accounts) {
    double mine[2] = {account.power, account.energy}, sum[2];
    MPI_Allreduce(mine, sum, 2, MPI_DOUBLE, MPI_SUM, world);
    list.insert(list.end(), sum, sum + 2);
    account = comm->me == 0 ? TMSPHHeatAccount{sum[0], sum[1]} : TMSPHHeatAccount();
  }
}

/* ---------------------------------------------------------------------- */

const double *TMSPHHeatLedger::take_from(const double *list)
{
  const bool mine = comm->me == 0;
  former_energy = mine ? *list : 0.0;
  accounts.assign((size_t) * ++list, TMSPHHeatAccount());
  list++;
  for (TMSPHHeatAccount &account : accounts) {
    if (mine) account = {list[0], list[1]};
    list += 2;
  }
  return list;
}
