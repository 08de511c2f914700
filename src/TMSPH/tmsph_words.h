/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words of an input: a style lists those that it knows in one table, which reads them and makes the
   errors. test_docs compares pages with the words that errors list.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WORDS_H
#define LMP_TMSPH_WORDS_H

#include "pointers.h"

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

/** What follows a word, from left to right. Errors name the style and the word. */
class TMSPHValues : protected Pointers {
 public:
  /** @param what      style and word
      @param takes     see TMSPHWord
      @param next,last the rest of the input */
  TMSPHValues(class LAMMPS *lmp, std::string what, std::string takes, char **next, char **last);

  const char *text();
  double number();
  /// @param rule what allows() asks, after "Fix tmsph/wall friction -1 "
  double number(bool (*allows)(double), const std::string &rule);
  int integer();
  bool logical();
  /// a type or a range of types such as 2, 1*3 or *
  void types(int &lo, int &hi);
  /// takes a variable, v_name, if one is next
  bool variable(std::string &name);
  /// takes the next value if it is this word, which needs further ones
  bool word(const char *name, const char *needs = "");
  /// takes the next value if it is this word and exactly one number follows
  bool word_of_one_number(const char *name);
  template <class T> T one_of(const std::vector<std::pair<std::string, T>> &table)
  {
    const std::string given = text();
    std::vector<std::string> names;
    for (const auto &[name, value] : table) {
      if (name == given) return value;
      names.push_back(name);
    }
    unknown(given, names);
  }
  bool number_follows() const;
  /// the rest is words of another table
  void all(const class TMSPHWords &);
  [[noreturn]] void reject(const std::string &values, const std::string &rule) const;
  /// where the input goes on
  char **rest() const { return next; }

 private:
  std::string what, takes;
  char **next, **last;
  std::vector<std::string> others;    // words that the next value is not, but might be

  void require(const std::string &after, const std::string &names) const;
  std::string start_of_sentence() const;
  [[noreturn]] void unexpected(const std::string &kind, const char *given) const;
  [[noreturn]] void unknown(const std::string &given, const std::vector<std::string> &names) const;
};

/** A word that a style knows. */
struct TMSPHWord {
  std::string name;
  std::string takes;    ///< names of its values; I and J are types, what is in brackets is optional
  std::function<void(TMSPHValues &)> read;
  int dimension = 0;    ///< 2 or 3: only there
};

/** Those of a style, or of one place in its input. */
class TMSPHWords : protected Pointers {
 public:
  TMSPHWords(class LAMMPS *lmp, std::string style, std::vector<TMSPHWord> words) :
      Pointers(lmp), style(std::move(style)), words(std::move(words))
  {
  }
  /** One word with its values.
      @param next,last the rest of the input
      @return what is left of it */
  char **read(char **next, char **last) const;
  /// a single one, which ends the input
  void read_only(char **next, char **last) const;
  /// all of it
  void read_all(char **next, char **last) const;

 private:
  std::string style;
  std::vector<TMSPHWord> words;

  const TMSPHWord &find(const std::string &given) const;
};

namespace TMSPHRule {
inline bool positive(double value)
{
  return value > 0.0 && std::isfinite(value);
}
inline bool not_negative(double value)
{
  return value >= 0.0 && std::isfinite(value);
}
}    // namespace TMSPHRule

}    // namespace LAMMPS_NS

#endif
