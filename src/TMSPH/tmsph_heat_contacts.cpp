/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_contacts.h"

#include "atom.h"
#include "error.h"
#include "tmsph_conduction.h"
#include "tmsph_conduction_norms.h"
#include "tmsph_heat_materials.h"
#include "tmsph_participants.h"
#include "tmsph_words.h"

#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

TMSPHHeatContacts::TMSPHHeatContacts(LAMMPS *lmp) :
    Pointers(lmp), gap(atom->ntypes + 1, std::vector<double>(atom->ntypes + 1, 0.0))
{
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatContacts::read(TMSPHValues &values)
{
  int ilo, ihi, jlo, jhi;
  values.types(ilo, ihi);
  values.types(jlo, jhi);
  const double h =
      values.number(TMSPHRule::not_negative,
                    "must not be negative: it is the conductance of a closed crack per area");
  for (int i = ilo; i <= ihi; i++)
    for (int j = jlo; j <= jhi; j++) gap[i][j] = gap[j][i] = h;
  crosses = crosses || h > 0.0;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatContacts::init(TMSPHParticipants *style)
{
  others = style;
  if (crosses || friction) others->heat_crosses_contacts();
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatContacts::check() const
{
  if ((crosses || friction) && !others->contact_of_surfaces())
    error->all(FLERR, "Fix tmsph/heat {} needs to know what touches: add a fix tmsph/contact",
               crosses ? "contact" : "friction");
}

/* ----------------------------------------------------------------------
   Through pairs that press on each other: the area A = 2 c W D of the surface
   that is theirs, as for bonds across a plane, and on it in series both half
   distances and the gap.
------------------------------------------------------------------------- */

void TMSPHHeatContacts::find_bridges(const TMSPHHeatMaterials &materials,
                                     const TMSPHConductionNorms &norms)
{
  found.clear();
  if (!crosses) return;
  std::vector<TMSPHSurfaceContact::Touch> touches;
  others->contact_of_surfaces()->touches(touches);
  for (const auto &t : touches) {
    const double h = gap[atom->type[t.i]][atom->type[t.j]];
    if (h == 0.0) continue;
    const double area = (norms.norm(t.i) + norms.norm(t.j)) * t.weight * t.distance;
    const double k =
        TMSPH::harmonic_mean(materials.conductivity_of(t.i), materials.conductivity_of(t.j));
    const double resistance = t.distance / k + 1.0 / h;
    found.push_back({t.i, t.j, area / resistance});
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatContacts::collect_friction()
{
  if (!friction) return;
  std::vector<TMSPHSurfaceContact::Rubbing> rubbings;
  others->contact_of_surfaces()->rubbings(rubbings);
  rubbed.clear();
  for (const auto &r : rubbings) rubbed.push_back({r.i, r.work});
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatContacts::list_friction(double duration, std::vector<TMSPHHeatExchange> &list) const
{
  for (const Rubbed &r : rubbed) list.push_back({r.i, 0.0, 0.0, r.energy / duration});
}
