/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "compute_tmsph_wall_local.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_wall.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

ComputeTMSPHWallLocal::ComputeTMSPHWallLocal(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg)
{
  if (narg > 3) error->all(FLERR, "Compute tmsph/wall/local takes no words, not '{}'", arg[3]);
  if (!domain->box_exist)    // it may still get another dimension
    error->all(FLERR, "Compute tmsph/wall/local before the simulation box is defined");
  local_flag = 1;
  size_local_cols = 1 + (domain->dimension == 2 ? 2 : 3) * 3;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHWallLocal::init()
{
  if (modify->get_fix_by_style("^tmsph/wall$").empty())
    error->all(FLERR, "Compute tmsph/wall/local needs a fix tmsph/wall");
}

/* ----------------------------------------------------------------------
   walls are everywhere the same: the first processor lists them
------------------------------------------------------------------------- */

void ComputeTMSPHWallLocal::compute_local()
{
  invoked_local = update->ntimestep;
  values.clear();
  double wall = 0.0;
  auto walls = modify->get_fix_by_style("^tmsph/wall$");
  std::sort(walls.begin(), walls.end(),
            [](const Fix *a, const Fix *b) { return strcmp(a->id, b->id) < 0; });
  if (comm->me == 0)
    for (Fix *fix : walls) {
      wall += 1.0;
      for (const auto &piece : dynamic_cast<FixTMSPHWall *>(fix)->pieces()) {
        values.push_back(wall);
        for (const auto &point : piece) values.insert(values.end(), point.begin(), point.end());
      }
    }
  size_local_rows = values.size() / size_local_cols;
  rows.resize(size_local_rows);
  for (int r = 0; r < size_local_rows; r++) rows[r] = values.data() + r * size_local_cols;
  array_local = rows.data();
}

/* ---------------------------------------------------------------------- */

double ComputeTMSPHWallLocal::memory_usage()
{
  return values.capacity() * sizeof(double) + rows.capacity() * sizeof(double *);
}
