/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_suspects.h"

#include "fix_tmsph_bond.h"
#include "tmsph_rocks.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void TMSPHSuspects::lay_out(const FixTMSPHBond &bonds, const TMSPHRocks &rocks, const Atom &atom)
{
  border.assign(atom.nlocal, INSIDE);
  for (int i = 0; i < atom.nlocal; i++)
    for (const auto &bond : bonds.family(i, FixTMSPHBond::WHOLE)) {
      if (bond.j >= atom.nlocal) border[i] = std::max<char>(border[i], BESIDE_GHOSTS);
      if (!rocks.alike(atom.type[i], atom.type[bond.j])) border[i] = MIXED;
    }
}

/* ---------------------------------------------------------------------- */

void TMSPHSuspects::find_tested(const FixTMSPHBond &bonds)
{
  const int nlocal = border.size();
  const bool ghosts_too =
      std::any_of(suspect.begin() + nlocal, suspect.end(), [](char one) { return one != 0; });
  tested.assign(nlocal, 0);
  for (int i = 0; i < nlocal; i++) {
    if (suspect[i])
      for (const auto &bond : bonds.family(i, FixTMSPHBond::WHOLE))
        if (bond.j < nlocal) tested[bond.j] = 1;
    if (suspect[i] || border[i] == MIXED || (border[i] == BESIDE_GHOSTS && ghosts_too))
      tested[i] = 1;
  }
}
