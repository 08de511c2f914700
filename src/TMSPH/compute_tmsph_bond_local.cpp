/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "compute_tmsph_bond_local.h"

#include "atom.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "pair_tmsph.h"
#include "tmsph_words.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

ComputeTMSPHBondLocal::ComputeTMSPHBondLocal(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), wanted(-1), pair(nullptr)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "compute tmsph/bond/local", error);
  const auto column = [this](const char *name, Word word) {
    return TMSPHWord{name, "", [this, word](TMSPHValues &) { words.push_back(word); }};
  };
  TMSPHWords(lmp, "compute tmsph/bond/local",
             {column("id1", ID1),
              column("id2", ID2),
              column("state", STATE),
              column("length", LENGTH),
              column("stretch", STRETCH),
              {"only", "state",
               [this](TMSPHValues &v) {
                 wanted = v.one_of<int>({{"all", -1},
                                         {"intact", FixTMSPHBond::INTACT},
                                         {"broken", FixTMSPHBond::BROKEN},
                                         {"cut", FixTMSPHBond::CUT}});
               }}})
      .read_all(arg + 3, arg + narg);
  if (words.empty()) utils::missing_cmd_args(FLERR, "compute tmsph/bond/local", error);
  local_flag = 1;
  size_local_cols = words.size() == 1 ? 0 : words.size();
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHBondLocal::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Compute tmsph/bond/local needs pair style tmsph");
}

/* ----------------------------------------------------------------------
   a bond is listed where its lower id lives, if both ends are in the group;
   one whose other end went out of reach has length and stretch 0
------------------------------------------------------------------------- */

void ComputeTMSPHBondLocal::compute_local()
{
  invoked_local = update->ntimestep;
  pair = PairTMSPH::laid_out(lmp, "Compute tmsph/bond/local");
  const FixTMSPHBond &bonds = *pair->bonds();
  values.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (int k = 0; k < bonds.count(i); k++) {
      const int j = bonds.partner_index(i, k), state = bonds.bond_state(i, k);
      if (atom->tag[i] > bonds.partner_tag(i, k) || !(atom->mask[j] & groupbit)) continue;
      if (wanted >= 0 ? state != wanted : state == FixTMSPHBond::UNBONDED) continue;
      double X[3], R2 = 0.0, r2 = 0.0;
      if (i != j) {
        bonds.reference_vector(i, j, X);
        for (int c = 0; c < 3; c++) {
          const double d = atom->x[j][c] - atom->x[i][c];
          R2 += X[c] * X[c];
          r2 += d * d;
        }
      }
      const double column[] = {(double) atom->tag[i], (double) bonds.partner_tag(i, k),
                               (double) state, std::sqrt(r2),
                               R2 > 0.0 ? std::sqrt(r2 / R2) - 1.0 : 0.0};
      for (const Word word : words) values.push_back(column[word]);
    }
  }
  const size_t ncols = words.size();
  size_local_rows = values.size() / ncols;
  rows.resize(size_local_rows);
  for (int r = 0; r < size_local_rows; r++) rows[r] = values.data() + r * ncols;
  if (ncols == 1)
    vector_local = values.data();
  else
    array_local = rows.data();
}

/* ---------------------------------------------------------------------- */

double ComputeTMSPHBondLocal::memory_usage()
{
  return values.capacity() * sizeof(double) + rows.capacity() * sizeof(double *);
}
