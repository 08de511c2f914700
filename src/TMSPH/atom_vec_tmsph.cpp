/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "atom_vec_tmsph.h"

#include "atom.h"
#include "error.h"

#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

AtomVecTMSPH::AtomVecTMSPH(LAMMPS *lmp) :
    AtomVec(lmp), rmass(nullptr), vfrac(nullptr), temperature(nullptr), damage(nullptr), x0(nullptr)
{
  molecular = Atom::ATOMIC;

  atom->rmass_flag = 1;
  atom->vfrac_flag = 1;
  atom->temperature_flag = 1;
  atom->heatflow_flag = 1;
  atom->damage_flag = 1;

  // bonds name their partners by id, so an atom map is always needed

  if (atom->map_user == Atom::MAP_NONE) atom->map_style = atom->map_user = Atom::MAP_YES;

  // ghosts get what never changes at borders; temperature is kept current by who changes it

  fields_grow = {"rmass", "vfrac", "x0", "temperature", "heatflow", "damage"};
  fields_copy = {"rmass", "vfrac", "x0", "temperature", "heatflow", "damage"};
  fields_border = {"rmass", "vfrac", "x0", "temperature"};
  fields_border_vel = {"rmass", "vfrac", "x0", "temperature"};
  fields_exchange = {"rmass", "vfrac", "x0", "temperature", "heatflow", "damage"};
  fields_restart = {"rmass", "vfrac", "x0", "temperature", "heatflow", "damage"};
  fields_create = {"rmass", "vfrac", "x0", "temperature", "heatflow", "damage"};
  fields_data_atom = {"id", "type", "vfrac", "rmass", "temperature", "x"};
  fields_data_vel = {"id", "v"};

  setup_fields();
}

/* ---------------------------------------------------------------------- */

void AtomVecTMSPH::grow_pointers()
{
  if (atom->tag_enable == 0)    // told here, before LAMMPS tries to map ids
    error->all(FLERR, "Atom style tmsph needs atom ids: remove 'atom_modify id no'");
  rmass = atom->rmass;
  vfrac = atom->vfrac;
  x0 = atom->x0;
  temperature = atom->temperature;
  damage = atom->damage;
}

/* ----------------------------------------------------------------------
   mass and volume 0 and temperature NaN mean "not given": at the first run
   the mass becomes density times volume, the temperature the reference
   temperature of the type, and a missing volume is an error
------------------------------------------------------------------------- */

void AtomVecTMSPH::create_atom_post(int ilocal)
{
  rmass[ilocal] = 0.0;
  vfrac[ilocal] = 0.0;
  temperature[ilocal] = NAN;
  for (int k = 0; k < 3; k++) x0[ilocal][k] = atom->x[ilocal][k];
}

/* ---------------------------------------------------------------------- */

void AtomVecTMSPH::data_atom_post(int ilocal)
{
  if (rmass[ilocal] < 0.0)
    error->one(FLERR,
               "Invalid mass {} in Atoms section of data file: give a mass, or 0 to have it "
               "computed from density and volume",
               rmass[ilocal]);
  if (vfrac[ilocal] <= 0.0)
    error->one(FLERR, "Invalid volume {} in Atoms section of data file: it must be positive",
               vfrac[ilocal]);
  damage[ilocal] = 0.0;
  atom->heatflow[ilocal] = 0.0;
  for (int k = 0; k < 3; k++) x0[ilocal][k] = atom->x[ilocal][k];
}

/* ---------------------------------------------------------------------- */

void AtomVecTMSPH::pack_data_pre(int ilocal)
{
  if (std::isnan(temperature[ilocal]))
    error->one(FLERR,
               "Write_data before the temperatures are known: use 'set ... temperature' or "
               "'run 0' first");
}
