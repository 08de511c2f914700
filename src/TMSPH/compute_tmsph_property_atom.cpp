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
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

static constexpr const char *STRESS_WORDS[6] = {"sxx", "syy", "szz", "sxy", "sxz", "syz"};
static constexpr const char *GRADIENT_WORDS[9] = {"Fxx", "Fxy", "Fxz", "Fyx", "Fyy",
                                                  "Fyz", "Fzx", "Fzy", "Fzz"};

/* ---------------------------------------------------------------------- */

ComputeTMSPHPropertyAtom::ComputeTMSPHPropertyAtom(LAMMPS *lmp, int narg, char **arg) :
    Compute(lmp, narg, arg), needs_stress(false), needs_rock(false), nmax(0), vector(nullptr),
    array(nullptr), pair(nullptr), breaking(nullptr), gradient(nullptr)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "compute tmsph/property/atom", error);
  peratom_flag = 1;
  for (int iarg = 3; iarg < narg; iarg++) words.emplace_back(arg[iarg]);
  size_peratom_cols = words.size() == 1 ? 0 : words.size();
  make_columns();    // unknown words are told now, not at the first output
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
  for (const auto &word : words) {
    if (word != "strength" && word != "load") continue;
    if (!breaking)
      error->all(FLERR,
                 "Word '{}' of compute tmsph/property/atom needs a fix that breaks bonds, such as "
                 "tmsph/hoekbrown", word);
    needs_rock = true;
  }
}

/* ----------------------------------------------------------------------
   the function behind each word
------------------------------------------------------------------------- */

void ComputeTMSPHPropertyAtom::make_columns()
{
  for (const auto &word : words) columns.push_back(column(word));
}

/* ---------------------------------------------------------------------- */

ComputeTMSPHPropertyAtom::Column ComputeTMSPHPropertyAtom::column(const std::string &word)
{
  for (int k = 0; k < 3; k++) {
    const char axis = "xyz"[k];
    if (word == std::string("u") + axis)
      return [this, k](int i) {
        double unwrapped[3];
        domain->unmap(atom->x[i], atom->image[i], unwrapped);
        return unwrapped[k] - atom->x0[i][k];
      };
    if (word == std::string(1, axis) + "0") return [this, k](int i) { return atom->x0[i][k]; };
  }
  if (word == "temperature") return [this](int i) { return atom->temperature[i]; };
  if (word == "damage") return [this](int i) { return atom->damage[i]; };
  if (word == "volume") return [this](int i) { return atom->vfrac[i]; };
  if (word == "radius") return [this](int i) { return 0.5 * pair->bonds()->spacing(i); };
  const auto bonds_in = [this](FixTMSPHBond::State state) {
    return [this, state](int i) { return (double) pair->bonds()->count_in(i, 1u << state); };
  };
  if (word == "nbond") return bonds_in(FixTMSPHBond::INTACT);
  if (word == "nbroken") return bonds_in(FixTMSPHBond::BROKEN);
  if (word == "ncut") return bonds_in(FixTMSPHBond::CUT);
  if (word == "strength") return [this](int i) { return breaking->strength(i); };

  needs_stress = true;
  if (word == "load")
    return [this](int i) { return breaking->load_factor(i, &full_stress[6 * (size_t) i]); };
  for (int k = 0; k < 6; k++)
    if (word == STRESS_WORDS[k])
      return [this, k](int i) { return full_stress[6 * (size_t) i + k]; };
  for (int k = 0; k < 9; k++)
    if (word == GRADIENT_WORDS[k])
      return [this, k](int i) {
        const int d = domain->dimension, row = k / 3, col = k % 3;
        const double identity = row == col ? 1.0 : 0.0;
        if (row >= d || col >= d) return identity;
        return identity + gradient[(size_t) i * d * d + row * d + col];
      };
  for (int k = 0; k < 3; k++)    // s1 is the most tensile
    if (word == std::string("s") + "123"[k])
      return [this, k](int i) { return principal[3 * (size_t) i + k]; };
  if (word == "smean")
    return [this](int i) {
      const double *s = &full_stress[6 * (size_t) i];
      return (s[0] + s[1] + s[2]) / 3.0;
    };
  if (word == "vonmises")
    return [this](int i) {
      const double *p = &principal[3 * (size_t) i];
      return std::sqrt(0.5 * ((p[0] - p[1]) * (p[0] - p[1]) + (p[1] - p[2]) * (p[1] - p[2]) +
                              (p[2] - p[0]) * (p[2] - p[0])));
    };
  error->all(FLERR,
             "Unknown word '{}' of compute tmsph/property/atom: use ux uy uz x0 y0 z0 temperature "
             "volume radius damage nbond nbroken ncut sxx syy szz sxy sxz syz s1 s2 s3 smean "
             "vonmises Fxx to Fzz strength or load",
             word);
  return nullptr;
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
  if (needs_rock) breaking->find_strengths();
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
