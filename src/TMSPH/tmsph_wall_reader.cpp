/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The shape of a wall from the words of fix tmsph/wall.
------------------------------------------------------------------------- */

#include "tmsph_wall_reader.h"

#include "comm.h"
#include "error.h"
#include "text_file_reader.h"
#include "tmsph_pi.h"
#include "tmsph_words.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

static constexpr double DEGREE = PI / 180.0;

/* ---------------------------------------------------------------------- */

std::unique_ptr<WallShape> TMSPHWallReader::read(char **first, char **last, char **&next) const
{
  std::unique_ptr<WallShape> shape;
  const TMSPHWords words(
      lmp, "fix tmsph/wall",
      {{"line", "x1 y1 x2 y2", [&](TMSPHValues &v) { shape = read_line(v); }, 2},
       {"polyline", "N [x1 y1 ... xN yN]", [&](TMSPHValues &v) { shape = read_polyline(v); }, 2},
       {"arc", "x y R phi1 phi2", [&](TMSPHValues &v) { shape = read_arc(v); }, 2},
       {"plane", "x y z nx ny nz", [&](TMSPHValues &v) { shape = read_plane(v); }, 3}});
  next = words.read(first, last);
  return shape;
}

/* ---------------------------------------------------------------------- */

std::unique_ptr<WallShape> TMSPHWallReader::read_line(TMSPHValues &values) const
{
  std::vector<Point> ends(2);
  for (Point &end : ends) end = read_point(values);
  check(ends);
  return std::make_unique<WallPolyline>(ends);
}

/* ---------------------------------------------------------------------- */

std::unique_ptr<WallShape> TMSPHWallReader::read_arc(TMSPHValues &values) const
{
  const Point center = read_point(values);
  const double radius = values.number(), from = values.number(), to = values.number();
  char **const end = values.rest();
  if (!(radius > 0.0))
    error->all(FLERR, "Radius {} of the arc of fix tmsph/wall must be positive", end[-3]);
  if (!(std::fabs(to - from) > 0.0))
    error->all(FLERR, "The arc of fix tmsph/wall has no length: its angles are both {}", end[-2]);
  return std::make_unique<WallArc>(center, radius, from * DEGREE, to * DEGREE);
}

/* ---------------------------------------------------------------------- */

std::unique_ptr<WallShape> TMSPHWallReader::read_plane(TMSPHValues &values) const
{
  double n[6];
  for (double &number : n) number = values.number();
  const double length = std::sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5]);
  if (!(length > 0.0)) error->all(FLERR, "The normal of the plane of fix tmsph/wall has no length");
  return std::make_unique<WallPlane>(Point{n[0], n[1], n[2]},
                                     Point{n[3] / length, n[4] / length, n[5] / length});
}

/* ----------------------------------------------------------------------
   N x1 y1 ... xN yN, or file NAME
------------------------------------------------------------------------- */

std::unique_ptr<WallShape> TMSPHWallReader::read_polyline(TMSPHValues &values) const
{
  std::vector<Point> points;
  if (values.word("file", "name")) {
    points = read_file(values.text());
  } else {
    const int n = values.integer();
    if (n < 2) error->all(FLERR, "Polyline of fix tmsph/wall has {} points: give at least 2", n);
    for (int k = 0; k < n; k++) points.push_back(read_point(values));
  }
  check(points);
  return std::make_unique<WallPolyline>(points);
}

/* ---------------------------------------------------------------------- */

Point TMSPHWallReader::read_point(TMSPHValues &values)
{
  const double x = values.number();
  return {x, values.number(), 0.0};
}

/* ----------------------------------------------------------------------
   two numbers a line; # starts a comment
------------------------------------------------------------------------- */

std::vector<Point> TMSPHWallReader::read_file(const std::string &file) const
{
  std::vector<double> numbers;
  std::string trouble;
  if (comm->me == 0) {
    try {
      TextFileReader reader(file, "polyline");
      while (const char *line = reader.next_line()) {
        ValueTokenizer values(line);
        if (values.count() != 2) {
          trouble = fmt::format("line '{}' needs two numbers, x and y", utils::trim(line));
          break;
        }
        numbers.push_back(values.next_double());
        numbers.push_back(values.next_double());
      }
    } catch (std::exception &e) {
      trouble = e.what();
    }
    if (trouble.empty() && numbers.size() < 4) trouble = "it has less than 2 points";
    if (!trouble.empty())
      error->one(FLERR, "Polyline file {} of fix tmsph/wall: {}", file, trouble);
  }
  int n = numbers.size();
  MPI_Bcast(&n, 1, MPI_INT, 0, world);
  numbers.resize(n);
  MPI_Bcast(numbers.data(), n, MPI_DOUBLE, 0, world);
  std::vector<Point> points;
  for (int k = 0; k < n; k += 2) points.push_back({numbers[k], numbers[k + 1], 0.0});
  return points;
}

/* ---------------------------------------------------------------------- */

void TMSPHWallReader::check(const std::vector<Point> &points) const
{
  for (size_t k = 0; k + 1 < points.size(); k++)
    if (points[k] == points[k + 1])
      error->all(FLERR, "Points {} and {} of the wall of fix tmsph/wall are the same: {} {}", k + 1,
                 k + 2, points[k][0], points[k][1]);
}
