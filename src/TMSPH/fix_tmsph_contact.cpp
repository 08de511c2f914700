/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What fix tmsph/contact does in a step, and what it tells others.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_last_force.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Member = TMSPHContactList::Member;

/* ----------------------------------------------------------------------
   a continued run repeats the forces of its last step: at a setup velocities
   are those of the full step, and the law took those of half a step before
------------------------------------------------------------------------- */

void FixTMSPHContact::setup_pre_force(int)
{
  resumed = TMSPHLastForce::untouched(lmp, memories);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::post_run()
{
  TMSPHLastForce::stamp(lmp, memories);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::setup(int vflag)
{
  v_init(vflag);
  follow(true);
  if (!resumed) search.ask();
  if (resumed)
    apply_again();
  else
    act(0.0);
  add_virial();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::post_force(int vflag)
{
  v_init(vflag);
  follow(true);
  act(update->dt);
  add_virial();
}

/* ----------------------------------------------------------------------
   equilibrium is looked for: nothing moves, so nothing is predicted
------------------------------------------------------------------------- */

void FixTMSPHContact::min_setup(int vflag)
{
  min_post_force(vflag);
}

void FixTMSPHContact::min_post_force(int vflag)
{
  resumed = false;
  v_init(vflag);
  follow(true);
  act(0.0);
  add_virial();
}

/* ----------------------------------------------------------------------
   the pairs are listed again after an exchange of particles and when bonds
   have gone; the latter may happen in the midst of a force evaluation
------------------------------------------------------------------------- */

void FixTMSPHContact::follow(bool after_breaks)
{
  const FixTMSPHBond &bonds = *scene.bonds;
  const bool anew = watch.laid_out_anew(bonds);    // the same on all processors
  if (!anew &&
      !(after_breaks && scene.self && scene.pair->bonds_may_break() &&
        watch.removed_anywhere(bonds, world)))
    return;
  std::vector<int> touched;
  if (!anew) watch.each_removal(bonds, [&touched](int i) { touched.push_back(i); });
  watch.see(bonds);
  if (outlines) {
    outlines->find();
    outlines->face();
  }
  list_pairs(anew ? nullptr : &touched);
  if (list.anywhere) fits.fit(list);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::list_pairs(const std::vector<int> *touched)
{
  maxexchange =
      1 + std::max(list.make(outlines.get(), touched), TMSPHContactMemory::size(0, 0, 0, 0));
  couples.list_anew();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::act(double dt)
{
  if (domain->dimension == 2)
    evaluate<2>(dt);
  else
    evaluate<3>(dt);
}

/* ---------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::evaluate(double dt)
{
  totals.start();
  const bool search_due = search.due();
  if (possible()) {
    forces.evaluate<D>(facing() ? places.get() : nullptr, dt);
    couples.balance<D>(true);
  }
  if (!search_due) return;
  const bool changed = search.find<D>(forces.states<D>());
  if (outlines) outlines->face();
  if (!changed && !outlines) return;
  list_pairs(nullptr);
  if (list.anywhere) fits.fit(list);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::apply_again()
{
  for (const Member &m : list.members)
    for (int a = 0; a < domain->dimension; a++) atom->f[m.i][a] += list.memory(m).force[a];
  if (!possible()) return;
  if (domain->dimension == 2)
    couples.balance<2>(false);
  else
    couples.balance<3>(false);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::add_virial()
{
  if (!vflag_global && !vflag_atom) return;
  for (const Member &m : list.members)
    for (int k = 0; k < 6; k++) {
      const double v = -atom->vfrac[m.i] * list.memory(m).stress[k];
      if (vflag_global) virial[k] += v;
      if (vflag_atom) vatom[m.i][k] += v;
    }
}

/* ----------------------------------------------------------------------
   The pressure of pairs also pushes sideways in the material that it presses, which moves along
   with its neighbors: see lateral_ratio(). It acts along the mean normal of the pairs, by weights
   that fade towards the horizon as theirs, and is the trace of their part.
------------------------------------------------------------------------- */

void FixTMSPHContact::add_loads(std::vector<Load> &loads)
{
  follow(false);
  const int d = domain->dimension;
  for (const Member &m : list.members) {
    const double *s = list.memory(m).stress;
    const double *H = scene.pair->step_gradient() + (size_t) d * d * m.i;
    if (std::all_of(s, s + 6, [](double one) { return one == 0.0; })) continue;
    Load load = {m.i, scene.segments, {s[0], s[1], s[2], s[3], s[4], s[5]}};
    double reference[3] = {}, n[3] = {}, square = 0.0;
    for (int k = m.first; k < m.last; k++) {
      const TMSPHContactList::End &e = list.ends[k];
      const ContactPair &p = list.pairings[e.pairing].pair;
      const double *x = atom->x[m.i], *y = atom->x[e.j];
      double r2 = 0.0;
      for (int a = 0; a < d; a++) r2 += (y[a] - x[a]) * (y[a] - x[a]);
      const double fading = std::max(0.0, 1.0 - r2 / (p.horizon * p.horizon));
      const double weight = (e.low ? 1.0 : -1.0) * fading * fading;
      for (int a = 0; a < d; a++) reference[a] += weight * (p.normal_low[a] + p.normal_high[a]);
    }
    for (const double one : reference) square += one * one;
    if (square > 0.0) {
      for (double &one : reference) one /= std::sqrt(square);
      d == 2 ? carried_normal<2>(H, reference, n) : carried_normal<3>(H, reference, n);
      const double trace = s[0] + s[1] + s[2];
      const double lateral = scene.pair->lateral_ratio(m.i) * std::min(0.0, trace);
      for (int a = 0; a < d; a++) load.stress[a] += lateral * (1.0 - n[a] * n[a]);
      load.stress[3] -= lateral * n[0] * n[1];
      load.stress[4] -= lateral * n[0] * n[2];
      load.stress[5] -= lateral * n[1] * n[2];
    }
    loads.push_back(load);
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::touches(std::vector<Touch> &found)
{
  follow(false);
  found.clear();
  for (const Member &m : list.members)
    for (const TMSPHContactMemory::Pressed &p : list.memory(m).pressed) {
      const int j = domain->closest_image(m.i, atom->map(p.partner));
      if (j >= 0) found.push_back({m.i, j, p.weight, p.distance});
    }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::rubbings(std::vector<Rubbing> &found)
{
  follow(false);
  found.clear();
  for (const Member &m : list.members) {
    double &rubbed = list.memory(m).rubbed;
    if (rubbed != 0.0) found.push_back({m.i, rubbed});
    rubbed = 0.0;
  }
}

/* ----------------------------------------------------------------------
   those of an evaluation and of the couples
------------------------------------------------------------------------- */

int FixTMSPHContact::doubles_per_ghost() const
{
  const int d = domain->dimension;
  const int rows = scene.segments ? SegmentRow::SIZE
      : d == 2                    ? ContactRow<2>::SIZE
                                  : ContactRow<3>::SIZE;
  return rows + d * d;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::pack_forward_comm(int n, int *sent, double *buf, int pbc_flag, int *pbc)
{
  const int size = ghosts.pack(n, sent, buf);
  const int velocities = forces.velocities_sent();
  if (velocities >= 0 && pbc_flag)
    scene.pair->box().add_rate(pbc, n, sent, buf + velocities, ghosts.count());
  return size;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::unpack_forward_comm(int n, int first, double *buf)
{
  ghosts.unpack(n, first, buf);
}

/* ----------------------------------------------------------------------
   energy stored in the contacts
------------------------------------------------------------------------- */

double FixTMSPHContact::compute_scalar()
{
  return totals.energy_of_all(world);
}

/* ----------------------------------------------------------------------
   1-3 force on the bodies of the lower type, 4-6 torque on them about the
   origin, 7 work lost by friction so far, 8 pairs that touch, 9 deepest penetration,
   10 sum of the normal forces
------------------------------------------------------------------------- */

double FixTMSPHContact::compute_vector(int n)
{
  return totals.of_all(n, world);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHContact::memory_usage()
{
  return list.bytes() + forces.bytes() + couples.bytes();
}
