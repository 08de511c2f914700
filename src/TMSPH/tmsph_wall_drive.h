/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What moves a wall: velocities and loads, given as numbers or as equal-style
   variables.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_DRIVE_H
#define LMP_TMSPH_WALL_DRIVE_H

#include "pointers.h"
#include "tmsph_wall_scene.h"
#include "tmsph_words.h"

#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class TMSPHWallDrive : protected Pointers {
 public:
  TMSPHWallDrive(class LAMMPS *lmp, TMSPHWallScene &scene) : Pointers(lmp), scene(scene) {}
  /// those of fix tmsph/wall that move it
  std::vector<TMSPHWord> words();
  /// looks for the variables
  void init();

  bool loaded() const { return mass > 0.0; }
  /// dt^2/mass of the wall times the stiffness of all that touch it; only if loaded (collective)
  double dragged(const std::vector<double> &stiffnesses, double dt) const;
  /// acceleration of the wall by its load
  double acceleration(int a) const { return is_free[a] ? load[a].value / mass : 0.0; }
  /// velocities of directions that are not free, and loads, at the present time
  void evaluate();
  /** To the present step: prescribed velocities by the trapezoidal rule, the velocity of free
      directions is that of half a step before.
      @return largest speed and spin in it */
  std::pair<double, double> move(double duration);
  /** The wall itself, in its free directions (collective).
      @param forces on particles of this processor */
  void push(const std::vector<TMSPH::Point> &forces, double dt);

  /// for restarts
  static constexpr int SIZE = 3;
  std::vector<double> loads() const;
  void take_loads(const double *);

 private:
  /** A number or an equal-style variable. */
  struct Given {
    std::string variable;
    int index = -1;
    double value = 0.0;
  };
  TMSPHWallScene &scene;
  Given velocity[3], spin;    // prescribed
  Given load[3];              // of directions that are free
  bool is_free[3] = {};
  double mass = 0.0;      // 0: no direction is free
  bool varies = false;    // some input is a variable

  static Given number_or_variable(TMSPHValues &);
  void read_rotation(TMSPHValues &);
  void read_load(TMSPHValues &);
  double value_of(Given &);
};

}    // namespace LAMMPS_NS
#endif
