/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_heat_sources.h"

#include "atom.h"
#include "error.h"
#include "input.h"
#include "modify.h"
#include "tmsph_words.h"
#include "variable.h"

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

TMSPHHeatSources::TMSPHHeatSources(LAMMPS *lmp) : Pointers(lmp), sources(atom->ntypes + 1) {}

/* ---------------------------------------------------------------------- */

void TMSPHHeatSources::read(TMSPHValues &values)
{
  int lo, hi;
  values.types(lo, hi);
  Source source;
  if (!values.variable(source.variable)) source.power = values.number();
  for (int type = lo; type <= hi; type++) sources[type] = source;
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatSources::check() const
{
  for (const Source &source : sources) {
    const std::string &name = source.variable;
    if (name.empty()) continue;
    const int found = input->variable->find(name.c_str());
    if (found < 0)
      error->all(FLERR, "Variable {} of fix tmsph/heat source does not exist: define it first",
                 name);
    if (!input->variable->equalstyle(found) && !input->variable->atomstyle(found))
      error->all(FLERR, "Variable {} of fix tmsph/heat source must be of equal or atom style",
                 name);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHHeatSources::evaluate(bigint next)
{
  const int nlocal = atom->nlocal;
  powers.clear();
  any_above = any_below = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    Source &source = sources[type];
    std::vector<double> each;
    if (!source.variable.empty()) {
      const int variable = input->variable->find(source.variable.c_str());
      modify->clearstep_compute();
      if (input->variable->equalstyle(variable))
        source.power = input->variable->compute_equal(variable);
      else {
        each.resize(nlocal);
        input->variable->compute_atom(variable, 0, each.data(), 1, 0);    // of group all
      }
      modify->addstep_compute(next);
    }
    if (each.empty() && source.power == 0.0) continue;
    powers.resize(nlocal);
    for (int i = 0; i < nlocal; i++) {
      if (atom->type[i] != type) continue;
      powers[i] = each.empty() ? source.power : each[i];
      any_above = any_above || powers[i] > 0.0;
      any_below = any_below || powers[i] < 0.0;
    }
  }
}
