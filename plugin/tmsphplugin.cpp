/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The package as a plugin: registers its styles with a running LAMMPS.
------------------------------------------------------------------------- */

#include "lammpsplugin.h"

#include "atom.h"
#include "lammps.h"
#include "update.h"
#include "version.h"

#include "tmsph_styles.h"    // made by CMake: includes all headers that have a style

using namespace LAMMPS_NS;

namespace {

template <class T> Pair *create_pair(LAMMPS *lmp)
{
  return new T(lmp);
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

template <class T> AtomVec *create_atom_style(LAMMPS *lmp)
{
  return new T(lmp);
}

template <class T> Min *create_minimizer(LAMMPS *lmp)
{
  return new T(lmp);
}

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  const auto register_plugin = (lammpsplugin_regfunc) regfunc;
  lammpsplugin_t plugin;
  plugin.version = LAMMPS_VERSION;
  plugin.author = "the TMSPH developers";
  plugin.info = "thermal fracture of rock";
  plugin.handle = handle;

  const auto add = [&](const char *style, const char *name) {
    plugin.style = style;
    plugin.name = name;
    register_plugin(&plugin, lmp);
  };

  // the headers name their styles, for LAMMPS's own lists and here

#define PAIR_CLASS
#define PairStyle(name, Class)                                       \
  plugin.creator.v1 = (lammpsplugin_factory1 *) &create_pair<Class>; \
  add("pair", #name)
#define COMMAND_CLASS
#define CommandStyle(name, Class)                                       \
  plugin.creator.v1 = (lammpsplugin_factory1 *) &create_command<Class>; \
  add("command", #name)
#define FIX_CLASS
#define FixStyle(name, Class)                                       \
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_fix<Class>; \
  add("fix", #name)
#define COMPUTE_CLASS
#define ComputeStyle(name, Class)                                       \
  plugin.creator.v2 = (lammpsplugin_factory2 *) &create_compute<Class>; \
  add("compute", #name)

  // the loader knows no atom and minimizer styles: these go straight into LAMMPS's tables

#define ATOM_CLASS
#define AtomStyle(name, Class) \
  (*static_cast<LAMMPS *>(lmp)->atom->avec_map)[#name] = &create_atom_style<Class>
#define MINIMIZE_CLASS
#define MinimizeStyle(name, Class) \
  (*static_cast<LAMMPS *>(lmp)->update->minimize_map)[#name] = &create_minimizer<Class>

#include "tmsph_styles.h"
}
