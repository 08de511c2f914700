/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The order of forces that predict the step from all others.
------------------------------------------------------------------------- */

#include "tmsph_last_force.h"

#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

using namespace LAMMPS_NS;

void TMSPHLastForce::refuse_later_forces(LAMMPS *lmp, const Fix *self)
{
  bool later = false;
  for (const auto &fix : lmp->modify->get_fix_list()) {
    if (later && (fix->setmask() & FixConst::POST_FORCE) && !utils::strmatch(fix->style, "^tmsph/"))
      lmp->error->all(FLERR,
                      "Fix {} of style {} acts after fix {} {}, which must know all other forces: "
                      "define it before", fix->id, fix->style, self->style, self->id);
    later = later || fix == self;
  }
}
