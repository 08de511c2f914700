/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Outlines of bodies in 2-D, and which particles may touch them: for method
   segment.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "tmsph_cells.h"
#include "tmsph_outline.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// segments are not longer than this many times their largest length in the reference

static constexpr double STRETCHED = 1.25;

// spacings that differ by less are equal

static constexpr double SAME = 1.0e-6;

// a particle is at least so many spacings from the outline of another body; 0 is none in reach

static constexpr double NOT_APART = 1.0e-9;

/* ----------------------------------------------------------------------
   the finer side touches the outline of the other; of equals, the lower type
------------------------------------------------------------------------- */

bool FixTMSPHContact::is_slave(int itype, int jtype) const
{
  if (pair->bonded(itype, jtype)) return false;
  const double mine = segments->spacing[itype], other = segments->spacing[jtype];
  if (mine < (1.0 - SAME) * other) return true;
  return mine <= (1.0 + SAME) * other && itype < jtype;
}

/* ----------------------------------------------------------------------
   from the reference families, broken bonds included: pieces keep the outline
   of their body
------------------------------------------------------------------------- */

void FixTMSPHContact::find_outlines()
{
  Segments &s = *segments;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  std::vector<double> spacing(atom->ntypes + 1, HUGE_VAL);
  for (int i = 0; i < nlocal; i++)
    spacing[atom->type[i]] = std::min(spacing[atom->type[i]], bonds->spacing(i));
  s.spacing.resize(spacing.size());
  MPI_Allreduce(spacing.data(), s.spacing.data(), (int) spacing.size(), MPI_DOUBLE, MPI_MIN, world);
  s.coarsest = 0.0;
  for (double of_type : s.spacing)
    if (of_type < HUGE_VAL) s.coarsest = std::max(s.coarsest, of_type);

  s.next.assign(nall, {0, 0});
  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    OutlineSegments outline;
    std::vector<int> ends;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::FORMED)) {
      double X[3];
      bonds->reference_vector(i, bond.j, X);
      outline.add(X);
      ends.push_back(bond.j);
    }
    int found = 0;
    for (int n = 0; n < (int) ends.size() && found < 2; n++) {
      const double larger = std::max(bonds->spacing(i), bonds->spacing(ends[n]));
      if (outline.leads_to(n, ROLLING * larger)) s.next[i][found++] = atom->tag[ends[n]];
    }
  }
  width = 2;
  rows.assign((size_t) width * nall, 0.0);
  for (int i = 0; i < nlocal; i++)
    for (int k = 0; k < 2; k++) rows[2 * i + k] = ubuf(s.next[i][k]).d;
  send(0, width);
  for (int i = nlocal; i < nall; i++)
    for (int k = 0; k < 2; k++) s.next[i][k] = (tagint) ubuf(rows[2 * i + k]).i;
  s.outline.clear();
  for (int i = 0; i < nall; i++)
    if (s.next[i][0]) s.outline.push_back(i);
}

/* ----------------------------------------------------------------------
   how far particles are from the outline of another body in the reference
------------------------------------------------------------------------- */

void FixTMSPHContact::measure()
{
  Segments &s = *segments;
  s.measured = true;
  static constexpr double HERE[2] = {};
  for (const int i : s.outline) {
    if (i >= atom->nlocal) continue;
    double nearest = HUGE_VAL;
    for (const auto &bond : bonds->family(i, FixTMSPHBond::ALL)) {
      const int j = bond.j;
      if (!is_slave(atom->type[i], atom->type[j])) continue;
      for (const tagint id : s.next[j]) {
        const int end = id ? domain->closest_image(j, atom->map(id)) : -1;
        if (end < 0) continue;
        double X[3], Y[3];
        bonds->reference_vector(i, j, X);
        bonds->reference_vector(j, end, Y);
        const double Z[2] = {X[0] + Y[0], X[1] + Y[1]};
        const double d = std::sqrt(square_from_segment(HERE, X, Z));
        if (d < std::min(nearest, 0.5 * (bonds->spacing(i) + bonds->spacing(j)))) nearest = d;
      }
    }
    if (nearest < HUGE_VAL)
      memories[atom->tag[i]].apart = std::max(nearest, NOT_APART * bonds->spacing(i));
  }
}

/* ----------------------------------------------------------------------
   who may touch what until the next search
------------------------------------------------------------------------- */

void FixTMSPHContact::face()
{
  Segments &s = *segments;
  const int nlocal = atom->nlocal;
  const double margin = SEARCH_MARGIN * pair->horizon();
  const double reach = (2.0 * ROLLING * STRETCHED + OUTLINE_REACH) * s.coarsest + margin;
  const bool ghosts = comm->nprocs > 1 || domain->xperiodic || domain->yperiodic;
  if (ghosts && comm->get_comm_cutoff() < reach)
    error->all(FLERR, "The ghost cutoff {} is shorter than the {:.6g} that method segment of fix "
                      "tmsph/contact needs on several processors or in a periodic box: raise it "
                      "with comm_modify cutoff", comm->get_comm_cutoff(), reach);

  s.slaves.clear();
  s.masters.clear();
  s.chains.clear();
  s.nodes.clear();
  s.near.clear();
  s.slave_of.assign(nlocal, -1);
  s.master_of.assign(nlocal, -1);
  const Cells cells(atom->x, s.outline, reach);
  const auto by_id = [this](int i, int j) { return atom->tag[i] < atom->tag[j]; };
  for (const int i : s.outline) {
    if (i >= nlocal) continue;
    const int type = atom->type[i];
    std::vector<int> others;
    cells.near(atom->x[i], [&](int j) { others.push_back(j); });
    std::sort(others.begin(), others.end(), by_id);
    std::vector<std::pair<int, int>> near;
    const int first = s.near.size();
    for (const int j : others) {
      if (is_slave(atom->type[j], type)) {
        const double dx = atom->x[j][0] - atom->x[i][0], dy = atom->x[j][1] - atom->x[i][1];
        if (dx * dx + dy * dy < reach * reach) s.near.push_back(j);
      }
      if (!is_slave(type, atom->type[j])) continue;
      for (const tagint id : s.next[j]) {
        if (!id) continue;
        const double *a = atom->x[j], *x = atom->x[i];
        const double dx = a[0] - x[0], dy = a[1] - x[1];
        if (dx * dx + dy * dy >= reach * reach) continue;
        const int end = domain->closest_image(j, atom->map(id));
        if (end < 0)
          error->one(FLERR, "Particle {} of an outline of fix tmsph/contact is out of reach on "
                            "step {}: raise the ghost cutoff with comm_modify cutoff", id,
                     update->ntimestep);
        const double within = OUTLINE_REACH * s.coarsest + margin;
        if (square_from_segment(x, a, atom->x[end]) < within * within) near.emplace_back(j, end);
      }
    }
    if ((int) s.near.size() > first) {
      s.master_of[i] = s.masters.size();
      s.masters.push_back({i, first, (int) s.near.size()});
    }
    if (near.empty()) continue;
    Slave slave = {};
    slave.i = i;
    slave.first = s.chains.size();
    int node = s.nodes.size();
    for (const int length : chains_of(near, s.nodes)) {
      s.chains.emplace_back(node, node + length);
      node += length;
    }
    slave.last = s.chains.size();
    s.slave_of[i] = s.slaves.size();
    s.slaves.push_back(slave);
  }
  int mine = !s.slaves.empty();
  int any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  s.any = any;
}

/* ---------------------------------------------------------------------- */

bool FixTMSPHContact::faces(int i, const Memory &before) const
{
  return segments->slave_of[i] >= 0 || segments->master_of[i] >= 0 || before.apart > 0.0;
}
