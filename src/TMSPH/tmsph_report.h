/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told at the start of a run: styles that have lines of their own,
   tables, and the names of units in them.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_REPORT_H
#define LMP_TMSPH_REPORT_H

#include <string>
#include <vector>

namespace LAMMPS_NS {

/** A fix with lines of its own below those of the pair style. */
struct TMSPHReporter {
  /// tells what it did not tell yet, and warns of what is nonsense in it; the forces of the setup
  /// of a run or minimization are there (collective)
  virtual void tell() = 0;

 protected:
  ~TMSPHReporter() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

namespace TMSPH {

/** Names of units, for people and programs: without spaces, empty in units lj. */
struct UnitNames {
  explicit UnitNames(const std::string &style);
  std::string length, area, volume, time, pressure, density, speed, diffusivity;
  std::string area_energy;            ///< energy per area
  std::string toughness;              ///< pressure times the root of a length
  double meters_per_second;           ///< in a unit of speed; 0: not known
  double square_meters_per_second;    ///< in one of diffusivity
};

/// "name(unit)", or the name alone
std::string heading(const std::string &name, const std::string &unit);

/// so many digits as tables of the report have
std::string digits(double value);

/** Words in columns below their headings. Of many rows, those in sequence that agree but for their
    first word are one, as "3-100", and no more than 20 are shown. */
class TextTable {
 public:
  explicit TextTable(const std::vector<std::string> &headings) : rows{headings} {}
  void add(const std::vector<std::string> &row) { rows.push_back(row); }
  /// one line for each row, indented, columns to the right
  std::string text() const;

 private:
  using Rows = std::vector<std::vector<std::string>>;
  Rows together() const;
  Rows rows;
};

}    // namespace TMSPH
#endif
