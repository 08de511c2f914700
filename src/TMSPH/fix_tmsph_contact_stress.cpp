/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What contacts add to the virial and to the stress of particles.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "domain.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

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
   The pressure of pairs also pushes sideways in the material that it presses, which moves along
   with its neighbors: see lateral_ratio(). It acts along the mean normal of the pairs, and is the
   trace of their share.
------------------------------------------------------------------------- */

void FixTMSPHContact::add_shares(std::vector<Share> &shares)
{
  follow(false);
  const int d = domain->dimension;
  for (const Member &m : members) {
    const double *s = m.memory->stress, *H = pair->step_gradient() + (size_t) d * d * m.i;
    if (std::all_of(s, s + 6, [](double one) { return one == 0.0; })) continue;
    Share share = {m.i, segments != nullptr, {s[0], s[1], s[2], s[3], s[4], s[5]}};
    double reference[3] = {}, n[3] = {}, square = 0.0;
    for (int k = m.first; k < m.last; k++) {
      const PairGeometry &p = pairings[ends[k].pairing].pair;
      for (int a = 0; a < d; a++)
        reference[a] += (ends[k].low ? 1.0 : -1.0) * (p.normal_low[a] + p.normal_high[a]);
    }
    for (const double one : reference) square += one * one;
    if (square > 0.0) {
      for (double &one : reference) one /= std::sqrt(square);
      d == 2 ? carried_normal<2>(H, reference, n) : carried_normal<3>(H, reference, n);
      const double trace = s[0] + s[1] + s[2];
      const double lateral = pair->lateral_ratio(m.i) * std::min(0.0, trace);
      for (int a = 0; a < d; a++) share.stress[a] += lateral * (1.0 - n[a] * n[a]);
      share.stress[3] -= lateral * n[0] * n[1];
      share.stress[4] -= lateral * n[0] * n[2];
      share.stress[5] -= lateral * n[1] * n[2];
    }
    shares.push_back(share);
  }
}
