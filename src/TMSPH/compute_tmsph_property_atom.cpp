/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "compute_tmsph_property_atom.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "fix_tmsph_break.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_principal.h"
#include "tmsph_words.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

ComputeTMSPHPropertyAtom::ComputeTMSPHPropertyAtom(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), needs_stress(false), nmax(0), vector(nullptr), array(nullptr),
    pair(nullptr), breaking(nullptr), gradient(nullptr)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "compute tmsph/property/atom", error);
  peratom_flag = 1;
  TMSPHWords(lmp, "compute tmsph/property/atom", fields()).read_all(arg + 3, arg + narg);
  size_peratom_cols = columns.size() == 1 ? 0 : columns.size();
}

/* ---------------------------------------------------------------------- */

ComputeTMSPHPropertyAtom::~ComputeTMSPHPropertyAtom()
{
  memory->destroy(vector);
  memory->destroy(array);
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHPropertyAtom::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Compute tmsph/property/atom needs pair style tmsph");
  find_rock();
}

/* ----------------------------------------------------------------------
   the fix may have gone since the last run, or be another
------------------------------------------------------------------------- */

void ComputeTMSPHPropertyAtom::find_rock()
{
  breaking = FixTMSPHBreak::find(lmp);
  if (!needs_rock.empty() && !breaking)
    error->all(FLERR,
               "Word '{}' of compute tmsph/property/atom needs a fix that breaks bonds, such as "
               "tmsph/hoekbrown",
               needs_rock);
}

/* ----------------------------------------------------------------------
   each word with the function of a particle behind it
------------------------------------------------------------------------- */

std::vector<TMSPHWord> ComputeTMSPHPropertyAtom::fields()
{
  enum { STRESS = 1, ROCK = 2 };    // what it needs
  std::vector<TMSPHWord> words;
  const auto add = [&](const std::string &name, int needs, Column column) {
    words.push_back({name, "", [this, name, needs, column](TMSPHValues &) {
                       columns.push_back(column);
                       needs_stress = needs_stress || (needs & STRESS);
                       if (needs & ROCK) needs_rock = name;
                     }});
  };
  const auto add_count = [&](const char *name, FixTMSPHBond::State state) {
    add(name, 0, [this, state](int i) { return (double) pair->bonds()->count_in(i, 1u << state); });
  };
  const std::string axes = "xyz";
  for (int k = 0; k < 3; k++)
    add(std::string("u") + axes[k], 0, [this, k](int i) {
      double unwrapped[3];
      domain->unmap(atom->x[i], atom->image[i], unwrapped);
      return unwrapped[k] - atom->x0[i][k];
    });
  for (int k = 0; k < 3; k++)
    add(axes[k] + std::string("0"), 0, [this, k](int i) { return atom->x0[i][k]; });
  add("temperature", 0, [this](int i) { return atom->temperature[i]; });
  add("volume", 0, [this](int i) { return atom->vfrac[i]; });
  add("radius", 0, [this](int i) { return 0.5 * pair->bonds()->spacing(i); });
  add("damage", 0, [this](int i) { return atom->damage[i]; });
  add_count("nbond", FixTMSPHBond::INTACT);
  add_count("nbroken", FixTMSPHBond::BROKEN);
  add_count("ncut", FixTMSPHBond::CUT);
  int n = 0;
  for (const char *name : {"sxx", "syy", "szz", "sxy", "sxz", "syz"}) {
    add(name, STRESS, [this, n](int i) { return full_stress[6 * (size_t) i + n]; });
    n++;
  }
  for (int k = 0; k < 3; k++)    // s1 is the most tensile
    add("s" + std::to_string(k + 1), STRESS,
        [this, k](int i) { return principal[3 * (size_t) i + k]; });
  add("smean", STRESS, [this](int i) {
    const double *s = &full_stress[6 * (size_t) i];
    return (s[0] + s[1] + s[2]) / 3.0;
  });
  add("vonmises", STRESS, [this](int i) {
    const double *p = &principal[3 * (size_t) i];
    return std::sqrt(0.5 *
                     ((p[0] - p[1]) * (p[0] - p[1]) + (p[1] - p[2]) * (p[1] - p[2]) +
                      (p[2] - p[0]) * (p[2] - p[0])));
  });
  for (int row = 0; row < 3; row++)
    for (int col = 0; col < 3; col++)
      add(std::string("F") + axes[row] + axes[col], STRESS, [this, row, col](int i) {
        const int d = domain->dimension;
        const double identity = row == col ? 1.0 : 0.0;
        if (row >= d || col >= d) return identity;
        return identity + gradient[(size_t) i * d * d + row * d + col];
      });
  add("strength", ROCK, [this](int i) { return breaking->rocks().strength(i); });
  add("load", STRESS | ROCK, [this](int i) {
    return breaking->rocks().load_factor_of_all(i, &full_stress[6 * (size_t) i]);
  });
  return words;
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHPropertyAtom::evaluate_fields()
{
  const TMSPHFields fields = pair->fields();
  gradient = fields.gradient;
  const int n = atom->nlocal, size = TMSPH::stress_row(domain->dimension);
  full_stress.resize(6 * (size_t) n);
  principal.resize(3 * (size_t) n);
  for (int i = 0; i < n; i++) {
    const double *s = fields.stress + (size_t) i * size;
    double *full = &full_stress[6 * (size_t) i];
    if (size == 6)
      std::copy(s, s + 6, full);
    else {
      const double zz = pair->stress_zz(i, s[0], s[1]);
      const double six[6] = {s[0], s[1], zz, s[2], 0.0, 0.0};
      std::copy(six, six + 6, full);
    }
    const Eigen::Vector3d value = TMSPH::principal_values(full);
    for (int k = 0; k < 3; k++) principal[3 * (size_t) i + k] = value[2 - k];
  }
}

/* ---------------------------------------------------------------------- */

void ComputeTMSPHPropertyAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  pair = PairTMSPH::laid_out(lmp, "Compute tmsph/property/atom");
  find_rock();
  if (!needs_rock.empty()) breaking->find_strengths();
  const int ncols = columns.size();
  if (atom->nmax > nmax) {
    nmax = atom->nmax;
    memory->destroy(vector);
    memory->destroy(array);
    if (ncols == 1)
      vector_atom = memory->create(vector, nmax, "tmsph/property/atom:vector");
    else
      array_atom = memory->create(array, nmax, ncols, "tmsph/property/atom:array");
  }
  if (needs_stress) evaluate_fields();
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < ncols; k++) {
      const double value = (atom->mask[i] & groupbit) ? columns[k](i) : 0.0;
      if (ncols == 1)
        vector[i] = value;
      else
        array[i][k] = value;
    }
}

/* ---------------------------------------------------------------------- */

double ComputeTMSPHPropertyAtom::memory_usage()
{
  return (double) nmax * columns.size() * sizeof(double) +
      (full_stress.capacity() + principal.capacity()) * sizeof(double);
}
