/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   States of the particles, and of an input between runs, that pair style tmsph cannot go on from.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   local particle i has no deformation gradient, or one that is inside out:
   if a number is missing, tell whose
------------------------------------------------------------------------- */

void PairTMSPH::stop_inverted(int i)
{
  const auto finite = [this](int p) {
    const double *x = atom->x[p];
    return std::isfinite(x[0] + x[1] + x[2]);
  };
  int culprit = finite(i) ? -1 : i;
  for (const auto &bond : bond_fix->family(i, FixTMSPHBond::ALL))
    if (culprit < 0 && !finite(bond.j)) culprit = bond.j;
  if (culprit >= 0)
    error->one(FLERR,
               "The position of particle {} is not a number on step {}: check its velocity and "
               "what acts on it",
               atom->tag[culprit], update->ntimestep);
  const double *x = atom->x[i];
  if (update->whichflag == 2 && strcmp(update->minimize_style, "tmsph/lbfgs") != 0)
    error->one(FLERR,
               "Particle {} is turned inside out in iteration {} of min_style {}, which moves "
               "particles too far: use 'min_style tmsph/lbfgs'",
               atom->tag[i], update->ntimestep, update->minimize_style);
  if (update->whichflag == 2)
    error->one(FLERR,
               "Particle {} at ({:.8g}, {:.8g}, {:.8g}) is turned inside out on step {} while "
               "equilibrium is looked for: apply the load in smaller steps",
               atom->tag[i], x[0], x[1], x[2], update->ntimestep);
  error->one(FLERR,
             "Particle {} at ({:.8g}, {:.8g}, {:.8g}) is turned inside out on step {}: the load "
             "is too fast, the time step too long, or the material must be allowed to break (fix "
             "tmsph/hoekbrown)",
             atom->tag[i], x[0], x[1], x[2], update->ntimestep);
}

/* ----------------------------------------------------------------------
   a strain of -1 leaves nothing of the particle
------------------------------------------------------------------------- */

void PairTMSPH::stop_thermal()
{
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    const double strain = thermal_strain(i);
    if (!(strain > -1.0))
      error->one(FLERR,
                 "Particle {} has temperature {} and a thermal strain of {} on step {}: check its "
                 "temperature, and 'expansion' and 'reference' in pair_coeff",
                 atom->tag[i], atom->temperature[i], strain, update->ntimestep);
  }
}

/* ---------------------------------------------------------------------- */

PairTMSPH *PairTMSPH::laid_out(LAMMPS *lmp, const std::string &who)
{
  auto pair = dynamic_cast<PairTMSPH *>(lmp->force->pair_match("^tmsph", 0));
  if (!pair) lmp->error->all(FLERR, "{} needs pair style tmsph", who);
  if (!pair->bond_fix || !pair->bond_fix->formed())
    lmp->error->all(FLERR, "{} before the bonds formed: do a run first", who);
  pair->bond_fix->need_layout(who);
  pair->the_box.meet_output();
  return pair;
}
