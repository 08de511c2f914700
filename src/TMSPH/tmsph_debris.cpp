/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_debris.h"

#include "atom.h"
#include "fix_tmsph_bond.h"
#include "neigh_list.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

static double length(const double *X)
{
  return std::sqrt(X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
}

/* ---------------------------------------------------------------------- */

void TMSPHDebris::measure(const FixTMSPHBond &bonds)
{
  const int nlocal = atom->nlocal;
  spacing.assign((size_t) nlocal + atom->nghost, 0.0);
  for (int i = 0; i < nlocal; i++) {
    double X[3];
    for (const auto &bond : bonds.family(i, FixTMSPHBond::ALL)) {
      bonds.reference_vector(i, bond.j, X);
      if (spacing[i] == 0.0 || length(X) < spacing[i]) spacing[i] = length(X);
    }
  }
}

/* ---------------------------------------------------------------------- */

bool TMSPHDebris::make(int i, int j, const FixTMSPHBond &bonds, Candidate &c) const
{
  double X[3];
  bonds.reference_vector(i, j, X);
  const double d = 0.5 * (spacing[i] + spacing[j]);
  if (d == 0.0) return false;
  const auto cell = [&](int p) { return young[atom->type[p]] * atom->vfrac[p] / (d * d); };
  c = {i, j, std::min(d, length(X)), 2.0 * cell(i) * cell(j) / (cell(i) + cell(j))};
  return true;
}

/* ---------------------------------------------------------------------- */

bool TMSPHDebris::may_touch(int i, int j) const
{
  const double reach = 0.5 * (spacing[i] + spacing[j]) + skin;
  double r2 = 0.0;
  for (int k = 0; k < 3; k++) {
    const double d = atom->x[j][k] - atom->x[i][k];
    r2 += d * d;
  }
  return r2 < reach * reach;
}

/* ---------------------------------------------------------------------- */

void TMSPHDebris::list_candidates(const NeighList &list, double neighbor_skin,
                                  const FixTMSPHBond &bonds)
{
  skin = neighbor_skin;
  candidates.clear();
  sorted = false;
  Candidate c;
  for (int ii = 0; ii < list.inum; ii++) {
    const int i = list.ilist[ii];
    for (int jj = 0; jj < list.numneigh[i]; jj++) {
      const int j = list.firstneigh[i][jj] & NEIGHMASK;
      if (may_touch(i, j) && !left_out(bonds.state_with(i, atom->tag[j])) && make(i, j, bonds, c))
        candidates.push_back(c);
    }
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHDebris::add(int i, int j, const FixTMSPHBond &bonds)
{
  Candidate c;
  if (left_out(bonds.state_with(i, atom->tag[j])) || !may_touch(i, j) || !make(i, j, bonds, c))
    return;
  candidates.push_back(c);
  sorted = false;
}

/* ----------------------------------------------------------------------
   each end sums its own forces in the order of the partners' ids
------------------------------------------------------------------------- */

double TMSPHDebris::repel(double *virial)
{
  touching = 0;
  if (candidates.empty()) return 0.0;
  const tagint *tag = atom->tag;
  if (!sorted) {
    std::sort(candidates.begin(), candidates.end(), [tag](const Candidate &p, const Candidate &q) {
      return p.i != q.i ? p.i < q.i : tag[p.j] < tag[q.j];
    });
    sorted = true;
  }
  double **x = atom->x, **f = atom->f;
  double energy = 0.0;
  for (const Candidate &c : candidates) {
    double d[3], r2 = 0.0;
    for (int k = 0; k < 3; k++) {
      d[k] = x[c.j][k] - x[c.i][k];
      r2 += d[k] * d[k];
    }
    if (r2 >= c.distance * c.distance || r2 == 0.0) continue;
    const double r = std::sqrt(r2), overlap = c.distance - r;
    const double scale = c.stiffness * overlap / r;
    touching++;
    energy += 0.25 * c.stiffness * overlap * overlap;
    for (int k = 0; k < 3; k++) f[c.i][k] -= scale * d[k];
    if (virial) {
      for (int k = 0; k < 3; k++) virial[k] += 0.5 * scale * d[k] * d[k];
      virial[3] += 0.5 * scale * d[0] * d[1];
      virial[4] += 0.5 * scale * d[0] * d[2];
      virial[5] += 0.5 * scale * d[1] * d[2];
    }
  }
  return energy;
}
