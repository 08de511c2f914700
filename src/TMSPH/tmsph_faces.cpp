/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_faces.h"

#include "fix.h"
#include "modify.h"

#include <algorithm>
#include <string>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

bool TMSPHFaces::possible(LAMMPS *lmp)
{
  const auto &fixes = lmp->modify->get_fix_list();
  return std::any_of(fixes.begin(), fixes.end(), [](const Fix *fix) {
    const auto breaking = dynamic_cast<const TMSPHOpensBonds *>(fix);
    return breaking && breaking->softens();
  });
}

/* ---------------------------------------------------------------------- */

void TMSPHFaces::provide(LAMMPS *lmp)
{
  Modify *const modify = lmp->modify;
  const bool own = modify->get_fix_by_id(ID);
  const bool given = modify->get_fix_by_style("^tmsph/contact$").size() > (own ? 1u : 0u);
  const bool wanted = !given && possible(lmp);
  if (own && !wanted) modify->delete_fix(ID);
  if (!own && wanted) modify->add_fix(std::string(ID) + " all tmsph/contact")->thermo_energy = 1;
}
