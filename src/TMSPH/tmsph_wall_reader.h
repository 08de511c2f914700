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
  /// @param first,last what follows the style
  /// @param next       becomes what follows the shape
  std::unique_ptr<TMSPH::WallShape> read(char **first, char **last, char **&next) const;

 private:
  using Points = std::vector<TMSPH::Point>;
  using Shape = std::unique_ptr<TMSPH::WallShape>;

  Shape read_line(class TMSPHValues &) const;
  Shape read_arc(TMSPHValues &) const;
  Shape read_plane(TMSPHValues &) const;
  Shape read_polyline(TMSPHValues &) const;
  static TMSPH::Point read_point(TMSPHValues &);
  Points read_file(const std::string &file) const;
  void check(const Points &) const;
};

}    // namespace LAMMPS_NS
#endif
