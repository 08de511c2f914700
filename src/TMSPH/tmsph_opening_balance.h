/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Energies of the openings of a processor: what they took when they were
   finished, what updates gained.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPENING_BALANCE_H
#define LMP_TMSPH_OPENING_BALANCE_H

#include <algorithm>
#include <array>
#include <cmath>

namespace LAMMPS_NS {

class TMSPHOpeningBalance {
 public:
  /// half of each bond at each end: energies that openings took, that they hold, that updates
  /// (0 in theory) and bonds that left the fit gained, and that these lost; area, that of unfinished
  /// ones by their opening; number of opening bonds
  enum { DISSIPATED, STORED, GAINED, LOST, AREA, OPENING, FIGURES };
  using Figures = std::array<double, FIGURES>;

  /// what is finished, for restart files
  const Figures &finished() const { return done; }
  void resume(const Figures &before) { done = before; }
  /// an end of a bond leaves the fit
  void finish(double dissipated, double area)
  {
    done[DISSIPATED] += dissipated;
    done[AREA] += area;
  }
  /// and the fits change by this energy
  void leave(double change) { (change > 0.0 ? done[GAINED] : done[LOST]) += std::fabs(change); }
  /// an update changes what openings hold and took
  void rise_by(double energy) { rise += energy; }
  void end_update() { updated = true; }
  /** At fixed positions no update raises the energy of fits and openings together.
      @param energy of all fits here, as they are evaluated anew */
  void book(double energy)
  {
    if (updated) done[GAINED] += std::max(0.0, energy - fits_energy + rise);
    fits_energy = energy;
    rise = 0.0;
    updated = false;
  }

 private:
  Figures done{};              // of finished openings
  double fits_energy = 0.0;    // when they were evaluated last
  double rise = 0.0;           // of what openings hold and took in updates since then
  bool updated = false;        // there was one
};

}    // namespace LAMMPS_NS
#endif
