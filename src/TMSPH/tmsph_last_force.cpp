/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The order of forces that predict the step from all others.
------------------------------------------------------------------------- */

#include "tmsph_last_force.h"

#include "fix.h"
#include "lammps.h"
#include "modify.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

using namespace LAMMPS_NS;
using namespace FixConst;

enum { IN_ORDER, CONTACT, WALL, PRESCRIBES, AT_END };

static bool is_one_of(const Fix *fix, std::initializer_list<const char *> styles)
{
  return std::any_of(styles.begin(), styles.end(),
                     [fix](const char *style) { return strcmp(fix->style, style) == 0; });
}

static bool prescribes(const Fix *fix)
{
  return is_one_of(fix, {"setforce", "aveforce", "lineforce", "planeforce", "freeze"});
}

/* ----------------------------------------------------------------------
   is there a particle in both groups, on any processor?
------------------------------------------------------------------------- */

static bool overlap(LAMMPS *lmp, const Fix *one, const Fix *other)
{
  const Atom *const atom = lmp->atom;
  int mine = 0, any;
  for (int i = 0; i < atom->nlocal && !mine; i++)
    mine = (atom->mask[i] & one->groupbit) && (atom->mask[i] & other->groupbit);
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, lmp->world);
  return any;
}

/* ----------------------------------------------------------------------
   where fix n comes, then its id where that decides: each wall sees the forces of those before. Who
   adds a force after fix setforce means it to act; a drag does not, as what is held does not move.
------------------------------------------------------------------------- */

static std::pair<int, std::string> place_of(LAMMPS *lmp, int n)
{
  const Modify *const modify = lmp->modify;
  const Fix *const fix = modify->fix[n];
  const int acts_on_forces = POST_FORCE | MIN_POST_FORCE;
  if (utils::strmatch(fix->style, "^tmsph/contact$")) return {CONTACT, ""};
  if (utils::strmatch(fix->style, "^tmsph/wall$")) return {WALL, fix->id};
  if (utils::strmatch(fix->style, "^tmsph/")) return {IN_ORDER, ""};
  if (prescribes(fix)) {
    for (int m = n + 1; m < modify->nfix; m++) {
      const Fix *const later = modify->fix[m];
      if ((modify->fmask[m] & acts_on_forces) && !prescribes(later) &&
          !utils::strmatch(later->style, "^tmsph/") &&
          !is_one_of(later, {"viscous", "enforce2d"}) && overlap(lmp, fix, later))
        return {IN_ORDER, ""};
    }
    return {PRESCRIBES, ""};
  }
  const bool at_end = (modify->fmask[n] & END_OF_STEP) && !(modify->fmask[n] & acts_on_forces) &&
      !fix->time_integrate;
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
    entries.push_back({place_of(lmp, n), n, modify->fix[n], modify->fmask[n]});
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

/* ---------------------------------------------------------------------- */

std::vector<Fix *> TMSPHLastForce::prescribing(LAMMPS *lmp)
{
  std::vector<Fix *> found;
  bool last = false;
  for (Fix *const fix : lmp->modify->get_fix_list()) {
    last = last || is_one_of(fix, {"tmsph/contact", "tmsph/wall"});
    if (last && prescribes(fix)) found.push_back(fix);
  }
  return found;
}

/* ---------------------------------------------------------------------- */

TMSPHLastForce::Prescribed::Prescribed(LAMMPS *lmp, const std::vector<Fix *> &fixes) :
    f(lmp->atom->f)
{
  if (fixes.empty()) return;
  before.assign(f[0], f[0] + 3 * (size_t) lmp->atom->nlocal);
  for (Fix *const fix : fixes) fix->post_force(0);
}

/* ---------------------------------------------------------------------- */

TMSPHLastForce::Prescribed::~Prescribed()
{
  std::copy(before.begin(), before.end(), f[0]);
}
