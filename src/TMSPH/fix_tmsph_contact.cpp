/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Forces of fix tmsph/contact. The law is in tmsph_contact_pair.h.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "tmsph_last_force.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

unsigned FixTMSPHContact::states() const
{
  const unsigned faces = 1u << FixTMSPHBond::BROKEN | 1u << FixTMSPHBond::CUT;
  return (segments ? 0u : 1u << FixTMSPHBond::UNBONDED) | (self ? faces : 0u);
}

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
  if (!resumed) next_search = 0;
  if (domain->dimension == 2)
    resumed ? apply_again<2>() : evaluate<2>(0.0);
  else
    resumed ? apply_again<3>() : evaluate<3>(0.0);
  add_virial();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::post_force(int vflag)
{
  v_init(vflag);
  follow(true);
  if (domain->dimension == 2)
    evaluate<2>(update->dt);
  else
    evaluate<3>(update->dt);
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
  if (domain->dimension == 2)
    evaluate<2>(0.0);
  else
    evaluate<3>(0.0);
  add_virial();
}

/* ---------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::apply_again()
{
  for (const Member &m : members)
    for (int a = 0; a < D; a++) atom->f[m.i][a] += m.memory->force[a];
  if (any_pairs || (segments && segments->any)) balance_couples<D>(false);
}

/* ----------------------------------------------------------------------
   Two passes over the pairs: which are active and how stiff all contacts of a
   particle are together, then the forces. Each particle sums them in the order
   of its partners' ids.
------------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::evaluate(double dt)
{
  using Row = ContactRow<D>;
  const double work = totals[WORK];
  std::fill(totals, totals + NTOTALS, 0.0);
  totals[WORK] = work;
  energy = 0.0;
  const bigint now = update->ntimestep;    // which reset_timestep may set back
  const bool search_due = now >= next_search || now < last_search || update->dt != search_dt;
  const bool facing = segments && segments->any;
  auto &states = std::get<D - 2>(states_of);
  states.resize(pairings.size());
  if (!any_pairs && !facing) {
    if (search_due) search<D>(states);
    return;
  }

  width = facing ? SegmentRow::WIDTH : Row::WIDTH;
  rows.resize((size_t) width * (atom->nlocal + atom->nghost));
  fill_rows<D>(dt > 0.0);
  velocities_sent = dt > 0.0 && pair->box().carries_velocities() ? Row::V : -1;
  send(0, Row::COMPLIANCE);
  velocities_sent = -1;

  const Kernel kernel = pair->kernel_of_bonds();
  const bool expands = pair->expands();
  if (!refits.empty()) keep_energy<D>();
  const auto at = [=](int p) { return end_at<D>(p, expands); };
  pressing.resize(pairings.size());
  for (size_t n = 0; n < pairings.size(); n++) {
    const Pairing &p = pairings[n];
    states[n] = contact_state<D>(p.pair, at(p.low), at(p.high), p.now, kernel, law.ahead(dt));
    pressing[n] = states[n].predicted > 0.0 ? states[n].stiffness : 0.0;
  }
  if (facing) find_places(dt);
  for (const Member &m : members) {
    double stiffness = facing ? segment_stiffness(m.i) : 0.0;
    for (int n = m.first; n < m.last; n++) stiffness += pressing[ends[n].pairing];
    rows[(size_t) width * m.i + Row::COMPLIANCE] = stiffness / atom->rmass[m.i];
  }
  send(Row::COMPLIANCE, 1);

  if (facing) hold_places(dt);

  // forces on the higher ends

  acts.resize(pairings.size());
  records_behind = true;
  std::vector<double> heats(pair->keeps_touches() ? pairings.size() : 0);
  for (size_t n = 0; n < pairings.size(); n++) {
    Pairing &p = pairings[n];
    ContactState<D> &s = states[n];
    Act &act = acts[n];
    const double frequency = rows[(size_t) width * p.low + Row::COMPLIANCE] +
        rows[(size_t) width * p.high + Row::COMPLIANCE];
    double heat = 0.0;
    if (frequency > 0.0) {
      s.stiffness =
          law.stiffness(s.stiffness, stiffness, s.stiffness / frequency, update->dt);
      s.shear_ratio = law.shear_ratio(s.shear_ratio);
    }
    const double normal =
        contact_force<D>(law, p.pair, s, frequency, dt, act.f, p.now, heat);
    std::copy_n(s.r, D, act.r);
    act.share = p.pair.share;
    const bool low = rows[(size_t) width * p.low + Row::BEARS] != 0.0;
    const bool high = rows[(size_t) width * p.high + Row::BEARS] != 0.0;
    act.borne[0] = !low ? 0.0 : high ? 0.5 : 1.0;    // as they turn the normal
    act.borne[1] = !high ? 0.0 : low ? 0.5 : 1.0;
    totals[WORK] += p.copy ? heat : 0.5 * heat;
    if (!heats.empty()) heats[n] = heat;
    totals[DEEPEST] = std::max(totals[DEEPEST], s.penetration);
    if (normal > 0.0 && p.low < atom->nlocal) {
      totals[TOUCHING] += 1.0;
      totals[NORMAL] += normal;
      energy += 0.5 * normal * normal / s.stiffness;
    }
  }

  for (const Member &m : members) {
    Effect counted, other;    // in the totals, or not
    if (facing) add_places(m.i, counted, other);
    for (int n = m.first; n < m.last; n++) {
      const End &e = ends[n];
      if (pressing[e.pairing] == 0.0) continue;
      const Act &act = acts[e.pairing];
      Effect &effect = atom->type[m.i] < atom->type[e.j] ? counted : other;
      effect.add<D>(e.low ? -1.0 : 1.0, e.low ? act.share : 1.0 - act.share,
                    act.borne[e.low ? 0 : 1], act.f, act.r, states[e.pairing].normal);
    }
    add_to_totals(m.i, counted);
    counted.add(other);
    acts_on(counted, m);
  }
  if (pair->keeps_touches()) keep_touches<D>(states, heats);
  balance_couples<D>(true);
  if (search_due) search<D>(states);
}

/* ----------------------------------------------------------------------
   what an evaluation tells of its particles, but for the compliance
   @param predicts else velocities and accelerations are 0
------------------------------------------------------------------------- */

template <int D> void FixTMSPHContact::fill_rows(bool predicts)
{
  using Row = ContactRow<D>;
  const double *gradient = pair->step_gradient();
  for (const Member &m : members) {
    double *row = rows.data() + (size_t) width * m.i;
    std::copy_n(gradient + (size_t) D * D * m.i, D * D, row + Row::H);
    std::fill_n(row + Row::V, 2 * D, 0.0);
    row[Row::BEARS] = pair->bears_stress<D>(m.i);
    row[Row::COMPLIANCE] = 0.0;
  }
  if (!predicts) return;
  const TMSPHLastForce::Prescribed prescribed(lmp, prescribing);
  for (const Member &m : members) {
    double *row = rows.data() + (size_t) width * m.i;
    for (int a = 0; a < D; a++) {
      row[Row::V + a] = atom->v[m.i][a];
      row[Row::A + a] = atom->f[m.i][a] / atom->rmass[m.i];
    }
  }
}

/* ----------------------------------------------------------------------
   force and torque on bodies of the lower type: the forces act at the surface, and
   x_i x f + couple is the torque that they have there
------------------------------------------------------------------------- */

void FixTMSPHContact::add_to_totals(int i, const Effect &effect)
{
  const double *x = atom->x[i], *f = effect.force;
  double couple[3];
  domain->dimension == 2 ? couple_of<2>(effect.tilt, couple) : couple_of<3>(effect.tilt, couple);
  for (int a = 0; a < 3; a++) {
    totals[FORCE + a] += f[a];
    totals[TORQUE + a] += x[(a + 1) % 3] * f[(a + 2) % 3] - x[(a + 2) % 3] * f[(a + 1) % 3] +
        couple[a];
  }
}

/* ----------------------------------------------------------------------
   the records of both ends, before they are needed: they are far apart in memory
------------------------------------------------------------------------- */

void FixTMSPHContact::write_back()
{
  if (!records_behind) return;
  records_behind = false;
  for (const Pairing &p : pairings) {
    *p.past = p.now;
    if (p.copy) *p.copy = p.now;
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::Effect::add(const Effect &other)
{
  for (int a = 0; a < 3; a++) force[a] += other.force[a];
  for (int k = 0; k < 6; k++) stress[k] += other.stress[k];
  for (int k = 0; k < 9; k++) tilt[k] += other.tilt[k];
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::acts_on(const Effect &effect, const Member &m)
{
  Memory &memory = *m.memory;
  for (int a = 0; a < domain->dimension; a++) atom->f[m.i][a] += effect.force[a];
  std::copy_n(effect.force, 3, memory.force);
  for (int k = 0; k < 6; k++) memory.stress[k] = effect.stress[k] / atom->vfrac[m.i];
  std::copy_n(effect.tilt, 9, memory.tilt);
}

/* ----------------------------------------------------------------------
   what heat needs of this evaluation
------------------------------------------------------------------------- */

template <int D>
void FixTMSPHContact::keep_touches(const std::vector<ContactState<D>> &states,
                                   const std::vector<double> &heats)
{
  for (const Member &m : members) {
    Memory &memory = *m.memory;
    memory.pressed.clear();
    for (int n = m.first; n < m.last; n++) {
      const End &e = ends[n];
      const Pairing &p = pairings[e.pairing];
      const ContactState<D> &s = states[e.pairing];
      double normal = 0.0;
      for (int a = 0; a < D; a++) normal += acts[e.pairing].f[a] * s.normal[a];
      if (pressing[e.pairing] == 0.0 || !(normal > 0.0)) continue;
      const double weight = s.weight * atom->vfrac[p.low] * atom->vfrac[p.high];
      memory.pressed.push_back({atom->tag[e.j], weight, p.pair.distance});
      memory.rubbed += 0.5 * heats[e.pairing];
    }
    if (segments && segments->any) keep_places(m.i, memory);
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::touches(std::vector<Touch> &list)
{
  follow(false);
  list.clear();
  for (const Member &m : members)
    for (const Pressed &p : m.memory->pressed) {
      const int j = domain->closest_image(m.i, atom->map(p.partner));
      if (j >= 0) list.push_back({m.i, j, p.weight, p.distance});
    }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::rubbings(std::vector<Rubbing> &list)
{
  follow(false);
  list.clear();
  for (const Member &m : members)
    if (m.memory->rubbed != 0.0) {
      list.push_back({m.i, m.memory->rubbed});
      m.memory->rubbed = 0.0;
    }
}

/* ----------------------------------------------------------------------
   those of evaluate() and of balance_couples()
------------------------------------------------------------------------- */

int FixTMSPHContact::doubles_per_ghost() const
{
  const int d = domain->dimension;
  const int rows = segments ? SegmentRow::WIDTH
      : d == 2              ? ContactRow<2>::WIDTH
                            : ContactRow<3>::WIDTH;
  return rows + d * d;
}

/* ----------------------------------------------------------------------
   columns first to first+count of all rows, from owners to ghosts
------------------------------------------------------------------------- */

void FixTMSPHContact::send(int first, int count)
{
  sent_first = first;
  sent_count = comm_forward = count;
  comm->forward_comm(this);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  for (int i = 0; i < n; i++)
    std::copy_n(rows.data() + (size_t) width * list[i] + sent_first, sent_count,
                buf + (size_t) sent_count * i);
  if (velocities_sent >= 0 && pbc_flag)
    pair->box().add_rate(pbc, n, list, buf + velocities_sent, sent_count);
  return n * sent_count;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::unpack_forward_comm(int n, int first, double *buf)
{
  for (int i = 0; i < n; i++)
    std::copy_n(buf + (size_t) sent_count * i, sent_count,
                rows.data() + (size_t) width * (first + i) + sent_first);
}

/* ----------------------------------------------------------------------
   energy stored in the contacts
------------------------------------------------------------------------- */

double FixTMSPHContact::compute_scalar()
{
  double all;
  MPI_Allreduce(&energy, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   1-3 force on the bodies of the lower type, 4-6 torque on them about the
   origin, 7 work lost by friction so far, 8 pairs that touch, 9 deepest penetration,
   10 sum of the normal forces
------------------------------------------------------------------------- */

double FixTMSPHContact::compute_vector(int n)
{
  double all;
  MPI_Allreduce(&totals[n], &all, 1, MPI_DOUBLE, n == DEEPEST ? MPI_MAX : MPI_SUM, world);
  return all;
}
