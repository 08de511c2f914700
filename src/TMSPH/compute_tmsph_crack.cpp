/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "compute_tmsph_crack.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "pair_tmsph.h"
#include "tmsph_pi.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

static constexpr int N = 4;

/* ---------------------------------------------------------------------- */

ComputeTMSPHCrack::ComputeTMSPHCrack(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), pair(nullptr)
{
  if (narg != 3)
    error->all(FLERR, "Unexpected word '{}' after compute tmsph/crack: it takes none", arg[3]);
  vector_flag = 1;
  size_vector = N;
  extvector = 0;
  vector = new double[N];
}

/* ---------------------------------------------------------------------- */

ComputeTMSPHCrack::~ComputeTMSPHCrack()
{
  delete[] vector;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHCrack::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Compute tmsph/crack needs pair style tmsph");
}

/* ----------------------------------------------------------------------
   A plane with normal n crosses (1/2V) sum_j |X_ij . n| bonds per unit area,
   1/V being the number of particles per volume. Averaged over directions
   |cos| is 2/pi in 2-D and 1/2 in 3-D, so that one broken bond stands for the
   area 2V/(<|cos|> sum_j |X_ij|), here half of it from each end. A crack that
   opens by w lengthens the bonds across it by w <cos^2>/<|cos|> on average.
   In 2-D the area is length times thickness, the one that the volumes imply.
------------------------------------------------------------------------- */

void ComputeTMSPHCrack::compute_vector()
{
  invoked_vector = update->ntimestep;
  pair = PairTMSPH::laid_out(lmp, "Compute tmsph/crack");
  FixTMSPHBond *bonds = pair->bonds();
  const bool two = domain->dimension == 2;
  const double cosine = two ? 2.0 / TMSPH::PI : 0.5, cosine2 = two ? 0.5 : 1.0 / 3.0;

  double sum[N] = {0.0, 0.0, 0.0, 0.0};    // broken, cut, area, elongation
  for (int i = 0; i < atom->nlocal; i++) {
    int broken = 0;
    double reach = 0.0;
    sum[1] += 0.5 * bonds->count_in(i, 1u << FixTMSPHBond::CUT);
    for (const auto &[k, j, state] : bonds->family(i, FixTMSPHBond::FORMED)) {
      double X[3], R2 = 0.0, stretched = 0.0;
      bonds->reference_vector(i, j, X);
      for (int c = 0; c < 3; c++) R2 += X[c] * X[c];
      const double R = std::sqrt(R2);
      reach += R;
      if (state != FixTMSPHBond::BROKEN) continue;
      broken++;
      for (int c = 0; c < 3; c++)
        stretched +=
            ((atom->x[j][c] - bonds->reference(j)[c]) - (atom->x[i][c] - bonds->reference(i)[c])) *
            X[c] / R;
      sum[3] += 0.5 * std::max(0.0, stretched);
    }
    sum[0] += 0.5 * broken;
    if (reach > 0.0) sum[2] += broken * atom->vfrac[i] / (cosine * reach);
  }
  MPI_Allreduce(sum, vector, N, MPI_DOUBLE, MPI_SUM, world);
  vector[3] = vector[0] > 0.0 ? vector[3] / vector[0] * cosine / cosine2 : 0.0;
}
