/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_heat_boundary.h"
#include "tmsph_restart.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 4.0;

/* ---------------------------------------------------------------------- */

FixTMSPHHeat::FixTMSPHHeat(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), ghosts(lmp, this), materials(lmp), sources(lmp),
    contacts(lmp), network(lmp, materials, ghosts),
    flows(lmp, materials, network, contacts, sources, ghosts), ledger(lmp),
    stepper(lmp, flows, ledger), every(1), time_scale(1.0), viscous(false), told(false)
{
  if (!atom->temperature_flag || !atom->vfrac_flag || !atom->rmass_flag)
    error->all(FLERR,
               "Fix tmsph/heat needs an atom style with temperature, volume and mass: "
               "atom_style tmsph");
  if (igroup != 0)
    error->all(FLERR,
               "Fix tmsph/heat works on all particles: use group all and give each type its "
               "conductivity");
  parse(narg, arg);
  scalar_flag = vector_flag = 1;
  size_vector = 8;
  global_freq = 1;
  extscalar = 1;
  extvector = 0;
  restart_global = restart_peratom = 1;
  comm_forward = network.faces().layer_size();    // the most columns of all parts
  maxexchange = network.faces().most();
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  network.faces().grow(atom->nmax);
}

/* ---------------------------------------------------------------------- */

FixTMSPHHeat::~FixTMSPHHeat()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::setmask()
{
  // the second for the setup before tmsph/quasistatic advances it

  return PRE_FORCE | MIN_PRE_FORCE | (viscous ? END_OF_STEP : 0);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix tmsph/heat needs pair style tmsph");
  if (modify->get_fix_by_style("^tmsph/heat$").size() > 1)
    error->all(FLERR, "More than one fix tmsph/heat: give all types in a single one");
  network.init(pair->bonds(), pair, pair);
  contacts.init(pair);
  std::vector<TMSPHHeatBoundary *> boundaries;
  for (Fix *fix : modify->get_fix_list())
    if (auto boundary = dynamic_cast<TMSPHHeatBoundary *>(fix)) boundaries.push_back(boundary);
  flows.init(boundaries, every);
  ledger.open(boundaries);
  sources.check();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::setup_pre_force(int /*vflag*/)
{
  contacts.check();
  network.form();
  flows.prepare(0.0);
}

/* ----------------------------------------------------------------------
   the temperatures of a step are there before its forces
------------------------------------------------------------------------- */

void FixTMSPHHeat::pre_force(int /*vflag*/)
{
  if (update->ntimestep % every != 0) return;
  contacts.collect_friction();
  stepper.advance(every * time_scale * update->dt);
}

/* ----------------------------------------------------------------------
   quasi-static stepping
------------------------------------------------------------------------- */

int FixTMSPHHeat::advance(int most, double largest_change)
{
  contacts.collect_friction();
  return stepper.advance(most, largest_change, time_scale);
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
    if (flows.is_held(i)) continue;
    sum += energy;
    T[i] = materials.temperature(i, materials.enthalpy(i, T[i]) + energy / atom->rmass[i]);
  }
  ledger.enter_sources(sum);
  ghosts.send(T, 1, 1);
}

/* ----------------------------------------------------------------------
   heat content
------------------------------------------------------------------------- */

double FixTMSPHHeat::compute_scalar()
{
  double mine = materials.content(), sum;
  MPI_Allreduce(&mine, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

/* ----------------------------------------------------------------------
   1 power of boundaries, 2 their energy so far, 3 and 4 the same of sources,
   5 largest rate of a temperature, 6 stable explicit step, 7 time covered,
   8 applications of the operator
------------------------------------------------------------------------- */

double FixTMSPHHeat::compute_vector(int n)
{
  switch (n) {
    case 0:
    case 2:
      return ledger.total_power(n == 2);
    case 1:
    case 3:
      return ledger.total_energy(n == 3);
    case 4:
      return stepper.fastest_rate();
    case 5:
      return std::min(flows.stable_step(), 1.0e20);    // nothing conducts: a number in tables
    case 6:
      return stepper.covered();
    default:
      return flows.applications();
  }
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  return ghosts.pack(n, list, buf);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::unpack_forward_comm(int n, int first, double *buf)
{
  ghosts.unpack(n, first, buf);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::pack_exchange(int i, double *buf)
{
  return network.faces().pack(i, buf);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::unpack_exchange(int nlocal, double *buf)
{
  return network.faces().unpack(nlocal, buf);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);    // LAMMPS wants the length first
  return 1 + pack_exchange(i, buf + 1);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::unpack_restart(int nlocal, int nth)
{
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(*extra);
  unpack_exchange(nlocal, extra + 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::size_restart(int i)
{
  return 1 + network.faces().size(i);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::maxsize_restart()
{
  return 1 + maxexchange;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::write_restart(FILE *fp)
{
  std::vector<double> list = {RESTART_FORMAT,
                              stepper.covered(),
                              (double) flows.applications(),
                              stepper.fastest_rate(),
                              (double) stepper.comfortable_steps(),
                              flows.stable_step()};
  ledger.append_to(list);
  network.append_to(list);
  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::restart(char *buf)
{
  static constexpr int OWN = 6;    // numbers before those of ledger and network
  double own[OWN], ledger_begin[2];
  memcpy(own, buf, sizeof(double));
  check_restart_format(error, "fix tmsph/heat", own[0], RESTART_FORMAT);
  memcpy(own, buf, sizeof(own));
  stepper.restart(own[1], own[3], (int) own[4]);
  flows.restart((bigint) own[2], own[5]);
  buf += sizeof(own);
  memcpy(ledger_begin, buf, sizeof(ledger_begin));
  std::vector<double> rest(TMSPHHeatLedger::length(ledger_begin) + network.restart_length());
  memcpy(rest.data(), buf, rest.size() * sizeof(double));
  network.take_from(ledger.take_from(rest.data()));
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHeat::memory_usage()
{
  return network.bytes() + flows.bytes() + sources.bytes();
}
