/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Numbers that are allowed but make no sense: a warning each, with the remedy.
------------------------------------------------------------------------- */

#include "tmsph_doubts.h"

#include "domain.h"
#include "error.h"
#include "group.h"
#include "modify.h"
#include "tmsph_report.h"
#include "update.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using namespace LAMMPS_NS;
using namespace TMSPH;

// the linear expansion of solids is between -1e-5 and 3e-4 per degree (polymers; CRC Handbook)

static constexpr double MOST_EXPANSION = 1.0e-3;

// in spacings: with less than two a strain is that of the nearest neighbors alone; with 6 a body is
// a spacing longer than it is stiff (doc/src/pair_tmsph.rst)

static constexpr double SHORTEST_HORIZON = 2.0, LONGEST_HORIZON = 8.0, ABSURD_HORIZON = 50.0;
static constexpr double USUAL_HORIZON = 3.015;    // of the heated disc of Mu et al. (2022)

// volume of a particle in cubes of the spacing: lattices have 0.7 to 1, a random cloud 4

static constexpr double LEAST_VOLUME = 0.2, MOST_VOLUME = 10.0;

// a body in 2-D is thought of as this thick at most in its own sizes, at least in spacings

static constexpr double THICKEST = 100.0, THINNEST = 0.01;

// what round-off may take of a spacing: failure is at strains of 1e-4 to 1e-3

static constexpr double POSITION_LOSS = 1.0e-6;

/* ----------------------------------------------------------------------
   @return what is wrong with the first type whose numbers are those of no solid
------------------------------------------------------------------------- */

static std::string doubtful_material(LAMMPS *lmp, const TMSPHMaterials &materials)
{
  const UnitNames unit(lmp->update->unit_style);
  for (int type = 1; type <= lmp->atom->ntypes; type++) {
    const TMSPHMaterials::Material &m = materials.material(type);
    if (!materials.plausible(type))
      return fmt::format("No solid has waves of {:.3g} {} as type {}: give its Young's modulus, "
                         "{}, in {}, and its density, {}, in {}",
                         TMSPHMaterials::wave_speed(m), unit.speed, type, m.young, unit.pressure,
                         m.density, unit.density);
    if (unit.meters_per_second > 0.0 && std::fabs(m.expansion) > MOST_EXPANSION)
      return fmt::format("No solid expands by {} per degree as type {}: give its coefficient of "
                         "linear expansion per degree, 1e-5 for rock",
                         m.expansion, type);
  }
  return "";
}

/* ----------------------------------------------------------------------
   Before neighbor lists are made with it: a horizon that was given in spacings. Those are estimated
   from the sizes of the body; of a plate or a row the small ones, or round-off, do not count.
------------------------------------------------------------------------- */

void LAMMPS_NS::check_reach(LAMMPS *lmp, double horizon)
{
  const Atom *const atom = lmp->atom;
  const int D = lmp->domain->dimension;
  if (!atom->natoms) return;
  std::array<double, 6> mine, all;    // largest coordinates, and minus the smallest
  mine.fill(-HUGE_VAL);
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < 3; k++) {
      mine[k] = std::max(mine[k], atom->x[i][k]);
      mine[3 + k] = std::max(mine[3 + k], -atom->x[i][k]);
    }
  MPI_Allreduce(mine.data(), all.data(), 6, MPI_DOUBLE, MPI_MAX, lmp->world);
  std::vector<double> sizes;
  for (int k = 0; k < D; k++) sizes.push_back(all[k] + all[3 + k]);
  std::sort(sizes.begin(), sizes.end(), std::greater<double>());
  double part = 1.0 / atom->natoms, spacing = 0.0;
  for (int k = 0; k < D; k++) {
    part *= sizes[k];
    spacing = std::max(spacing, std::pow(part, 1.0 / (1 + k)));
  }
  if (spacing > 0.0 && horizon > ABSURD_HORIZON * spacing)
    lmp->error->all(FLERR,
                    "The horizon {} of pair_style tmsph is {:.3g} particle spacings: give it as a "
                    "length, {} spacings are {:.3g}",
                    horizon, horizon / spacing, USUAL_HORIZON, USUAL_HORIZON * spacing);
}

/* ---------------------------------------------------------------------- */

static std::string doubtful_horizon(LAMMPS *lmp, const TMSPHMaterials &materials,
                                    const TMSPHInventory &inventory)
{
  for (int type = 1; type <= lmp->atom->ntypes; type++) {
    const double spacing = inventory.of(type).spacing, own = materials.horizon(type, type);
    if (spacing == 0.0) continue;
    const bool shorter = own < SHORTEST_HORIZON * spacing;
    if (!shorter && own < LONGEST_HORIZON * spacing) continue;
    return fmt::format("The horizon {:.4g} of type {} is {:.3g} spacings, which makes {}: give {} "
                       "of them, {:.4g}",
                       own, type, own / spacing, shorter ? "strains inexact" : "surfaces too soft",
                       USUAL_HORIZON, USUAL_HORIZON * spacing);
  }
  return "";
}

/* ----------------------------------------------------------------------
   A thickness in 2-D that is neither 1 nor of the order of the body, and volumes in 3-D that are
   not of the order of the cube of the spacing
------------------------------------------------------------------------- */

static std::string doubtful_volume(LAMMPS *lmp, const TMSPHInventory &inventory, double thickness)
{
  const Domain *const domain = lmp->domain;
  double size = 0.0;
  for (int k = 0; k < domain->dimension; k++) size = std::max(size, domain->prd[k]);
  for (int type = 1; type <= lmp->atom->ntypes; type++) {
    const TMSPHInventory::Type &t = inventory.of(type);
    if (t.spacing == 0.0) continue;
    const double ratio = t.volume / (t.particles * t.cell);
    if (domain->dimension == 3 && (ratio < LEAST_VOLUME || ratio > MOST_VOLUME))
      return fmt::format("Volumes of type {} are {:.3g} times the cube of the spacing: give that, "
                         "about {:.3g}, with 'set type {} volume'",
                         type, ratio, t.cell, type);
    if (domain->dimension == 2 && thickness != 1.0 &&
        (thickness > THICKEST * size || thickness < THINNEST * t.spacing))
      return fmt::format("Volumes of particles make the body {:.3g} thick: in 2-D they are area "
                         "times thickness, give {:.3g} for a thickness of 1 with 'set group all "
                         "volume'",
                         thickness, t.cell);
  }
  return "";
}

/* ---------------------------------------------------------------------- */

static std::string doubtful_place(LAMMPS *lmp, const TMSPHInventory &inventory)
{
  const Atom *const atom = lmp->atom;
  double mine = 0.0, farthest, spacing = HUGE_VAL;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < lmp->domain->dimension; k++)
      mine = std::max(mine, std::fabs(atom->x[i][k]));
  MPI_Allreduce(&mine, &farthest, 1, MPI_DOUBLE, MPI_MAX, lmp->world);
  for (int type = 1; type <= atom->ntypes; type++) {
    const double one = inventory.of(type).spacing;
    if (one > 0.0) spacing = std::min(spacing, one);
  }
  const double unit = std::nextafter(farthest, HUGE_VAL) - farthest;
  if (!(unit > POSITION_LOSS * spacing)) return "";
  return fmt::format("Positions of {:.3g} are rounded to {:.1g} of the spacing: put the body near "
                     "the origin",
                     farthest, unit / spacing);
}

/* ---------------------------------------------------------------------- */

std::string LAMMPS_NS::find_doubt(LAMMPS *lmp, const TMSPHMaterials &materials,
                                  const TMSPHInventory &inventory, double thickness)
{
  for (const std::string &doubt :
       {doubtful_material(lmp, materials), doubtful_horizon(lmp, materials, inventory),
        doubtful_volume(lmp, inventory, thickness), doubtful_place(lmp, inventory)})
    if (!doubt.empty()) return doubt;
  return "";
}

/* ----------------------------------------------------------------------
   a fix on nobody; groups that follow a condition may have members later
------------------------------------------------------------------------- */

void LAMMPS_NS::check_groups(LAMMPS *lmp, TMSPHNotes &notes)
{
  Group *const group = lmp->group;
  if (!lmp->atom->natoms) return;
  for (Fix *fix : lmp->modify->get_fix_list())
    if (fix->igroup > 0 && !group->dynamic[fix->igroup] && group->count(fix->igroup) == 0)
      notes.warn_once(
          fmt::format("Group {} of fix {} is empty: check the region or the types that it was made "
                      "of, and that particles were there before it",
                      group->names[fix->igroup], fix->id));
}
