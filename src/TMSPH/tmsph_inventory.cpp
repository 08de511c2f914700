/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What there is of each type: particles, volumes, spacings.
------------------------------------------------------------------------- */

#include "tmsph_inventory.h"

#include "comm.h"
#include "domain.h"
#include "tmsph_collective.h"
#include "tmsph_report.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

bool TMSPHInventory::measure(const TMSPHMaterials &materials, const FixTMSPHBond &bonds)
{
  const int ntypes = atom->ntypes, D = domain->dimension;
  std::vector<bigint> mine(ntypes + 1, 0), count(ntypes + 1);
  for (int i = 0; i < atom->nlocal; i++) mine[atom->type[i]]++;
  MPI_Allreduce(mine.data(), count.data(), ntypes + 1, MPI_LMP_BIGINT, MPI_SUM, world);
  std::vector<Type> found(ntypes + 1);
  bool same = (int) types.size() == ntypes + 1;
  for (int type = 1; type <= ntypes; type++) {
    const TMSPHMaterials::Material &m = materials.material(type);
    found[type].particles = count[type];
    found[type].material = {m.young, m.poisson, m.density, m.expansion,
                            materials.horizon(type, type)};
    same = same && found[type].particles == types[type].particles &&
        found[type].material == types[type].material;
  }
  if (same) return false;
  std::vector<double> volumes, distances, cells;
  for (int type = 1; type <= ntypes; type++) {
    volumes.clear(), distances.clear(), cells.clear();
    for (int i = 0; i < atom->nlocal; i++) {
      if (atom->type[i] != type) continue;
      volumes.push_back(atom->vfrac[i]);
      const double square = bonds.nearest_square(i);
      if (square == 0.0) continue;
      distances.push_back(std::sqrt(square));
      cells.push_back(std::pow(square, 0.5 * D));
    }
    Type &t = found[type];
    const bigint here = distances.size();
    bigint measured;
    MPI_Allreduce(&here, &measured, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    t.volume = fixed_point_sum(volumes, world);
    if (!measured) continue;
    t.spacing = fixed_point_sum(distances, world) / measured;
    t.cell = fixed_point_sum(cells, world) / measured;
  }
  types = found;
  return true;
}

/* ---------------------------------------------------------------------- */

void TMSPHInventory::tell(const TMSPHMaterials &materials, double thickness) const
{
  if (comm->me) return;
  const UnitNames unit(update->unit_style);
  TextTable table({"type", "particles", heading("spacing", unit.length), "horizon/spacing",
                   heading("E", unit.pressure), "nu", heading("density", unit.density),
                   heading("wave_speed", unit.speed)});
  double volume = 0.0;
  for (int type = 1; type <= atom->ntypes; type++) {
    const TMSPHMaterials::Material &m = materials.material(type);
    const Type &t = types[type];
    volume += t.volume;
    const bool known = t.spacing > 0.0;
    const double horizon = materials.horizon(type, type);
    table.add({std::to_string(type), std::to_string(t.particles), known ? digits(t.spacing) : "-",
               known ? digits(horizon / t.spacing) : "-", digits(m.young), digits(m.poisson),
               digits(m.density), digits(TMSPHMaterials::wave_speed(m))});
  }
  std::string size = heading("volume", unit.volume) + " " + digits(volume);
  if (domain->dimension == 2)
    size = heading("thickness", unit.length) + " " + digits(thickness) + "  " +
        heading("area", unit.area) + " " + digits(volume / thickness);
  utils::logmesg(lmp, "  {}\n{}", size, table.text());
}
