/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Command tmsph/quasistatic: the thermal clock advances, equilibrium is found
   in each step, bonds that are due break until none is.
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(tmsph/quasistatic,TMSPHQuasistatic);
// clang-format on
#else

#ifndef LMP_TMSPH_QUASISTATIC_H
#define LMP_TMSPH_QUASISTATIC_H

#include "command.h"

#include <vector>

namespace LAMMPS_NS {

struct TMSPHHeatClock;

class TMSPHQuasistatic : public Command {
 public:
  TMSPHQuasistatic(class LAMMPS *lmp);
  void command(int, char **) override;

 private:
  enum { BEFORE, RATE };    // displacements at the start of a step, their growth per time step
  int nsteps;
  double change;         // of a temperature in a step
  double residual[2];    // before the clock goes on, and while bonds break
  double breaking;       // load factor of the bonds that break, of the largest one
  bool jump;
  double stride;         // of a wall in a step, in particle spacings
  bigint evaluations;    // most in one equilibrium

  class PairTMSPH *pair;
  class FixTMSPHBreak *rock;
  class MinTMSPHLBFGS *solver;
  std::vector<TMSPHHeatClock *> clocks;
  std::vector<class FixTMSPHWall *> walls;
  std::vector<class Fix *> stops;    // that act at the end of a step
  double unit;                       // of the norm of all forces, for the residual

  // the way to the first break
  double load, load_before;    // largest load factors, of the last steps; negative: not known
  int covered;                 // time steps of the last step

  struct {
    bigint steps, equilibria, failures, avalanche, avalanche_step, first_step, broken;
  } count;

  struct {
    bigint broken, equilibria;    // of this step
    double start, shown;          // times: of the command, of the last line on the screen
  } life;

  void parse(int, char **);
  void check_fixes();
  void prepare();
  int next_steps(int most);
  int next_stop(int most) const;
  void take_step(int steps);
  void start_afresh();
  bool any_broken() const;
  void extrapolate(int steps);
  void note_rate(int steps);
  void find_equilibrium(double rms);
  void show_life();
  void write_output();
  void tell() const;
};

}    // namespace LAMMPS_NS

#endif
#endif
