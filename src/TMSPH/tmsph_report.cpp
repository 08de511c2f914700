/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_report.h"

#include "utils.h"

#include <algorithm>

namespace TMSPH {

/* ----------------------------------------------------------------------
   composed of those of mass, length and time; si and cgs have names of their own
------------------------------------------------------------------------- */

UnitNames::UnitNames(const std::string &style) :
    meters_per_second(0.0), square_meters_per_second(0.0)
{
  std::string mass;
  if (style == "si") {
    mass = "kg", length = "m", time = "s";
    meters_per_second = square_meters_per_second = 1.0;
  } else if (style == "cgs") {
    mass = "g", length = "cm", time = "s";
    meters_per_second = 0.01, square_meters_per_second = 1.0e-4;
  } else if (style == "micro") {
    mass = "pg", length = "um", time = "us";
    meters_per_second = 1.0, square_meters_per_second = 1.0e-6;
  } else if (style == "nano") {
    mass = "ag", length = "nm", time = "ns";
    meters_per_second = 1.0, square_meters_per_second = 1.0e-9;
  } else
    return;
  area = length + "2";
  volume = length + "3";
  density = mass + "/" + volume;
  speed = length + "/" + time;
  diffusivity = area + "/" + time;
  pressure = style == "si" ? "Pa"
      : style == "cgs"     ? "dyn/cm2"
                           : mass + "/" + length + "/" + time + "2";
  area_energy = style == "si" ? "J/m2" : style == "cgs" ? "erg/cm2" : mass + "/" + time + "2";
  toughness = pressure + "*" + length + "^.5";
}

/* ---------------------------------------------------------------------- */

std::string heading(const std::string &name, const std::string &unit)
{
  return unit.empty() ? name : name + "(" + unit + ")";
}

/* ---------------------------------------------------------------------- */

std::string digits(double value)
{
  return fmt::format("{:.4g}", value);
}

/* ---------------------------------------------------------------------- */

TextTable::Rows TextTable::together() const
{
  Rows some;
  for (const auto &row : rows)
    if (!some.empty() && std::equal(row.begin() + 1, row.end(), some.back().begin() + 1))
      some.back()[0] = some.back()[0].substr(0, some.back()[0].find('-')) + "-" + row[0];
    else
      some.push_back(row);
  return some;
}

/* ---------------------------------------------------------------------- */

std::string TextTable::text() const
{
  static constexpr size_t MOST = 21;    // with the headings: screens have 24 lines
  Rows shown = rows.size() > MOST ? together() : rows;
  const size_t more = shown.size() > MOST ? shown.size() - MOST : 0;
  shown.resize(shown.size() - more);
  std::vector<size_t> widths(rows[0].size(), 0);
  for (const auto &row : shown)
    for (size_t c = 0; c < row.size(); c++) widths[c] = std::max(widths[c], row[c].size());
  std::string lines;
  for (const auto &row : shown) {
    for (size_t c = 0; c < row.size(); c++) lines += fmt::format("  {:>{}}", row[c], widths[c]);
    lines += "\n";
  }
  return more ? lines + fmt::format("  and {} more\n", more) : lines;
}

}    // namespace TMSPH
