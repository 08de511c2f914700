/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The package as a plugin: registers its styles with a running LAMMPS.
------------------------------------------------------------------------- */

#include "lammpsplugin.h"

#include "atom.h"
#include "lammps.h"
#include "update.h"
#include "version.h"

#include "atom_vec_tmsph.h"
#include "compute_tmsph_bond_local.h"
#include "compute_tmsph_crack.h"
#include "compute_tmsph_dt.h"
#include "compute_tmsph_property_atom.h"
#include "compute_tmsph_wall_local.h"
#include "fix_tmsph_bond.h"
#include "fix_tmsph_contact.h"
#include "fix_tmsph_heat.h"
#include "fix_tmsph_heat_boundary.h"
#include "fix_tmsph_hoekbrown.h"
#include "fix_tmsph_mohrcoulomb.h"
#include "fix_tmsph_rankine.h"
#include "fix_tmsph_wall.h"
#include "min_tmsph_lbfgs.h"
#include "pair_tmsph.h"
#include "tmsph_cut.h"
#include "tmsph_quasistatic.h"

using namespace LAMMPS_NS;

namespace {

AtomVec *create_atom_style(LAMMPS *lmp)
{
  return new AtomVecTMSPH(lmp);
}

Pair *create_pair(LAMMPS *lmp)
{
  return new PairTMSPH(lmp);
}

template <class T> Fix *create_fix(LAMMPS *lmp, int narg, char **arg)
{
  return new T(lmp, narg, arg);
}

template <class T> Compute *create_compute(LAMMPS *lmp, int narg, char **arg)
{
  return new T(lmp, narg, arg);
}

template <class T> Command *create_command(LAMMPS *lmp)
{
  return new T(lmp);
}

Min *create_minimizer(LAMMPS *lmp)
{
  return new MinTMSPHLBFGS(lmp);
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  const auto register_plugin = (lammpsplugin_regfunc) regfunc;
  lammpsplugin_t plugin;
  plugin.version = LAMMPS_VERSION;
  plugin.author = "the TMSPH developers";
  plugin.handle = handle;

  const auto add = [&](const char *style, const char *name, const char *info) {
    plugin.style = style;
    plugin.name = name;
    plugin.info = info;
    register_plugin(&plugin, lmp);
  };

  // the loader knows no atom and minimizer styles: these go straight into LAMMPS's tables

  (*static_cast<LAMMPS *>(lmp)->atom->avec_map)["tmsph"] = &create_atom_style;
  (*static_cast<LAMMPS *>(lmp)->update->minimize_map)["tmsph/lbfgs"] = &create_minimizer;

  plugin.creator.v1 = (lammpsplugin_factory1 *) &create_pair;
  add("pair", "tmsph", "total-Lagrangian SPH with thermal bonds");

  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHBond>;
  add("fix", "tmsph/bond", "reference bonds of pair style tmsph");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHHoekBrown>;
  add("fix", "tmsph/hoekbrown", "bond breaking by the Hoek-Brown criterion");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHMohrCoulomb>;
  add("fix", "tmsph/mohrcoulomb", "bond breaking by the Mohr-Coulomb criterion");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHRankine>;
  add("fix", "tmsph/rankine", "bond breaking by Rankine's criterion");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHContact>;
  add("fix", "tmsph/contact", "contact with friction of bodies and crack faces");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHWall>;
  add("fix", "tmsph/wall", "rigid walls with friction");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHHeat>;
  add("fix", "tmsph/heat", "conduction of heat");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<FixTMSPHHeatBoundary>;
  add("fix", "tmsph/heat/boundary", "temperature, flux, convection and radiation");

  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_compute<ComputeTMSPHPropertyAtom>;
  add("compute", "tmsph/property/atom", "fields of the particles");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_compute<ComputeTMSPHBondLocal>;
  add("compute", "tmsph/bond/local", "reference bonds");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_compute<ComputeTMSPHWallLocal>;
  add("compute", "tmsph/wall/local", "where the walls are");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_compute<ComputeTMSPHCrack>;
  add("compute", "tmsph/crack", "crack area and opening");
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_compute<ComputeTMSPHDt>;
  add("compute", "tmsph/dt", "stable time step");

  plugin.creator.v1 = (lammpsplugin_factory1 *) &create_command<TMSPHCut>;
  add("command", "tmsph/cut", "pre-existing flaws");
  plugin.creator.v1 = (lammpsplugin_factory1 *) &create_command<TMSPHQuasistatic>;
  add("command", "tmsph/quasistatic", "equilibrium and breaking on the thermal clock");
}
