/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Outlines of bodies in 2-D, and which particles may touch them.
------------------------------------------------------------------------- */

#include "tmsph_contact_outlines.h"

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

// segments are not longer than this many times their largest length in the reference: bonds of rock
// break at strains of 1e-3; what is longer is an error where a ghost is missing

static constexpr double STRETCHED = 1.25;

// spacings that differ by less are equal: volumes lose 5e-8 or less in files of 8 digits

static constexpr double SAME = 1.0e-6;

// a particle is at least so many spacings from the outline of another body; 0 is none in reach;
// round-off

static constexpr double NOT_APART = 1.0e-9;

/* ----------------------------------------------------------------------
   the finer side touches the outline of the other; of equals, the lower type
------------------------------------------------------------------------- */

bool TMSPHContactOutlines::is_guest(int itype, int jtype) const
{
  if (scene.pair->bonded(itype, jtype)) return false;
  const double mine = spacing[itype], other = spacing[jtype];
  if (mine < (1.0 - SAME) * other) return true;
  return mine <= (1.0 + SAME) * other && itype < jtype;
}

/* ---------------------------------------------------------------------- */

void TMSPHContactOutlines::find_spacings()
{
  std::vector<double> mine(atom->ntypes + 1, HUGE_VAL);
  for (int i = 0; i < atom->nlocal; i++)
    mine[atom->type[i]] = std::min(mine[atom->type[i]], scene.bonds->spacing(i));
  spacing.resize(mine.size());
  MPI_Allreduce(mine.data(), spacing.data(), (int) mine.size(), MPI_DOUBLE, MPI_MIN, world);
  coarsest = 0.0;
  for (double of_type : spacing)
    if (of_type < HUGE_VAL) coarsest = std::max(coarsest, of_type);
}

/* ----------------------------------------------------------------------
   from the reference families, broken bonds included: pieces keep the outline
   of their body
------------------------------------------------------------------------- */

void TMSPHContactOutlines::find()
{
  const FixTMSPHBond &bonds = *scene.bonds;
  const int nlocal = atom->nlocal, nall = nlocal + atom->nghost;
  find_spacings();
  next.assign(nall, {0, 0});
  for (int i = 0; i < nlocal; i++) {
    if (!(atom->mask[i] & scene.groupbit)) continue;
    OutlineSegments outline;
    std::vector<int> ends;
    for (const auto &bond : bonds.family(i, FixTMSPHBond::FORMED)) {
      double X[3];
      bonds.reference_vector(i, bond.j, X);
      outline.add(X);
      ends.push_back(bond.j);
    }
    int found = 0;
    for (int n = 0; n < (int) ends.size() && found < 2; n++) {
      const double larger = std::max(bonds.spacing(i), bonds.spacing(ends[n]));
      if (outline.leads_to(n, ROLLING * larger)) next[i][found++] = atom->tag[ends[n]];
    }
  }
  TMSPHGhostRows rows(2);
  rows.fill(nall, 0.0);
  for (int i = 0; i < nlocal; i++)
    for (int k = 0; k < 2; k++) rows[i][k] = ubuf(next[i][k]).d;
  ghosts.send(rows, 0, 2);
  for (int i = nlocal; i < nall; i++)
    for (int k = 0; k < 2; k++) next[i][k] = (tagint) ubuf(rows[i][k]).i;
  particles.clear();
  for (int i = 0; i < nall; i++)
    if (next[i][0]) particles.push_back(i);
  if (!measured) measure();
}

/* ----------------------------------------------------------------------
   how far particles are from the outline of another body in the reference
------------------------------------------------------------------------- */

void TMSPHContactOutlines::measure()
{
  const FixTMSPHBond &bonds = *scene.bonds;
  measured = true;
  static constexpr double HERE[2] = {};
  for (const int i : particles) {
    if (i >= atom->nlocal) continue;
    double nearest = HUGE_VAL;
    for (const auto &bond : bonds.family(i, FixTMSPHBond::ALL)) {
      const int j = bond.j;
      if (!is_guest(atom->type[i], atom->type[j])) continue;
      for (const tagint id : next[j]) {
        const int end = id ? domain->closest_image(j, atom->map(id)) : -1;
        if (end < 0) continue;
        double X[3], Y[3];
        bonds.reference_vector(i, j, X);
        bonds.reference_vector(j, end, Y);
        const double Z[2] = {X[0] + Y[0], X[1] + Y[1]};
        const double d = std::sqrt(square_from_segment(HERE, X, Z));
        if (d < std::min(nearest, 0.5 * (bonds.spacing(i) + bonds.spacing(j)))) nearest = d;
      }
    }
    if (nearest < HUGE_VAL)
      memories.of(atom->tag[i]).apart = std::max(nearest, NOT_APART * bonds.spacing(i));
  }
}

/* ----------------------------------------------------------------------
   how far a particle and an end of a segment that it touches may be apart
------------------------------------------------------------------------- */

double TMSPHContactOutlines::reach() const
{
  const double margin = scene.search_margin();
  const double reach = (2.0 * ROLLING * STRETCHED + OUTLINE_REACH) * coarsest + margin;
  const bool has_ghosts = comm->nprocs > 1 || domain->xperiodic || domain->yperiodic;
  if (has_ghosts && comm->get_comm_cutoff() < reach)
    error->all(FLERR,
               "The ghost cutoff {} is shorter than the {:.6g} that method segment of fix "
               "tmsph/contact needs on several processors or in a periodic box: raise it "
               "with comm_modify cutoff",
               comm->get_comm_cutoff(), reach);
  return reach;
}

/* ---------------------------------------------------------------------- */

void TMSPHContactOutlines::face()
{
  const int nlocal = atom->nlocal;
  const double within = reach();
  guests.clear();
  hosts.clear();
  chains.clear();
  nodes.clear();
  near.clear();
  guest_of.assign(nlocal, -1);
  host_of.assign(nlocal, -1);
  const Cells cells(atom->x, particles, within);
  const auto by_id = [this](int i, int j) { return atom->tag[i] < atom->tag[j]; };
  for (const int i : particles) {
    if (i >= nlocal) continue;
    std::vector<int> others;
    cells.near(atom->x[i], [&](int j) { others.push_back(j); });
    std::sort(others.begin(), others.end(), by_id);
    list_host(i, others, within);
    list_guest(i, others, within);
  }
  int mine = !guests.empty();
  int of_all;
  MPI_Allreduce(&mine, &of_all, 1, MPI_INT, MPI_MAX, world);
  any = of_all;
}

/* ----------------------------------------------------------------------
   those that local particle i of an outline may hold
   @param others near it, by ascending ids
------------------------------------------------------------------------- */

void TMSPHContactOutlines::list_host(int i, const std::vector<int> &others, double reach)
{
  const int first = near.size();
  for (const int j : others) {
    if (!is_guest(atom->type[j], atom->type[i])) continue;
    const double dx = atom->x[j][0] - atom->x[i][0], dy = atom->x[j][1] - atom->x[i][1];
    if (dx * dx + dy * dy < reach * reach) near.push_back(j);
  }
  if ((int) near.size() == first) return;
  host_of[i] = hosts.size();
  hosts.push_back({i, first, (int) near.size()});
}

/* ----------------------------------------------------------------------
   the segments that may hold local particle i, end to end
------------------------------------------------------------------------- */

void TMSPHContactOutlines::list_guest(int i, const std::vector<int> &others, double reach)
{
  const double margin = scene.search_margin();
  const double within = OUTLINE_REACH * coarsest + margin;
  std::vector<std::pair<int, int>> segments;
  for (const int j : others) {
    if (!is_guest(atom->type[i], atom->type[j])) continue;
    for (const tagint id : next[j]) {
      if (!id) continue;
      const double *a = atom->x[j], *x = atom->x[i];
      const double dx = a[0] - x[0], dy = a[1] - x[1];
      if (dx * dx + dy * dy >= reach * reach) continue;
      const int end = domain->closest_image(j, atom->map(id));
      if (end < 0)
        error->one(FLERR,
                   "Particle {} of an outline of fix tmsph/contact is out of reach on "
                   "step {}: raise the ghost cutoff with comm_modify cutoff",
                   id, update->ntimestep);
      if (square_from_segment(x, a, atom->x[end]) < within * within) segments.emplace_back(j, end);
    }
  }
  if (segments.empty()) return;
  Guest guest = {i, (int) chains.size(), 0};
  int node = nodes.size();
  for (const int length : chains_of(segments, nodes)) {
    chains.push_back({node, node + length});
    node += length;
  }
  guest.last = chains.size();
  guest_of[i] = guests.size();
  guests.push_back(guest);
}

/* ---------------------------------------------------------------------- */

bool TMSPHContactOutlines::faces(int i, double apart) const
{
  return guest_of[i] >= 0 || host_of[i] >= 0 || apart > 0.0;
}
