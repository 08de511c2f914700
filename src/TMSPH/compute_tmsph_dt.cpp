/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "compute_tmsph_dt.h"

#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "pair_tmsph.h"
#include "update.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

ComputeTMSPHDt::ComputeTMSPHDt(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), pair(nullptr)
{
  if (narg != 3)
    error->all(FLERR, "Unexpected word '{}' after compute tmsph/dt: it takes none", arg[3]);
  scalar_flag = 1;
  extscalar = 0;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHDt::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Compute tmsph/dt needs pair style tmsph");
}

/* ---------------------------------------------------------------------- */

double ComputeTMSPHDt::compute_scalar()
{
  invoked_scalar = update->ntimestep;
  pair = PairTMSPH::laid_out(lmp, "Compute tmsph/dt");
  scalar = pair->stable_timestep();
  return scalar;
}
