/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which bonds break, and what is told of it. The criterion is in tmsph_hoekbrown.h.
------------------------------------------------------------------------- */

#include "fix_tmsph_hoekbrown.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "tmsph_random.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;
using TMSPH::Extremes;

/* ---------------------------------------------------------------------- */

int FixTMSPHHoekBrown::setmask()
{
  return PRE_FORCE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix tmsph/hoekbrown needs pair style tmsph");
  if (modify->get_fix_by_style("^tmsph/hoekbrown$").size() > 1)
    error->all(FLERR, "More than one fix tmsph/hoekbrown: give all types in a single one");
  if (all_principals && domain->dimension == 3) all_principals = false;    // 3-D has all anyway
  bonds = pair->bonds();
  pair->set_break_test(this);
  std::vector<double> young(atom->ntypes + 1, 0.0);
  for (int type = 1; type <= atom->ntypes; type++) young[type] = pair->material(type).young;
  debris.set_young(young);
  armed = false;
  version = -1;

  // fragments may meet, unless contact of all surfaces sees to that

  bool others = false;
  for (Fix *fix : modify->get_fix_by_style("^tmsph/contact$")) {
    const auto contact = dynamic_cast<PairTMSPH::Contact *>(fix);
    others = others || contact->states() >> FixTMSPHBond::BROKEN & 1u;
  }

  // an unchanged request keeps its list: LAMMPS does not hand it over again

  if (others) list = nullptr;
  else neighbor->add_request(this, NeighConst::REQ_FULL);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::init_list(int /*id*/, NeighList *ptr)
{
  list = ptr;
}

/* ----------------------------------------------------------------------
   bonds are tested once a step of a run: not in the setup, which repeats the
   last step's forces, and not while minimizing
------------------------------------------------------------------------- */

void FixTMSPHHoekBrown::pre_force(int /*vflag*/)
{
  armed = true;
  broken_now = 0;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::end_of_step()
{
  armed = false;
}

/* ----------------------------------------------------------------------
   after an exchange of particles: strengths by first id, candidates of contact
------------------------------------------------------------------------- */

void FixTMSPHHoekBrown::follow_layout()
{
  if (version == bonds->layout_version()) return;
  version = bonds->layout_version();
  strengths.resize(atom->nlocal + atom->nghost);
  for (int i = 0; i < atom->nlocal; i++) {
    const Rock &rock = rocks[atom->type[i]];
    strengths[i] = rock.modulus > 0.0
        ? TMSPH::weibull_random(rock.strength, rock.modulus, bonds->first_id(i), rock.seed)
        : rock.strength;
  }
  debris.leave_out(1u << FixTMSPHBond::INTACT | pair->states_in_contact());
  debris.measure(*bonds);
  comm->forward_comm(this);
  if (list) debris.list_candidates(*list, neighbor->skin, *bonds);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHoekBrown::pack_forward_comm(int n, int *sendlist, double *buf, int /*pbc_flag*/,
                                         int * /*pbc*/)
{
  for (int i = 0; i < n; i++) {
    *buf++ = debris.spacings()[sendlist[i]];
    *buf++ = strengths[sendlist[i]];
  }
  return 2 * n;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::unpack_forward_comm(int n, int first, double *buf)
{
  for (int i = first; i < first + n; i++) {
    debris.spacings()[i] = *buf++;
    strengths[i] = *buf++;
  }
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::repel(double *virial)
{
  follow_layout();
  return debris.repel(virial);
}

/* ---------------------------------------------------------------------- */

Extremes FixTMSPHHoekBrown::extremes(const double *stress, double zz) const
{
  if (domain->dimension == 3) return TMSPH::principal_extremes_3d(stress);
  Extremes e = TMSPH::principal_extremes_2d(stress);
  if (all_principals) {
    e.largest = std::max(e.largest, zz);
    e.smallest = std::min(e.smallest, zz);
  }
  return e;
}

/* ---------------------------------------------------------------------- */

Extremes FixTMSPHHoekBrown::extremes_of(int i, const double *stress) const
{
  return extremes(stress, all_principals ? pair->stress_zz(i, stress[0], stress[1]) : 0.0);
}

/* ---------------------------------------------------------------------- */

bool FixTMSPHHoekBrown::may_fail(int i, const double *stress) const
{
  if (all_principals) return true;
  static const double REACH_3D = 2.0 / std::sqrt(3.0);
  const bool two = domain->dimension == 2;
  const TMSPH::Invariants v = two ? TMSPH::invariants_2d(stress) : TMSPH::invariants_3d(stress);
  return TMSPH::may_fail(v.mean, v.deviation2, two ? 1.0 : REACH_3D, strengths[i],
                         rocks[atom->type[i]].constants);
}

/* ----------------------------------------------------------------------
   A bond is tested with the mean stress and the mean strength of its ends. The
   safe states of a rock form a convex set that scales with its strength, so a
   bond between two ends that are safe on their own is safe: only bonds with an
   end that is not need the test, or those between different rocks.
   Both ends, on whatever processor, see the same numbers and decide alike.
------------------------------------------------------------------------- */

void FixTMSPHHoekBrown::find_due(const double *stress)
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost, size = pair->stress_size();
  const int *type = atom->type;
  const auto row = [&](int i) { return stress + (size_t) i * size; };
  const bool ranked = relative > 0.0;    // all load factors are wanted
  due_bonds.clear();
  test = Test();

  beyond.resize(nall);
  bool any = ranked || !one_rock;
  for (int i = 0; i < nall; i++) {
    beyond[i] = ranked || (may_fail(i, row(i)) &&
        TMSPH::fails(extremes_of(i, row(i)), strengths[i], rocks[type[i]].constants));
    any = any || beyond[i];
  }
  if (!any) return;

  for (int i = 0; i < nlocal; i++) {
    for (int k = 0; k < bonds->count(i); k++) {
      if (bonds->bond_state(i, k) != FixTMSPHBond::INTACT) continue;
      const int j = bonds->partner_index(i, k);
      const bool same = one_rock || rocks[type[i]].constants == rocks[type[j]].constants;
      if (same && !beyond[i] && !beyond[j]) continue;

      Due bond = {i, k, 0.0, {}, {}};
      double zz = 0.0;
      for (int c = 0; c < size; c++) bond.stress[c] = 0.5 * (row(i)[c] + row(j)[c]);
      if (all_principals)
        zz = 0.5 * (pair->stress_zz(i, row(i)[0], row(i)[1]) +
                    pair->stress_zz(j, row(j)[0], row(j)[1]));
      bond.extremes = extremes(bond.stress, zz);
      const double strength = 0.5 * (strengths[i] + strengths[j]);
      const TMSPH::HoekBrown rock = same
          ? rocks[type[i]].constants
          : TMSPH::mean(rocks[type[i]].constants, rocks[type[j]].constants);
      if (ranked) {
        bond.load = TMSPH::load_factor(bond.extremes, strength, rock);
        test.largest = std::max(test.largest, bond.load);
      }
      if (ranked ? bond.load >= 1.0 : TMSPH::fails(bond.extremes, strength, rock))
        due_bonds.push_back(bond);
    }
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::keep_most_loaded()
{
  double largest;
  MPI_Allreduce(&test.largest, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
  const double least = relative * largest;
  due_bonds.erase(std::remove_if(due_bonds.begin(), due_bonds.end(),
                                 [least](const Due &bond) { return bond.load < least; }),
                  due_bonds.end());
  bigint ends = due_bonds.size(), all;
  MPI_Allreduce(&ends, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  test = {largest, all / 2};
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::break_bonds(const double *stress, std::vector<int> &touched)
{
  follow_layout();
  armed = false;
  find_due(stress);
  if (relative > 0.0)
    keep_most_loaded();
  else if (fresh)
    warn_of_hot_start();
  fresh = false;
  relative = 0.0;
  for (const Due &bond : due_bonds) {
    const int i = bond.i, j = bonds->partner_index(i, bond.k);
    if (atom->tag[i] < atom->tag[j]) record(bond);
    bonds->remove_bond(i, bond.k, FixTMSPHBond::BROKEN);
    if (list) debris.add(i, j, *bonds);
    if (touched.empty() || touched.back() != i) touched.push_back(i);
  }
  if (events.size() > event_rows.size()) list_events();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::test_next(double fraction)
{
  armed = true;
  relative = fraction;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::tensile_strength() const
{
  double smallest = HUGE_VAL;
  for (int type = 1; type <= atom->ntypes; type++)
    smallest = std::min(smallest, tensile_strength(type));
  return smallest;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::tensile_strength(int type) const
{
  const Rock &rock = rocks[type];
  const Extremes pull = {rock.strength, 0.0};
  return rock.strength / TMSPH::load_factor(pull, rock.strength, rock.constants);
}

/* ----------------------------------------------------------------------
   one row of the local table; a bond is recorded where its lower id lives
------------------------------------------------------------------------- */

void FixTMSPHHoekBrown::record(const Due &bond)
{
  const int i = bond.i, j = bonds->partner_index(i, bond.k);
  const int mode = bond.extremes.largest > 0.0 ? 0 : 1;    // tension where a principal stress pulls
  broken[mode]++;
  broken_now++;
  double X[3];
  bonds->reference_vector(i, j, X);
  const double R = std::sqrt(X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
  const double time = update->atime + (update->ntimestep - update->atimestep) * update->dt;
  Event event;
  double *c = event.column;
  *c++ = atom->tag[i];
  *c++ = atom->tag[j];
  *c++ = update->ntimestep;
  *c++ = time;
  for (int a = 0; a < 3; a++) *c++ = 0.5 * (atom->x[i][a] + atom->x[j][a]);
  for (int a = 0; a < 3; a++) *c++ = X[a] / R;
  *c++ = mode + 1;
  *c++ = pair->bond_energy(i, bond.k, bond.stress);
  *c++ = 0.5 * (atom->temperature[i] + atom->temperature[j]);
  events.push_back(event);
}

/* ----------------------------------------------------------------------
   the table as LAMMPS takes it; rows that are known stay unless the events have moved
------------------------------------------------------------------------- */

void FixTMSPHHoekBrown::list_events()
{
  if (!event_rows.empty() && event_rows[0] != events[0].column) event_rows.clear();
  while (event_rows.size() < events.size())
    event_rows.push_back(events[event_rows.size()].column);
  array_local = event_rows.data();
  size_local_rows = events.size();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHoekBrown::find_strengths()
{
  if (!bonds)
    error->all(FLERR, "Fix tmsph/hoekbrown {} was not in a run yet: do a 'run 0' first", id);
  follow_layout();
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::strength(int i) const
{
  return strengths[i];
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::load_factor(int i, const double *stress) const
{
  Extremes e;
  if (domain->dimension == 3)
    e = TMSPH::principal_extremes_3d(stress);
  else {
    const double plane[3] = {stress[0], stress[1], stress[3]};
    e = extremes(plane, stress[2]);
  }
  return TMSPH::load_factor(e, strengths[i], rocks[atom->type[i]].constants);
}

/* ---------------------------------------------------------------------- */

bigint FixTMSPHHoekBrown::total(int mode)
{
  bigint all;
  MPI_Allreduce(&broken[mode], &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::compute_scalar()
{
  return total(0) + total(1);
}

/* ----------------------------------------------------------------------
   1 broken in tension, 2 in shear, 3 on this step, 4 largest load factor of a
   particle, 5 fragment contacts
------------------------------------------------------------------------- */

double FixTMSPHHoekBrown::compute_vector(int n)
{
  if (n < 2) return total(n);
  if (n == 3) return largest_load();
  double mine = n == 2 ? (double) broken_now : 0.5 * debris.contacts();
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHoekBrown::largest_load()
{
  PairTMSPH::laid_out(lmp, fmt::format("Output 4 of fix tmsph/hoekbrown {}", id));
  find_strengths();
  const double *stress = pair->fields().stress;
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    mine = std::max(mine,
                    TMSPH::load_factor(extremes_of(i, stress + (size_t) i * pair->stress_size()),
                                       strengths[i], rocks[atom->type[i]].constants));
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}
