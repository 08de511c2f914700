/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The shape of a wall from the words of fix tmsph/wall.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_READER_H
#define LMP_TMSPH_WALL_READER_H

#include "pointers.h"
#include "tmsph_wall_shape.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class TMSPHWallReader : protected Pointers {
 public:
  explicit TMSPHWallReader(class LAMMPS *lmp) : Pointers(lmp) {}
  /// @param next becomes the index of the word after the shape
  std::unique_ptr<TMSPH::WallShape> read(int narg, char **arg, int &next) const;

 private:
  using Points = std::vector<TMSPH::Point>;

  Points read_polyline(int narg, char **arg, int &next) const;
  Points read_file(const std::string &file) const;
  void check(const Points &) const;
};

}    // namespace LAMMPS_NS
#endif
