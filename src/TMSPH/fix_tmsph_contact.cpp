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

// what a step tells of each particle: F - I, velocity, acceleration, compliance Kc/m

template <int D> struct ContactRow {
  static constexpr int H = 0, V = D * D, A = V + D, COMPLIANCE = A + D, WIDTH = COMPLIANCE + 1;
};

/* ---------------------------------------------------------------------- */

unsigned FixTMSPHContact::states() const
{
  const unsigned faces = 1u << FixTMSPHBond::BROKEN | 1u << FixTMSPHBond::CUT;
  return 1u << FixTMSPHBond::UNBONDED | (self ? faces : 0u);
}

/* ----------------------------------------------------------------------
   a continued run repeats the forces of its last step: at a setup velocities
   are those of the full step, and the law took those of half a step before
------------------------------------------------------------------------- */

void FixTMSPHContact::setup_pre_force(int)
{
  resumed = TMSPHLastForce::untouched(atom, memories, world);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::post_run()
{
  TMSPHLastForce::stamp(atom, memories);
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
  const bool search_due = update->ntimestep >= next_search || update->dt != search_dt;
  std::vector<ContactState<D>> states(pairings.size());
  if (!any_pairs) {
    if (search_due) search<D>(states);
    return;
  }

  width = Row::WIDTH;
  rows.resize((size_t) width * (atom->nlocal + atom->nghost));
  const double *gradient = pair->step_gradient();
  for (const Member &m : members) {
    double *row = rows.data() + (size_t) width * m.i;
    std::copy_n(gradient + (size_t) D * D * m.i, D * D, row + Row::H);
    for (int a = 0; a < D; a++) {
      row[Row::V + a] = dt > 0.0 ? atom->v[m.i][a] : 0.0;
      row[Row::A + a] = dt > 0.0 ? atom->f[m.i][a] / atom->rmass[m.i] : 0.0;
    }
    row[Row::COMPLIANCE] = 0.0;
  }
  send(0, Row::COMPLIANCE);

  const Kernel kernel = pair->kernel_of_bonds();
  const double horizon = pair->horizon();
  const auto at = [&](int p) {
    const double *row = rows.data() + (size_t) width * p;
    return ContactEnd<D>{atom->x[p], row + Row::V, row + Row::A, row + Row::H,
                         pair->thermal_strain(p)};
  };
  for (size_t n = 0; n < pairings.size(); n++) {
    const Pairing &p = pairings[n];
    states[n] = contact_state<D>(p.pair, at(p.low), at(p.high), p.moved, kernel, horizon, dt);
  }
  for (const Member &m : members) {
    double stiffness = 0.0;
    for (int n = m.first; n < m.last; n++) {
      const ContactState<D> &s = states[ends[n].pairing];
      if (s.predicted > 0.0) stiffness += s.stiffness;
    }
    rows[(size_t) width * m.i + Row::COMPLIANCE] = stiffness / atom->rmass[m.i];
  }
  send(Row::COMPLIANCE, 1);

  // forces on the higher ends

  std::vector<double> forces(pairings.size() * D), heats(pair->keeps_touches() ? pairings.size() : 0);
  for (size_t n = 0; n < pairings.size(); n++) {
    const Pairing &p = pairings[n];
    const ContactState<D> &s = states[n];
    const double compliance = rows[(size_t) width * p.low + Row::COMPLIANCE] +
        rows[(size_t) width * p.high + Row::COMPLIANCE];
    double heat = 0.0;
    double *moved = p.moved;
    const double before[2] = {moved[0], moved[1]};
    const double normal = contact_force<D>(p.pair, s, dt * dt * compliance, forces.data() + n * D,
                                           moved, heat);
    if (p.copy && !std::equal(before, before + 2, moved)) std::copy_n(moved, 2, p.copy);
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
    Memory &memory = *m.memory;
    double force[3] = {}, stress[6] = {}, couple[3] = {};
    for (int n = m.first; n < m.last; n++) {
      const End &e = ends[n];
      const ContactPair &pair = pairings[e.pairing].pair;
      double f[3] = {}, r[3] = {};
      std::copy_n(forces.data() + (size_t) e.pairing * D, D, f);
      std::copy_n(states[e.pairing].r, D, r);
      const double sign = e.low ? -1.0 : 1.0, share = e.low ? pair.share : 1.0 - pair.share;
      const double part = 0.25 + 0.5 * share;    // of the stress: by depth and evenly, the mean
      for (int a = 0; a < 3; a++) {
        force[a] += sign * f[a];
        couple[a] -= share * (r[(a + 1) % 3] * f[(a + 2) % 3] - r[(a + 2) % 3] * f[(a + 1) % 3]);
        stress[a] -= part * f[a] * r[a];
        stress[3 + a] -= 0.5 * part * (a < 2 ? f[0] * r[a + 1] + f[a + 1] * r[0]
                                             : f[1] * r[2] + f[2] * r[1]);
      }
      if (atom->type[m.i] < atom->type[e.j])
        for (int a = 0; a < 3; a++) {
          const int b = (a + 1) % 3, c = (a + 2) % 3;
          const auto at_surface = [&](int k) { return atom->x[m.i][k] - sign * share * r[k]; };
          totals[FORCE + a] += sign * f[a];
          totals[TORQUE + a] += sign * (at_surface(b) * f[c] - at_surface(c) * f[b]);
        }
    }
    const double volume = atom->vfrac[m.i];
    for (int a = 0; a < D; a++) atom->f[m.i][a] += force[a];
    std::copy_n(force, 3, memory.force);
    for (int k = 0; k < 6; k++) memory.stress[k] = stress[k] / volume;
    std::copy_n(memory.couple, 3, memory.couple_before);
    std::copy_n(couple, 3, memory.couple);
  }
  if (pair->keeps_touches()) keep_touches<D>(states, forces, heats);
  if (search_due) search<D>(states);
}

/* ----------------------------------------------------------------------
   what heat needs of this evaluation
------------------------------------------------------------------------- */

template <int D>
void FixTMSPHContact::keep_touches(const std::vector<ContactState<D>> &states,
                                   const std::vector<double> &forces,
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
      for (int a = 0; a < D; a++) normal += forces[(size_t) e.pairing * D + a] * s.normal[a];
      if (!(normal > 0.0)) continue;
      const double weight =
          s.stiffness / p.pair.stiffness * atom->vfrac[p.low] * atom->vfrac[p.high];
      memory.pressed.push_back({atom->tag[e.j], weight, p.pair.distance});
      memory.rubbed += 0.5 * heats[e.pairing];
    }
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

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::add_virial()
{
  if (!vflag_global && !vflag_atom) return;
  for (const Member &m : members)
    for (int k = 0; k < 6; k++) {
      const double v = -atom->vfrac[m.i] * m.memory->stress[k];
      if (vflag_global) virial[k] += v;
      if (vflag_atom) vatom[m.i][k] += v;
    }
}

/* ----------------------------------------------------------------------
   Pair forces off the line of centres turn a pair. The bonds of both ends
   balance that in the next force evaluation, without which a free body would have no
   equilibrium; in a repeated step as they did then.
------------------------------------------------------------------------- */

const std::vector<PairTMSPH::Contact::Couple> &FixTMSPHContact::couples()
{
  follow(false);
  couple_list.clear();
  if (update->setupflag && !resumed) return couple_list;
  for (const Member &m : members) {
    const double *c = update->setupflag ? m.memory->couple_before : m.memory->couple;
    couple_list.push_back({m.i, {c[0], c[1], c[2]}});
  }
  return couple_list;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::add_stress(double *stress)
{
  follow(false);
  const int size = pair->stress_size();
  for (const Member &m : members) {
    double *row = stress + (size_t) size * m.i;
    const double *mine = m.memory->stress;
    if (size == 3) {
      row[0] += mine[0];
      row[1] += mine[1];
      row[2] += mine[3];
    } else
      for (int k = 0; k < 6; k++) row[k] += mine[k];
  }
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

int FixTMSPHContact::pack_forward_comm(int n, int *list, double *buf, int, int *)
{
  for (int i = 0; i < n; i++)
    buf = std::copy_n(rows.data() + (size_t) width * list[i] + sent_first, sent_count, buf);
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
