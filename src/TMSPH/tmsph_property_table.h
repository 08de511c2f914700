/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   A property of a material as a function of temperature: a number, or points
   joined by straight lines, constant before the first and after the last.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PROPERTY_TABLE_H
#define LMP_TMSPH_PROPERTY_TABLE_H

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace TMSPH {

class PropertyTable {
 public:
  explicit PropertyTable(double value = 0.0) : T{0.0}, values{value}, integrals{0.0} {}

  /** @param temperatures strictly ascending, at least one
      @param given        as many values, all positive */
  PropertyTable(std::vector<double> temperatures, std::vector<double> given) :
      T(std::move(temperatures)), values(std::move(given)), integrals(T.size(), 0.0)
  {
    for (size_t n = 1; n < T.size(); n++)
      integrals[n] = integrals[n - 1] + 0.5 * (values[n - 1] + values[n]) * (T[n] - T[n - 1]);
  }

  bool constant() const { return T.size() == 1; }
  double smallest() const { return *std::min_element(values.begin(), values.end()); }
  double largest() const { return *std::max_element(values.begin(), values.end()); }

  double operator()(double temperature) const
  {
    if (constant()) return values[0];
    const size_t n = segment(T, temperature);
    return values[n] + slope(n, temperature < T[0]) * (temperature - T[n]);
  }

  /// Integral of the property from the first point's temperature; of a number from 0.
  double integral(double temperature) const
  {
    if (constant()) return values[0] * temperature;
    const size_t n = segment(T, temperature);
    const double d = temperature - T[n];
    return integrals[n] + d * (values[n] + 0.5 * slope(n, d < 0.0) * d);
  }

  /// The temperature at which integral() has this value.
  double temperature_at(double integral) const
  {
    if (constant()) return integral / values[0];
    const size_t n = segment(integrals, integral);
    const double rest = integral - integrals[n], s = slope(n, rest < 0.0);
    return T[n] + 2.0 * rest / (values[n] + std::sqrt(values[n] * values[n] + 2.0 * s * rest));
  }

 private:
  std::vector<double> T, values, integrals;

  /// the last point at or before x, the first point if there is none
  static size_t segment(const std::vector<double> &points, double x)
  {
    const auto after = std::upper_bound(points.begin() + 1, points.end(), x);
    return after - points.begin() - 1;
  }

  double slope(size_t n, bool before) const
  {
    if (before || n + 1 == T.size()) return 0.0;
    return (values[n + 1] - values[n]) / (T[n + 1] - T[n]);
  }
};

}    // namespace TMSPH
#endif
