/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Stress that walls make in the particles that touch them.
------------------------------------------------------------------------- */

#include "fix_tmsph_wall.h"

#include "atom.h"
#include "domain.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

// particles whose heights above the wall differ by less than this many spacings are of one row:
// rows of square and hexagonal lattices along a wall are 0.5 and more apart; 0.05 to 0.45 do the
// same in unittest/verification/test_wall_stress.py

static constexpr double ROW = 0.25;

/* ----------------------------------------------------------------------
   half the distance of the row of a particle from the next one, which is half of the
   row's thickness; half a spacing if there is no other
------------------------------------------------------------------------- */

double FixTMSPHWall::half_row(int i, const Point &normal) const
{
  const FixTMSPHBond &bonds = *scene.pair->bonds();
  const double spacing = bonds.spacing(i);
  double next = spacing;
  for (const auto &bond : bonds.family(i, FixTMSPHBond::WHOLE)) {
    const double *x = atom->x[bond.j];
    double height = 0.0;
    for (int a = 0; a < 3; a++) height += normal[a] * (x[a] - atom->x[i][a]);
    if (height > ROW * spacing) next = std::min(next, height);
  }
  return 0.5 * next;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::add_loads(std::vector<Load> &loads)
{
  for (int n = 0; n < memories.count(); n++) {
    const int i = atom->map(memories.id(n));
    if (i >= 0 && i < atom->nlocal) loads.push_back(load_of(i, memories[n]));
  }
}

/* ----------------------------------------------------------------------
   Force per area times half a row, in its full thickness V: as pressure p along
   the normal, p nu/(1 - nu) across it, since the row moves along with its neighbors, and as shear.
   In a corner the force is the sum of two along the normals, and what is left is friction of both.
------------------------------------------------------------------------- */

TMSPHPresses::Load FixTMSPHWall::load_of(int i, const TMSPHWallMemory &memory) const
{
  const double *f = memory.force;
  WallTouch place[2];
  const int side = scene.both_sides ? memory.side : 1;
  const int places = scene.shape->touches(scene.motion.to_body(candidates.position_of(i)),
                                          TMSPHWallScene::REACH * scene.gap(i), side, place);
  double along[2] = {}, normal[2] = {}, cosine = 0.0;
  for (int p = 0; p < places; p++) {
    place[p].normal = scene.motion.turned(place[p].normal);
    for (int a = 0; a < 3; a++) along[p] += f[a] * place[p].normal[a];
  }
  if (places == 2)
    for (int a = 0; a < 3; a++) cosine += place[0].normal[a] * place[1].normal[a];
  for (int p = 0; p < places; p++)
    normal[p] = std::max(0.0, (along[p] - cosine * along[1 - p]) / (1.0 - cosine * cosine));
  Point rubbing = {f[0], f[1], f[2]};
  for (int p = 0; p < places; p++)
    for (int a = 0; a < 3; a++) rubbing[a] -= normal[p] * place[p].normal[a];

  Load load = {i, true, {}};
  const double ratio = scene.pair->lateral_ratio(i);
  for (int p = 0; p < places; p++) {
    const Point &n = place[p].normal;
    const double scale = -half_row(i, n) / atom->vfrac[i];
    const auto component = [&](int a, int b) {
      const double one = a == b ? 1.0 : 0.0;
      return scale *
          (normal[p] * (n[a] * n[b] + ratio * (one - n[a] * n[b])) +
           (rubbing[a] * n[b] + rubbing[b] * n[a]) / places);
    };
    for (int a = 0, k = 3; a < domain->dimension; a++) {
      load.stress[a] += component(a, a);
      for (int b = a + 1; b < domain->dimension; b++) load.stress[k++] += component(a, b);
    }
  }
  return load;
}
