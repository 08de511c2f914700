/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   States of the particles that a run cannot go on from.
------------------------------------------------------------------------- */

#include "tmsph_stop.h"

#include "atom.h"
#include "error.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   local particle i has no deformation gradient, or one that is inside out:
   if a number is missing, tell whose
------------------------------------------------------------------------- */

void LAMMPS_NS::stop_inverted(LAMMPS *lmp, const FixTMSPHBond &bonds, int i)
{
  const Atom *const atom = lmp->atom;
  const Update *const update = lmp->update;
  Error *const error = lmp->error;
  const auto finite = [atom](int p) {
    const double *x = atom->x[p];
    return std::isfinite(x[0] + x[1] + x[2]);
  };
  int culprit = finite(i) ? -1 : i;
  for (const auto &bond : bonds.family(i, FixTMSPHBond::ALL))
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

void LAMMPS_NS::stop_thermal(LAMMPS *lmp, const TMSPHMaterials &materials)
{
  const Atom *const atom = lmp->atom;
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    const double strain = materials.thermal_strain(i);
    if (!(strain > -1.0))
      lmp->error->one(FLERR,
                      "Particle {} has temperature {} and a thermal strain of {} on step {}: check "
                      "its temperature, and 'expansion' and 'reference' in pair_coeff",
                      atom->tag[i], atom->temperature[i], strain, lmp->update->ntimestep);
  }
}
