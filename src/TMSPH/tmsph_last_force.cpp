/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The order of forces that predict the step from all others.
------------------------------------------------------------------------- */

#include "tmsph_last_force.h"

#include "fix.h"
#include "lammps.h"
#include "modify.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ----------------------------------------------------------------------
   where a fix comes, then its id where that decides: each wall sees the forces of those before
------------------------------------------------------------------------- */

static std::pair<int, std::string> place_of(const Fix *fix, int mask)
{
  enum { IN_ORDER, CONTACT, WALL, AT_END };
  if (utils::strmatch(fix->style, "^tmsph/contact$")) return {CONTACT, ""};
  if (utils::strmatch(fix->style, "^tmsph/wall$")) return {WALL, fix->id};
  const bool at_end = (mask & END_OF_STEP) && !(mask & (POST_FORCE | MIN_POST_FORCE)) &&
      !fix->time_integrate && !utils::strmatch(fix->style, "^tmsph/");
  return {at_end ? AT_END : IN_ORDER, ""};
}

/* ----------------------------------------------------------------------
   LAMMPS knows fixes by their numbers in two places only: in the lists that Modify::init() makes
   later, and in the callbacks of class Atom, which keeps them sorted
------------------------------------------------------------------------- */

void TMSPHLastForce::put_last(LAMMPS *lmp)
{
  Modify *const modify = lmp->modify;
  struct Entry {
    std::pair<int, std::string> place;
    int number;
    Fix *fix;
    int mask;
  };
  std::vector<Entry> entries;
  for (int n = 0; n < modify->nfix; n++)
    entries.push_back({place_of(modify->fix[n], modify->fmask[n]), n, modify->fix[n],
                       modify->fmask[n]});
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry &a, const Entry &b) { return a.place < b.place; });
  std::vector<int> number(entries.size());
  for (int n = 0; n < modify->nfix; n++) {
    modify->fix[n] = entries[n].fix;
    modify->fmask[n] = entries[n].mask;
    number[entries[n].number] = n;
  }
  Atom *const atom = lmp->atom;
  const auto renumber = [&number](int *callbacks, int count) {
    for (int n = 0; n < count; n++) callbacks[n] = number[callbacks[n]];
    std::sort(callbacks, callbacks + count);
  };
  renumber(atom->extra_grow, atom->nextra_grow);
  renumber(atom->extra_restart, atom->nextra_restart);
  renumber(atom->extra_border, atom->nextra_border);
}
