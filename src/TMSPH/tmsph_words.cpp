/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_words.h"

#include "atom.h"
#include "domain.h"
#include "error.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <iterator>
#include <numeric>
#include <sstream>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   a, b or c
------------------------------------------------------------------------- */

static std::string listing(const std::vector<std::string> &names)
{
  std::string text;
  for (size_t k = 0; k < names.size(); k++)
    text += (k == 0 ? "" : k + 1 == names.size() ? " or " : ", ") + names[k];
  return text;
}

/* ----------------------------------------------------------------------
   letters to change, add or remove: Levenshtein, Soviet Physics Doklady 10 (1966) 707
------------------------------------------------------------------------- */

static size_t distance(const std::string &a, const std::string &b)
{
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 0; i < a.size(); i++) {
    size_t diagonal = row[0]++;
    for (size_t j = 0; j < b.size(); j++) {
      const size_t changed = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/* ----------------------------------------------------------------------
   the name that may have been meant, of which at most a third is wrong, or nothing
------------------------------------------------------------------------- */

static std::string perhaps(const std::string &given, const std::vector<std::string> &names)
{
  if (names.empty()) return "";
  const auto nearest =
      *std::min_element(names.begin(), names.end(), [&](const auto &a, const auto &b) {
        return distance(given, a) < distance(given, b);
      });
  return 3 * distance(given, nearest) <= nearest.size() ? fmt::format(", perhaps '{}'", nearest)
                                                        : "";
}

/* ---------------------------------------------------------------------- */

TMSPHValues::TMSPHValues(LAMMPS *lmp, std::string what, std::string takes, char **next,
                         char **last) :
    Pointers(lmp),
    what(std::move(what)), takes(std::move(takes)), next(next), last(last)
{
  require(this->what, this->takes);
}

/* ---------------------------------------------------------------------- */

void TMSPHValues::require(const std::string &after, const std::string &names) const
{
  std::istringstream needed(names.substr(0, names.find('[')));
  const auto count = std::distance(std::istream_iterator<std::string>(needed), {});
  if (last - next < count) utils::missing_cmd_args(FLERR, after + " " + names, error);
}

/* ---------------------------------------------------------------------- */

const char *TMSPHValues::text()
{
  if (next == last) utils::missing_cmd_args(FLERR, what + " " + takes, error);
  others.clear();
  return *next++;
}

/* ---------------------------------------------------------------------- */

double TMSPHValues::number()
{
  if (next != last && !utils::is_double(*next)) unexpected("a floating point number", *next);
  return utils::numeric(FLERR, text(), false, lmp);
}

/* ---------------------------------------------------------------------- */

double TMSPHValues::number(bool (*allows)(double), const std::string &rule)
{
  const double value = number();
  if (!allows(value)) reject(next[-1], rule);
  return value;
}

/* ---------------------------------------------------------------------- */

int TMSPHValues::integer()
{
  if (next != last && !utils::is_integer(*next)) unexpected("an integer", *next);
  return utils::inumeric(FLERR, text(), false, lmp);
}

/* ---------------------------------------------------------------------- */

bool TMSPHValues::logical()
{
  return utils::logical(FLERR, text(), false, lmp);
}

/* ----------------------------------------------------------------------
   a value without its types is a usual mistake, for which LAMMPS's own errors name no word
------------------------------------------------------------------------- */

void TMSPHValues::types(int &lo, int &hi)
{
  const char *const given = text();
  utils::bounds(FLERR, given, 1, atom->ntypes, lo, hi, nullptr);
  if (lo >= 1 && hi <= atom->ntypes && lo <= hi) return;
  std::string usage = what.substr(what.rfind(' ') + 1) + " " + takes;
  for (const char *type : {" I ", " J "})
    if (const size_t at = usage.find(type); at != std::string::npos) usage[at + 1] = '*';
  error->all(FLERR, "{} needs types before the value, and '{}' is no type of 1 to {}: use '{}'",
             start_of_sentence(), given, atom->ntypes, usage);
}

/* ---------------------------------------------------------------------- */

bool TMSPHValues::variable(std::string &name)
{
  const bool given = next != last && utils::strmatch(*next, "^v_");
  if (given)
    name = text() + strlen("v_");
  else
    others.emplace_back("v_name");
  return given;
}

/* ---------------------------------------------------------------------- */

bool TMSPHValues::word(const char *name, const char *needs)
{
  const bool given = next != last && strcmp(*next, name) == 0;
  if (given) {
    text();
    require(what + " " + name, needs);
  } else
    others.emplace_back(name);
  return given;
}

/* ---------------------------------------------------------------------- */

bool TMSPHValues::word_of_one_number(const char *name)
{
  const auto number = [this](int n) { return last - next > n && utils::is_double(next[n]); };
  return number(1) && !number(2) && word(name);
}

/* ---------------------------------------------------------------------- */

bool TMSPHValues::number_follows() const
{
  return next != last && utils::is_double(*next);
}

/* ---------------------------------------------------------------------- */

void TMSPHValues::all(const TMSPHWords &words)
{
  words.read_all(next, last);
  next = last;
}

/* ---------------------------------------------------------------------- */

void TMSPHValues::reject(const std::string &values, const std::string &rule) const
{
  error->all(FLERR, "{} {} {}", start_of_sentence(), values, rule);
}

/* ---------------------------------------------------------------------- */

std::string TMSPHValues::start_of_sentence() const
{
  if (utils::strmatch(what, "^tmsph/")) return "Command " + what;
  std::string text = what;
  text[0] = toupper(text[0]);
  return text;
}

/* ---------------------------------------------------------------------- */

void TMSPHValues::unexpected(const std::string &kind, const char *given) const
{
  std::vector<std::string> names = {kind};
  names.insert(names.end(), others.begin(), others.end());
  error->all(FLERR, "Expected {} for {}, not '{}'", listing(names), what, given);
}

/* ---------------------------------------------------------------------- */

void TMSPHValues::unknown(const std::string &given, const std::vector<std::string> &names) const
{
  error->all(FLERR, "Unknown value '{}' of {}{}: use {}", given, what, perhaps(given, names),
             listing(names));
}

/* ----------------------------------------------------------------------
   in the dimension of the simulation
------------------------------------------------------------------------- */

const TMSPHWord &TMSPHWords::find(const std::string &given) const
{
  std::vector<std::string> names;
  int other = 0;
  bool all = true;    // words are for both dimensions
  for (const TMSPHWord &word : words) {
    const bool here = word.dimension == 0 || word.dimension == domain->dimension;
    all = all && word.dimension == 0;
    if (here && word.name == given) return word;
    if (here) names.push_back(word.name);
    if (!here && word.name == given) other = word.dimension;
  }
  if (other)
    error->all(FLERR, "Word '{}' of {} is for dimension {}, not in {}-D: use {}", given, style,
               other, domain->dimension, listing(names));
  error->all(FLERR, "Unknown word '{}' of {}{}{}: use {}", given, style,
             all ? "" : fmt::format(" in {}-D", domain->dimension), perhaps(given, names),
             listing(names));
}

/* ---------------------------------------------------------------------- */

char **TMSPHWords::read(char **next, char **last) const
{
  if (next == last) utils::missing_cmd_args(FLERR, style, error);
  const TMSPHWord &word = find(*next);
  TMSPHValues values(lmp, style + " " + word.name, word.takes, next + 1, last);
  word.read(values);
  return values.rest();
}

/* ---------------------------------------------------------------------- */

void TMSPHWords::read_only(char **next, char **last) const
{
  char **const rest = read(next, last);
  if (rest == last) return;
  error->all(FLERR, "Unexpected word '{}' after {} {}, which takes {} values: remove it", *rest,
             style, *next, rest - next - 1);
}

/* ---------------------------------------------------------------------- */

void TMSPHWords::read_all(char **next, char **last) const
{
  while (next != last) next = read(next, last);
}
