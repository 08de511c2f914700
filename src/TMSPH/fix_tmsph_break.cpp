/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which bonds break, and when they are tested.
------------------------------------------------------------------------- */

#include "fix_tmsph_break.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixTMSPHBreak *FixTMSPHBreak::find(LAMMPS *lmp)
{
  for (const auto &fix : lmp->modify->get_fix_list())
    if (const auto found = dynamic_cast<FixTMSPHBreak *>(fix)) return found;
  return nullptr;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBreak::setmask()
{
  return PRE_FORCE | END_OF_STEP;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix {} needs pair style tmsph", style);
  for (const auto &fix : modify->get_fix_list())
    if (fix != this && dynamic_cast<FixTMSPHBreak *>(fix))
      error->all(FLERR, "Fixes {} {} and {} {} both break bonds: give all types in a single one",
                 style, id, fix->style, fix->id);
  bonds = pair->bonds();
  pair->set_break_test(this);
  std::vector<double> young(atom->ntypes + 1, 0.0);
  for (int type = 1; type <= atom->ntypes; type++) young[type] = pair->material(type).young;
  debris.set_young(young);
  armed = false;
  rock.init(*pair);
  opening.init(*pair, ghosts);
  comm_forward = std::max(1, opening.most_sent());

  // fragments may meet, unless contact of all surfaces sees to that

  bool others = false;
  for (Fix *fix : modify->get_fix_by_style("^tmsph/contact$")) {
    const auto contact = dynamic_cast<TMSPHSurfaceContact *>(fix);
    others = others || contact->states() >> FixTMSPHBond::BROKEN & 1u;
  }

  // an unchanged request keeps its list: LAMMPS does not hand it over again

  if (others)
    list = nullptr;
  else
    neighbor->add_request(this, NeighConst::REQ_FULL);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::init_list(int /*id*/, NeighList *ptr)
{
  list = ptr;
}

/* ----------------------------------------------------------------------
   bonds are tested once a step of a run: not in the setup, which repeats the
   last step's forces, and not while minimizing
------------------------------------------------------------------------- */

void FixTMSPHBreak::pre_force(int /*vflag*/)
{
  armed = true;
  begin_step();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::end_of_step()
{
  armed = false;
}

/* ----------------------------------------------------------------------
   after an exchange of particles
------------------------------------------------------------------------- */

void FixTMSPHBreak::follow_layout()
{
  if (!rock.follow(*bonds, ghosts)) return;
  suspects.lay_out(*bonds, rock, *atom);
  debris.leave_out(1u << FixTMSPHBond::INTACT | pair->states_in_contact());
  debris.measure(*bonds);
  ghosts.complete(debris.spacings());
  if (list) debris.list_candidates(*list, neighbor->skin, *bonds);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBreak::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  return ghosts.pack(n, list, buf);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::unpack_forward_comm(int n, int first, double *buf)
{
  ghosts.unpack(n, first, buf);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::repel(double *virial)
{
  follow_layout();
  return debris.repel(virial);
}

/* ----------------------------------------------------------------------
   A bond is tested with the mean stress and the mean strength of its ends. Both,
   on whatever processor, see the same numbers and decide alike.
------------------------------------------------------------------------- */

void FixTMSPHBreak::find_due(const double *stress)
{
  const int size = TMSPH::stress_row(domain->dimension);
  const int *type = atom->type;
  const TMSPH::Criterion &criterion = rock.criterion();
  const auto row = [&](int i) { return stress + (size_t) i * size; };
  const bool ranked = relative > 0.0;    // all load factors are wanted
  due_bonds.clear();
  test = Test();

  suspects.find(atom->nlocal + atom->nghost, *bonds, [&](int i) {
    const bool fails = ranked || rock.fails(i, row(i));
    return (fails ? TMSPHSuspects::BEYOND : 0) | (opening.near(i) ? TMSPHSuspects::NEAR : 0);
  });

  for (int i = 0; i < atom->nlocal; i++) {
    if (!suspects.tested_at(i)) continue;
    for (const auto &[k, j, state] : bonds->family(i, FixTMSPHBond::WHOLE)) {
      const bool same = rock.alike(type[i], type[j]);
      const char either = suspects.either(i, j);
      if (same && !either) continue;
      const bool softens = opening.opens(i, j), looked = softens && (either & TMSPHSuspects::NEAR);
      if (same && !(either & TMSPHSuspects::BEYOND) && !looked) continue;

      Due bond = {i, k, 0.0, {}, {}};
      for (int c = 0; c < size; c++) bond.stress[c] = 0.5 * (row(i)[c] + row(j)[c]);
      bond.principals = rock.principals(i, j, row(i), row(j), bond.stress);
      if (softens && softening(bond, looked)) continue;
      const double strength = rock.strength(i, j);
      const int other = same ? type[i] : type[j];
      if (ranked) {
        bond.load = criterion.load_factor(type[i], other, bond.principals, strength);
        test.largest = std::max(test.largest, bond.load);
      }
      if (ranked ? bond.load >= 1.0 : criterion.fails(type[i], other, bond.principals, strength))
        due_bonds.push_back(bond);
    }
  }
}

/* ----------------------------------------------------------------------
   of a bond that opens before it is gone
   return false if it fails without tension: it breaks at once
------------------------------------------------------------------------- */

bool FixTMSPHBreak::softening(Due &bond, bool looked)
{
  if (opening.is_open(bond.i, bond.k)) return true;
  const int j = bonds->partner_index(bond.i, bond.k);
  const double strength = rock.tensile_strength_of(bond.i, j);
  double stress[6];
  std::copy_n(bond.stress, 6, stress);
  const double pull = looked ? opening.pull(bond.i, j, stress) : bond.principals.largest;
  if (!opening.is_tension(pull, strength)) return false;
  // a bond along the faces cannot open: as a load it would be due in each test for ever
  const bool wanted = pull >= strength || relative > 0.0;
  if (looked && wanted && !opening.crosses(bond.i, j, stress)) return true;
  test.largest = std::max(test.largest, pull / strength);
  if (looked && pull >= strength) {
    std::copy_n(stress, 6, bond.stress);
    bond.load = pull / strength;
    bond.opens = true;
    due_bonds.push_back(bond);
  }
  return true;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::keep_most_loaded()
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

void FixTMSPHBreak::break_bonds(const double *stress, std::vector<int> &touched)
{
  follow_layout();
  opening.follow(stress);
  armed = false;
  find_due(stress);
  if (relative > 0.0)
    keep_most_loaded();
  else if (fresh)
    warn_of_hot_start();
  fresh = false;
  relative = 0.0;
  for (const Due &bond : due_bonds)
    if (bond.opens) opening.begin(bond.i, bond.k, bond.stress);
  opening.complete();
  for (const Due &bond : due_bonds) {
    if (bond.opens) continue;
    const bool recorded = atom->tag[bond.i] < bonds->partner_tag(bond.i, bond.k);
    remove(bond.i, bond.k,
           recorded ? events.strain_energy(*pair, *bonds, bond.i, bond.k, bond.stress) : 0.0,
           bond.principals.largest > 0.0, touched);
    if (list) debris.add(bond.i, bonds->partner_index(bond.i, bond.k), *bonds);
  }
  if (openings()) openings()->list_open();
  list_events();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::remove_opened(std::vector<int> &touched)
{
  for (const auto &[i, k, energy] : openings()->leaving()) {
    pair->contact_of_surfaces()->opened(i, k);
    remove(i, k, energy, true, touched);
  }
  openings()->list_open();
  list_events();
}

/* ----------------------------------------------------------------------
   from one of its ends; an event is recorded where the lower id lives
------------------------------------------------------------------------- */

void FixTMSPHBreak::remove(int i, int k, double energy, bool pulled, std::vector<int> &touched)
{
  if (atom->tag[i] < bonds->partner_tag(i, k))
    events.record(*bonds, i, k, energy,
                  pulled ? TMSPHBreakEvents::TENSION : TMSPHBreakEvents::SHEAR);
  bonds->remove_bond(i, k, FixTMSPHBond::BROKEN);
  if (touched.empty() || touched.back() != i) touched.push_back(i);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::list_events()
{
  array_local = events.table();
  size_local_rows = events.rows();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::test_next(double fraction)
{
  armed = true;
  relative = fraction;
}

/* ---------------------------------------------------------------------- */

bool FixTMSPHBreak::any_damage()
{
  return compute_scalar() > 0.0 || (openings() && openings()->anywhere());
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::find_strengths()
{
  if (!bonds) error->all(FLERR, "Fix {} {} was not in a run yet: do a 'run 0' first", style, id);
  follow_layout();
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::compute_scalar()
{
  return events.total(TMSPHBreakEvents::TENSION) + events.total(TMSPHBreakEvents::SHEAR);
}

/* ----------------------------------------------------------------------
   1 broken in tension, 2 in shear, 3 on this step, 4 largest load factor of a
   particle, 5 contacts, 6 and on of openings
------------------------------------------------------------------------- */

double FixTMSPHBreak::compute_vector(int n)
{
  if (n < 2) return events.total((TMSPHBreakEvents::Mode) n);
  if (n > 4) {
    const auto part = opening.figures();
    double sum;
    MPI_Allreduce(&part[n - 5], &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
  }
  if (n == 3) return largest_load();
  if (n == 4 && !list) {
    const auto contact = pair ? pair->contact_of_surfaces() : nullptr;
    return contact ? contact->touching_pairs() : 0.0;
  }
  if (n == 2) return events.total_now();
  const double mine = 0.5 * debris.contacts();
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::largest_load()
{
  PairTMSPH::laid_out(lmp, fmt::format("Output 4 of fix {} {}", style, id));
  find_strengths();
  const double *stress = pair->fields().stress;
  const int size = TMSPH::stress_row(domain->dimension);
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++)
    mine = std::max(mine, rock.load_factor(i, rock.principals(i, stress + (size_t) i * size)));
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}
