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

// particles share their stress in full when contact makes this part of it

static constexpr double PRESSED = 0.125;

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
   The share of a pair goes to its two ends, while what they pass on inside the body is spread
   over the horizon: stresses beside a cut would scatter by 15 % with its place in the lattice.
   Meant is their average with the kernel (Hardy, J. Chem. Phys. 76 (1982) 622). Particles that
   contacts press exchange stress with bonded neighbors of their type that are pressed too,
   V_i dS_i = sum_j V_i V_j W_ij p_i p_j (S_j - S_i), which keeps sum V S.
------------------------------------------------------------------------- */

void FixTMSPHContact::add_stress(double *stress)
{
  follow(false);
  if (!any_pairs && !(segments && segments->any)) return;
  const int size = pair->stress_size(), nlocal = atom->nlocal, dimension = domain->dimension;
  const int how_pressed = size;
  width = size + 1;
  rows.assign((size_t) width * (nlocal + atom->nghost), 0.0);
  const auto norm = [=](const double *s) {
    double square = 0.0;
    for (int k = 0; k < size; k++) square += (k < dimension ? 1.0 : 2.0) * s[k] * s[k];
    return std::sqrt(square);
  };
  for (const Member &m : members) {
    const double *s = m.memory->stress;
    const double flat[3] = {s[0], s[1], s[3]};
    const double *by_contact = size == 3 ? flat : s;
    double *mine = stress + (size_t) size * m.i;
    double *row = rows.data() + (size_t) width * m.i;
    const double pushed = norm(by_contact), bonded = norm(mine);
    for (int k = 0; k < size; k++) row[k] = mine[k] += by_contact[k];
    if (pushed > 0.0)
      row[how_pressed] = std::min(1.0, pushed / (PRESSED * (pushed + bonded)));
  }
  send(0, width);

  for (const Member &m : members) {
    const int i = m.i;
    const double *mine = rows.data() + (size_t) width * i;
    if (mine[how_pressed] == 0.0) continue;
    for (int k = 0; k < bonds->count(i); k++) {
      if (bonds->bond_state(i, k) != FixTMSPHBond::INTACT) continue;
      const int j = bonds->partner_index(i, k);
      const double *his = rows.data() + (size_t) width * j;
      if (his[how_pressed] == 0.0 || atom->type[j] != atom->type[i]) continue;
      const double share = mine[how_pressed] * his[how_pressed] / bonds->body_thickness() *
          bonds->kernel_mass(i, j, pair->horizon(atom->type[i], atom->type[i]));
      for (int l = 0; l < size; l++)
        stress[(size_t) size * i + l] += share * (his[l] - mine[l]);
    }
  }
}
