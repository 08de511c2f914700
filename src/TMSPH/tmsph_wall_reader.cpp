/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The shape of a wall from the words of fix tmsph/wall.
------------------------------------------------------------------------- */

#include "tmsph_wall_reader.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "text_file_reader.h"
#include "tmsph_pi.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace TMSPH;

static constexpr double DEGREE = PI / 180.0;

/* ----------------------------------------------------------------------
   line, arc or polyline in 2-D, plane in 3-D
------------------------------------------------------------------------- */

std::unique_ptr<WallShape> TMSPHWallReader::read(int narg, char **arg, int &next) const
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "fix tmsph/wall", error);
  const std::string word = arg[3];
  const bool flat = domain->dimension == 2;
  if (word == "polyline" && flat)
    return std::make_unique<WallPolyline>(read_polyline(narg, arg, next));
  const int count = word == "line" && flat ? 4 : word == "arc" && flat ? 5 : 6;
  if (flat ? count == 6 : word != "plane")
    error->all(FLERR, "Unknown shape '{}' of fix tmsph/wall in {}-D: use {}", word,
               domain->dimension, flat ? "line, polyline or arc" : "plane");
  if (narg < 4 + count) utils::missing_cmd_args(FLERR, "fix tmsph/wall " + word, error);
  next = 4 + count;
  double n[6];
  for (int k = 0; k < count; k++) n[k] = utils::numeric(FLERR, arg[4 + k], false, lmp);
  if (word == "line") {
    const std::vector<Point> ends = {{n[0], n[1], 0.0}, {n[2], n[3], 0.0}};
    check(ends);
    return std::make_unique<WallPolyline>(ends);
  }
  if (word == "arc") {
    if (!(n[2] > 0.0))
      error->all(FLERR, "Radius {} of the arc of fix tmsph/wall must be positive", arg[6]);
    if (!(std::fabs(n[4] - n[3]) > 0.0))
      error->all(FLERR, "The arc of fix tmsph/wall has no length: its angles are both {}", arg[7]);
    return std::make_unique<WallArc>(Point{n[0], n[1], 0.0}, n[2], n[3] * DEGREE, n[4] * DEGREE);
  }
  const double length = std::sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5]);
  if (!(length > 0.0))
    error->all(FLERR, "The normal of the plane of fix tmsph/wall has no length");
  return std::make_unique<WallPlane>(Point{n[0], n[1], n[2]},
                                     Point{n[3] / length, n[4] / length, n[5] / length});
}

/* ----------------------------------------------------------------------
   polyline N x1 y1 ... xN yN, or polyline file NAME
------------------------------------------------------------------------- */

std::vector<Point> TMSPHWallReader::read_polyline(int narg, char **arg, int &next) const
{
  if (narg < 6) utils::missing_cmd_args(FLERR, "fix tmsph/wall polyline", error);
  std::vector<Point> points;
  next = 6;
  if (strcmp(arg[4], "file") == 0) {
    points = read_file(arg[5]);
  } else {
    const int n = utils::inumeric(FLERR, arg[4], false, lmp);
    if (n < 2)
      error->all(FLERR, "Polyline of fix tmsph/wall has {} points: give at least 2", arg[4]);
    next = 5 + 2 * n;
    if (narg < next) utils::missing_cmd_args(FLERR, "fix tmsph/wall polyline", error);
    for (int k = 5; k < next; k += 2)
      points.push_back({utils::numeric(FLERR, arg[k], false, lmp),
                        utils::numeric(FLERR, arg[k + 1], false, lmp), 0.0});
  }
  check(points);
  return points;
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
