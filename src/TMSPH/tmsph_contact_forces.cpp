/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   One evaluation of all contacts. The law is in tmsph_contact_pair.h.
------------------------------------------------------------------------- */

#include "tmsph_contact_forces.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_last_force.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void TMSPHContactForces::init()
{
  prescribing = TMSPHLastForce::prescribing(lmp);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::evaluate(TMSPHContactPlaces *places, double dt)
{
  using Row = ContactRow<D>;
  const int width = places ? SegmentRow::SIZE : Row::SIZE;
  if (row.columns() != width) row.set_columns(width);
  row.resize(atom->nlocal + atom->nghost);
  fill_rows<D>(dt > 0.0);
  velocities = dt > 0.0 && scene.pair->box().carries_velocities() ? Row::V : -1;
  ghosts.send(row, 0, Row::COMPLIANCE);
  velocities = -1;

  if (!list.refits.empty()) keep_energy<D>();
  predict<D>(dt);
  if (places) places->find(dt);
  find_compliances(places);
  ghosts.send(row, Row::COMPLIANCE, 1);
  if (places) places->hold(dt);
  act<D>(dt);
  gather<D>(places);
  if (scene.pair->keeps_touches()) keep_touches<D>(places);
}

/* ----------------------------------------------------------------------
   what an evaluation tells of its particles, but for the compliance
   @param predicts else velocities and accelerations are 0
------------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::fill_rows(bool predicts)
{
  using Row = ContactRow<D>;
  const double *gradient = scene.pair->step_gradient();
  for (const Member &m : list.members) {
    double *mine = row[m.i];
    std::copy_n(gradient + (size_t) D * D * m.i, D * D, mine + Row::H);
    std::fill_n(mine + Row::V, 2 * D, 0.0);
    mine[Row::BEARS] = scene.pair->bears_stress<D>(m.i);
    mine[Row::COMPLIANCE] = 0.0;
  }
  if (!predicts) return;
  const TMSPHLastForce::Prescribed prescribed(lmp, prescribing);
  for (const Member &m : list.members) {
    double *mine = row[m.i];
    for (int a = 0; a < D; a++) {
      mine[Row::V + a] = atom->v[m.i][a];
      mine[Row::A + a] = atom->f[m.i][a] / atom->rmass[m.i];
    }
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::predict(double dt)
{
  const Kernel kernel = scene.pair->kernel_of_bonds();
  const bool expands = scene.pair->expands();
  const auto at = [=](int p) { return end_at<D>(p, expands); };
  const std::vector<Pairing> &pairings = list.pairings;
  auto &states = std::get<D - 2>(states_of);
  states.resize(pairings.size());
  pressing.resize(pairings.size());
  for (size_t n = 0; n < pairings.size(); n++) {
    const Pairing &p = pairings[n];
    states[n] = contact_state<D>(p.pair, at(p.low), at(p.high), p.now, kernel, scene.law.ahead(dt));
    pressing[n] = states[n].predicted > 0.0 ? states[n].stiffness : 0.0;
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHContactForces::find_compliances(const TMSPHContactPlaces *places)
{
  const int column = domain->dimension == 2 ? ContactRow<2>::COMPLIANCE : ContactRow<3>::COMPLIANCE;
  for (const Member &m : list.members) {
    double stiffness = places ? places->stiffness(m.i) : 0.0;
    for (int n = m.first; n < m.last; n++) stiffness += pressing[list.ends[n].pairing];
    row[m.i][column] = stiffness / atom->rmass[m.i];
  }
}

/* ----------------------------------------------------------------------
   forces on the higher ends
------------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::act(double dt)
{
  using Row = ContactRow<D>;
  using Totals = TMSPHContactTotals;
  std::vector<Pairing> &pairings = list.pairings;
  auto &states = std::get<D - 2>(states_of);
  const ContactLaw law = scene.law;
  acts.resize(pairings.size());
  list.run_ahead();
  heats.assign(scene.pair->keeps_touches() ? pairings.size() : 0, 0.0);
  for (size_t n = 0; n < pairings.size(); n++) {
    Pairing &p = pairings[n];
    ContactState<D> &s = states[n];
    Act &act = acts[n];
    const double *low = row[p.low], *high = row[p.high];
    const double frequency = low[Row::COMPLIANCE] + high[Row::COMPLIANCE];
    double heat = 0.0;
    if (frequency > 0.0) {
      s.stiffness =
          law.stiffness(s.stiffness, scene.stiffness, s.stiffness / frequency, update->dt);
      s.shear_ratio = law.shear_ratio(s.shear_ratio);
    }
    const double normal = contact_force<D>(law, p.pair, s, frequency, dt, act.f, p.now, heat);
    std::copy_n(s.r, D, act.r);
    act.depth = p.pair.depth;
    const bool low_bears = low[Row::BEARS] != 0.0, high_bears = high[Row::BEARS] != 0.0;
    act.borne[0] = !low_bears ? 0.0 : high_bears ? 0.5 : 1.0;    // as they turn the normal
    act.borne[1] = !high_bears ? 0.0 : low_bears ? 0.5 : 1.0;
    totals[Totals::WORK] += p.both_local ? heat : 0.5 * heat;
    if (!heats.empty()) heats[n] = heat;
    totals[Totals::DEEPEST] = std::max(totals[Totals::DEEPEST], s.penetration);
    if (normal > 0.0 && p.low < atom->nlocal) {
      totals[Totals::TOUCHING] += 1.0;
      totals[Totals::NORMAL] += normal;
      totals.energy += 0.5 * normal * normal / s.stiffness;
    }
  }
}

/* ----------------------------------------------------------------------
   by each member from its places and ends
------------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::gather(const TMSPHContactPlaces *places)
{
  const auto &states = std::get<D - 2>(states_of);
  for (const Member &m : list.members) {
    ContactEffect counted, other;    // in the totals, or not
    if (places) places->add(m.i, counted, other);
    for (int n = m.first; n < m.last; n++) {
      const End &e = list.ends[n];
      if (pressing[e.pairing] == 0.0) continue;
      const Act &act = acts[e.pairing];
      ContactEffect &effect = atom->type[m.i] < atom->type[e.j] ? counted : other;
      effect.add<D>(e.low ? -1.0 : 1.0, e.low ? act.depth : 1.0 - act.depth,
                    act.borne[e.low ? 0 : 1], act.f, act.r, states[e.pairing].normal);
    }
    add_to_totals<D>(m.i, counted);
    counted.add(other);
    take(m, counted);
  }
}

/* ----------------------------------------------------------------------
   force and torque on bodies of the lower type: the forces act at the surface, and
   x_i x f + couple is the torque that they have there
------------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::add_to_totals(int i, const ContactEffect &effect)
{
  using Totals = TMSPHContactTotals;
  const double *x = atom->x[i], *f = effect.force;
  double couple[3];
  couple_of<D>(effect.tilt, couple);
  for (int a = 0; a < 3; a++) {
    totals[Totals::FORCE + a] += f[a];
    totals[Totals::TORQUE + a] +=
        x[(a + 1) % 3] * f[(a + 2) % 3] - x[(a + 2) % 3] * f[(a + 1) % 3] + couple[a];
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHContactForces::take(const Member &m, const ContactEffect &effect)
{
  TMSPHContactMemory &memory = list.memory(m);
  for (int a = 0; a < domain->dimension; a++) atom->f[m.i][a] += effect.force[a];
  std::copy_n(effect.force, 3, memory.force);
  for (int k = 0; k < 6; k++) memory.stress[k] = effect.stress[k] / atom->vfrac[m.i];
  std::copy_n(effect.tilt, 9, memory.tilt);
}

/* ----------------------------------------------------------------------
   what heat needs of this evaluation
------------------------------------------------------------------------- */

template <int D> void TMSPHContactForces::keep_touches(const TMSPHContactPlaces *places)
{
  const auto &states = std::get<D - 2>(states_of);
  for (const Member &m : list.members) {
    TMSPHContactMemory &memory = list.memory(m);
    memory.pressed.clear();
    for (int n = m.first; n < m.last; n++) {
      const End &e = list.ends[n];
      const Pairing &p = list.pairings[e.pairing];
      const ContactState<D> &s = states[e.pairing];
      double normal = 0.0;
      for (int a = 0; a < D; a++) normal += acts[e.pairing].f[a] * s.normal[a];
      if (pressing[e.pairing] == 0.0 || !(normal > 0.0)) continue;
      const double weight = s.weight * atom->vfrac[p.low] * atom->vfrac[p.high];
      memory.pressed.push_back({atom->tag[e.j], weight, p.pair.distance});
      memory.rubbed += 0.5 * heats[e.pairing];
    }
    if (places) places->keep_touches(m.i, memory);
  }
}

// for fix_tmsph_contact.cpp

template void TMSPHContactForces::evaluate<2>(TMSPHContactPlaces *, double);
template void TMSPHContactForces::evaluate<3>(TMSPHContactPlaces *, double);
