/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which bonds break, and what is told of it. The criterion is a part of its own, see
   tmsph_criterion.h.
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
#include "tmsph_random.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace FixConst;
using TMSPH::Principals;

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
  if (all_principals && domain->dimension == 3) all_principals = false;    // 3-D has all anyway
  bonds = pair->bonds();
  pair->set_break_test(this);
  std::vector<double> young(atom->ntypes + 1, 0.0);
  for (int type = 1; type <= atom->ntypes; type++) young[type] = pair->material(type).young;
  debris.set_young(young);
  armed = false;
  version = -1;
  init_openings();

  // fragments may meet, unless contact of all surfaces sees to that

  bool others = false;
  for (Fix *fix : modify->get_fix_by_style("^tmsph/contact$")) {
    const auto contact = dynamic_cast<TMSPHSurfaceContact *>(fix);
    others = others || contact->states() >> FixTMSPHBond::BROKEN & 1u;
  }

  // an unchanged request keeps its list: LAMMPS does not hand it over again

  if (others) list = nullptr;
  else neighbor->add_request(this, NeighConst::REQ_FULL);
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
  broken_now = 0;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::end_of_step()
{
  armed = false;
}

/* ----------------------------------------------------------------------
   after an exchange of particles: strengths by first id, candidates of contact
------------------------------------------------------------------------- */

void FixTMSPHBreak::follow_layout()
{
  if (version == bonds->layout_version()) return;
  version = bonds->layout_version();
  strengths.resize(atom->nlocal);
  for (int i = 0; i < atom->nlocal; i++) {
    const Rock &rock = rocks[atom->type[i]];
    strengths[i] = rock.modulus > 0.0
        ? TMSPH::weibull_random(rock.strength, rock.modulus, bonds->first_id(i), rock.seed)
        : rock.strength;
  }
  debris.leave_out(1u << FixTMSPHBond::INTACT | pair->states_in_contact());
  debris.measure(*bonds);
  ghosts.complete(strengths);
  ghosts.complete(debris.spacings());
  if (list) debris.list_candidates(*list, neighbor->skin, *bonds);
  border.assign(atom->nlocal, INSIDE);
  for (int i = 0; i < atom->nlocal; i++)
    for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE)) {
      if (bond.j >= atom->nlocal) border[i] = std::max<char>(border[i], BESIDE_GHOSTS);
      if (!one_rock && !criterion->alike(atom->type[i], atom->type[bond.j])) border[i] = MIXED;
    }
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

/* ---------------------------------------------------------------------- */

Principals FixTMSPHBreak::principals(const double *stress, double zz) const
{
  if (domain->dimension == 3) return TMSPH::principals_3d(stress);
  const Principals p = TMSPH::principals_2d(stress);
  if (!all_principals) return p;
  return {std::max(p.largest, zz), std::max(p.smallest, std::min(p.largest, zz)),
          std::min(p.smallest, zz)};
}

/* ---------------------------------------------------------------------- */

Principals FixTMSPHBreak::principals_of(int i, const double *stress) const
{
  return principals(stress, all_principals ? pair->stress_zz(i, stress[0], stress[1]) : 0.0);
}

/* ---------------------------------------------------------------------- */

bool FixTMSPHBreak::may_fail(int i, const double *stress) const
{
  if (all_principals) return true;
  const bool two = domain->dimension == 2;
  const TMSPH::Invariants v = two ? TMSPH::invariants_2d(stress) : TMSPH::invariants_3d(stress);
  return criterion->may_fail(atom->type[i], v, two ? 1.0 : TMSPH::REACH_3D, strengths[i]);
}

/* ----------------------------------------------------------------------
   particles with a bond that is tested: to a suspect one, or between different rocks
------------------------------------------------------------------------- */

void FixTMSPHBreak::find_tested()
{
  const int nlocal = atom->nlocal;
  const bool ghosts_too =
      std::any_of(suspect.begin() + nlocal, suspect.end(), [](char one) { return one != 0; });
  tested.assign(nlocal, 0);
  for (int i = 0; i < nlocal; i++) {
    if (suspect[i])
      for (const auto &bond : bonds->family(i, FixTMSPHBond::WHOLE))
        if (bond.j < nlocal) tested[bond.j] = 1;
    if (suspect[i] || border[i] == MIXED || (border[i] == BESIDE_GHOSTS && ghosts_too))
      tested[i] = 1;
  }
}

/* ----------------------------------------------------------------------
   A bond is tested with the mean stress and the mean strength of its ends. The
   safe states of a rock form a convex set that scales with its strength, so a
   bond between two ends that are safe on their own is safe: only bonds with an
   end that is not need the test, or those between different rocks.
   Both ends, on whatever processor, see the same numbers and decide alike.
------------------------------------------------------------------------- */

void FixTMSPHBreak::find_due(const double *stress)
{
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  const int size = TMSPH::stress_row(domain->dimension);
  const int *type = atom->type;
  const auto row = [&](int i) { return stress + (size_t) i * size; };
  const bool ranked = relative > 0.0;    // all load factors are wanted
  due_bonds.clear();
  test = Test();

  suspect.resize(nall);
  for (int i = 0; i < nall; i++) {
    const bool fails = ranked || (may_fail(i, row(i)) &&
        criterion->fails(type[i], type[i], principals_of(i, row(i)), strengths[i]));
    suspect[i] = (fails ? BEYOND : 0) | (looking && opening->near(i) ? NEAR : 0);
  }
  find_tested();

  for (int i = 0; i < nlocal; i++) {
    if (!tested[i]) continue;
    for (const auto &[k, j, state] : bonds->family(i, FixTMSPHBond::WHOLE)) {
      const bool same = one_rock || type[i] == type[j] || criterion->alike(type[i], type[j]);
      const char either = suspect[i] | suspect[j];
      if (same && !either) continue;
      const bool softens = opens(i, j), looked = softens && (either & NEAR);
      if (same && !(either & BEYOND) && !looked) continue;

      Due bond = {i, k, 0.0, {}, {}};
      double zz = 0.0;
      for (int c = 0; c < size; c++) bond.stress[c] = 0.5 * (row(i)[c] + row(j)[c]);
      if (all_principals)
        zz = 0.5 * (pair->stress_zz(i, row(i)[0], row(i)[1]) +
                    pair->stress_zz(j, row(j)[0], row(j)[1]));
      bond.principals = principals(bond.stress, zz);
      if (softens && (looked ? begin_opening(bond) : pulled(bond))) continue;
      const double strength = 0.5 * (strengths[i] + strengths[j]);
      const int other = same ? type[i] : type[j];
      if (ranked) {
        bond.load = criterion->load_factor(type[i], other, bond.principals, strength);
        test.largest = std::max(test.largest, bond.load);
      }
      if (ranked ? bond.load >= 1.0 : criterion->fails(type[i], other, bond.principals, strength))
        due_bonds.push_back(bond);
    }
  }
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
  if (opening) follow_openings(stress);
  armed = false;
  find_due(stress);
  if (opening && looking) complete_openings();
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
  if (opening) opening->list_open();
  if (events.size() > event_rows.size()) list_events();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::test_next(double fraction)
{
  armed = true;
  relative = fraction;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::tensile_strength() const
{
  double smallest = HUGE_VAL;
  for (int type = 1; type <= atom->ntypes; type++)
    smallest = std::min(smallest, tensile_strength(type));
  return smallest;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::tensile_strength(int type) const
{
  const double strength = rocks[type].strength;
  const Principals pull = {strength, 0.0, 0.0};
  return strength / criterion->load_factor(type, type, pull, strength);
}

/* ----------------------------------------------------------------------
   small-strain part of the strain energy that bond k of local particle i carries at a stress:
   under uniform stress in the interior f_ij = 2 W_ij/kappa sigma X_ij, and half of f u' is
   the energy; summed over all bonds this is the strain energy of the body
------------------------------------------------------------------------- */

static double bond_energy(const TMSPHMaterials &materials, const FixTMSPHBond &bonds,
                          const Atom &atom, int D, int i, int k, const double *stress)
{
  const int j = bonds.partner_index(i, k);
  double X[3], work = 0.0;
  bonds.reference_vector(i, j, X);
  const int row[3][3] = {{0, D, D + 1}, {D, 1, D + 2}, {D + 1, D + 2, 2}};
  const double young = materials.elastic(i).young + materials.elastic(j).young;
  const double theta = (materials.thermal_push(i) + materials.thermal_push(j)) / young;
  for (int a = 0; a < D; a++) {
    const double u = (atom.x[j][a] - bonds.reference(j)[a]) -
        (atom.x[i][a] - bonds.reference(i)[a]) - theta * X[a];
    for (int b = 0; b < D; b++) work += u * stress[row[a][b]] * X[b];
  }
  return bonds.weight(i, j) * work / bonds.interior_kappa();
}

/* ----------------------------------------------------------------------
   one row of the local table; a bond is recorded where its lower id lives
------------------------------------------------------------------------- */

void FixTMSPHBreak::record(const Due &bond)
{
  const int i = bond.i, j = bonds->partner_index(i, bond.k);
  const int mode = bond.principals.largest > 0.0 ? 0 : 1;    // tension where one pulls
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
  *c++ = bond_energy(*pair, *bonds, *atom, domain->dimension, i, bond.k, bond.stress);
  *c++ = 0.5 * (atom->temperature[i] + atom->temperature[j]);
  events.push_back(event);
}

/* ----------------------------------------------------------------------
   the table as LAMMPS takes it; rows that are known stay unless the events have moved
------------------------------------------------------------------------- */

void FixTMSPHBreak::list_events()
{
  if (!event_rows.empty() && event_rows[0] != events[0].column) event_rows.clear();
  while (event_rows.size() < events.size())
    event_rows.push_back(events[event_rows.size()].column);
  array_local = event_rows.data();
  size_local_rows = events.size();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBreak::find_strengths()
{
  if (!bonds)
    error->all(FLERR, "Fix {} {} was not in a run yet: do a 'run 0' first", style, id);
  follow_layout();
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::strength(int i) const
{
  return strengths[i];
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::load_factor(int i, const double *stress) const
{
  const double plane[3] = {stress[0], stress[1], stress[3]};
  const bool space = domain->dimension == 3;
  return criterion->load_factor(atom->type[i], atom->type[i],
                                space ? TMSPH::principals_3d(stress) : principals(plane, stress[2]),
                                strengths[i]);
}

/* ---------------------------------------------------------------------- */

bigint FixTMSPHBreak::total(int mode)
{
  bigint all;
  MPI_Allreduce(&broken[mode], &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBreak::compute_scalar()
{
  return total(0) + total(1);
}

/* ----------------------------------------------------------------------
   1 broken in tension, 2 in shear, 3 on this step, 4 largest load factor of a
   particle, 5 contacts, 6 and on of openings
------------------------------------------------------------------------- */

double FixTMSPHBreak::compute_vector(int n)
{
  if (n < 2) return total(n);
  if (n > 4) {
    const auto part = opening ? opening->balance() : TMSPHOpenings::Balance();
    double sum;
    MPI_Allreduce(&part[n - 5], &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
  }
  if (n == 3) return largest_load();
  if (n == 4 && !list) {
    const auto contact = pair ? pair->contact_of_surfaces() : nullptr;
    return contact ? contact->touching_pairs() : 0.0;
  }
  const double mine = n == 2 ? (double) broken_now : 0.5 * debris.contacts();
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
  for (int i = 0; i < atom->nlocal; i++) {
    const Principals p = principals_of(i, stress + (size_t) i * size);
    const int type = atom->type[i];
    mine = std::max(mine, criterion->load_factor(type, type, p, strengths[i]));
  }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}
