/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What fixes that press on surfaces, walls and contact, tell of stresses.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PRESSES_H
#define LMP_TMSPH_PRESSES_H

#include <vector>

namespace LAMMPS_NS {

class TMSPHPresses {
 public:
  /** Stress of the cell of local particle i by forces on its surface, which no bond carries:
      xx yy zz xy xz yz. */
  struct Load {
    int i;
    bool outermost;    // the forces reach the outermost particles only, not those behind
    double stress[6];
  };
  /// adds those of the last force evaluation (collective)
  virtual void add_loads(std::vector<Load> &) = 0;
  /// false if there are no loads on any processor; asked after add_loads(), the same on all
  virtual bool may_press() const { return true; }

 protected:
  ~TMSPHPresses() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

#endif
