/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The heat that flows during an advance of fix tmsph/heat: in the network of the
   bonds, across contacts, from boundaries and sources. It makes the equation that
   is stepped,
     dy/dt = rates(y),
   y the enthalpies of the local particles (energy per mass), then the energies of
   the accounts. The latter are stages of the same scheme as the temperatures, so
   that what is gained and lost adds up to the last digits.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_FLOWS_H
#define LMP_TMSPH_HEAT_FLOWS_H

#include "pointers.h"
#include "tmsph_heat_boundary.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {

class TMSPHGhostSender;
class TMSPHHeatContacts;
class TMSPHHeatMaterials;
class TMSPHHeatNetwork;
class TMSPHHeatSources;

class TMSPHHeatFlows : protected Pointers {
 public:
  /// minus the lowest and the highest of temperatures of this processor
  using Range = std::array<double, 2>;

  TMSPHHeatFlows(class LAMMPS *, const TMSPHHeatMaterials &, TMSPHHeatNetwork &,
                 TMSPHHeatContacts &, TMSPHHeatSources &, TMSPHGhostSender &);
  /// @param steps of heat come every so many time steps
  void init(const std::vector<TMSPHHeatBoundary *> &, int steps);
  /// the time step of the next heat step
  bigint next_step() const;

  /// asks what acts from outside during an advance; at a setup it lasts no time (collective)
  void prepare(double duration);
  /// the longest step of explicit Euler that takes means of temperatures with positive weights
  double stable_step() const { return stable; }
  /// writes the enthalpies of the present temperatures, and zeros behind them
  void start(std::vector<double> &y, int accounts) const;
  void rates(const std::vector<double> &y, std::vector<double> &rate);
  /// of local and ghost particles (collective)
  void put_temperatures(const std::vector<double> &y);
  Range range(const std::vector<double> &y) const;
  /// with the temperatures outside that particles exchange heat with
  Range range_with_outside(const std::vector<double> &y) const;
  /// sources or fluxes move the bounds of the temperatures on some processor: the lower one, the
  /// upper one (collective)
  std::array<bool, 2> bounds_move() const;
  /// some boundary gives the temperature of local particle i
  bool is_held(int i) const { return held[i] != NOT_HELD; }
  /// of local particles, as the last rates had it
  const std::vector<double> &power() const { return powers; }
  double bytes() const;

  // applications of the operator so far, and the stable step, from a restart

  bigint applications() const { return applied; }
  void restart(bigint applications, double stable_step)
  {
    applied = applications;
    stable = stable_step;
  }

 private:
  const TMSPHHeatMaterials &materials;
  TMSPHHeatNetwork &network;
  TMSPHHeatContacts &contacts;
  TMSPHHeatSources &sources;
  TMSPHGhostSender &ghosts;
  std::vector<TMSPHHeatBoundary *> boundaries;
  int every = 1;

  std::vector<TMSPHHeatExchange> exchanges;
  std::vector<int> first_exchange;    // of each boundary, then of friction
  static constexpr int NOT_HELD = -1;
  std::vector<int> held;    // [nlocal] boundary that gives the temperature, or NOT_HELD
  std::vector<double> powers;
  double stable = 0.0;
  bigint applied = 0;

  void list_exchanges(double duration);
  void find_stable_step();
};

}    // namespace LAMMPS_NS

#endif
