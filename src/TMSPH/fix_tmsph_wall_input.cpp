/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words, checks, migration, restart and pictures of fix tmsph/wall.
------------------------------------------------------------------------- */

#include "fix_tmsph_wall.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "input.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "text_file_reader.h"
#include "tmsph_last_force.h"
#include "tmsph_restart.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace TMSPH;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 3.0;

static constexpr double DEGREE = 3.14159265358979323846 / 180.0;

/* ---------------------------------------------------------------------- */

FixTMSPHWall::FixTMSPHWall(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), law(CONTACT_LAWS[0]), friction(0.0), stiffness(1.0),
    both_sides(false), turns(false), is_free{}, mass(0.0), varies(false), repeats{}, middle{},
    warned(false), skin(0.0), travel(0.0), farthest(0.0), version(-1), way(0.0),
    clearance(-HUGE_VAL), radius(0.0), started(false), totals{}, energy(0.0)
{
  if (!atom->vfrac_flag || !atom->rmass_flag)
    error->all(FLERR, "Fix tmsph/wall needs an atom style with volume and mass: atom_style tmsph");
  parse(parse_shape(narg, arg), narg, arg);
  scalar_flag = vector_flag = 1;
  size_vector = NOUTPUT;
  global_freq = 1;
  extscalar = 1;
  extvector = 0;
  energy_global_flag = 1;
  restart_global = restart_peratom = 1;
  stores_ids = 1;
  maxexchange = 14;    // see pack_exchange()
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

FixTMSPHWall::~FixTMSPHWall()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

/* ----------------------------------------------------------------------
   @return index of the word after the shape
------------------------------------------------------------------------- */

int FixTMSPHWall::parse_shape(int narg, char **arg)
{
  if (narg < 4) utils::missing_cmd_args(FLERR, "fix tmsph/wall", error);
  const std::string word = arg[3];
  const bool flat = domain->dimension == 2;
  if (word == "polyline" && flat) return parse_polyline(narg, arg);
  const int count = word == "line" && flat ? 4 : word == "arc" && flat ? 5 : 6;
  if (flat ? count == 6 : word != "plane")
    error->all(FLERR, "Unknown shape '{}' of fix tmsph/wall in {}-D: use {}", word,
               domain->dimension, flat ? "line, polyline or arc" : "plane");
  if (narg < 4 + count) utils::missing_cmd_args(FLERR, "fix tmsph/wall " + word, error);
  double n[6];
  for (int k = 0; k < count; k++) n[k] = utils::numeric(FLERR, arg[4 + k], false, lmp);
  if (word == "line") {
    const std::vector<Point> ends = {{n[0], n[1], 0.0}, {n[2], n[3], 0.0}};
    check_points(ends);
    shape = std::make_unique<WallPolyline>(ends);
  } else if (word == "arc") {
    if (!(n[2] > 0.0))
      error->all(FLERR, "Radius {} of the arc of fix tmsph/wall must be positive", arg[6]);
    if (!(std::fabs(n[4] - n[3]) > 0.0))
      error->all(FLERR, "The arc of fix tmsph/wall has no length: its angles are both {}", arg[7]);
    shape = std::make_unique<WallArc>(Point{n[0], n[1], 0.0}, n[2], n[3] * DEGREE, n[4] * DEGREE);
  } else {
    const double length = std::sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5]);
    if (!(length > 0.0))
      error->all(FLERR, "The normal of the plane of fix tmsph/wall has no length");
    shape = std::make_unique<WallPlane>(
        Point{n[0], n[1], n[2]}, Point{n[3] / length, n[4] / length, n[5] / length});
  }
  return 4 + count;
}

/* ----------------------------------------------------------------------
   polyline N x1 y1 ... xN yN, or polyline file NAME
------------------------------------------------------------------------- */

int FixTMSPHWall::parse_polyline(int narg, char **arg)
{
  if (narg < 6) utils::missing_cmd_args(FLERR, "fix tmsph/wall polyline", error);
  std::vector<Point> points;
  int next = 6;
  if (strcmp(arg[4], "file") == 0) {
    points = read_polyline(arg[5]);
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
  check_points(points);
  shape = std::make_unique<WallPolyline>(points);
  return next;
}

/* ----------------------------------------------------------------------
   two numbers a line; # starts a comment
------------------------------------------------------------------------- */

std::vector<FixTMSPHWall::Point> FixTMSPHWall::read_polyline(const std::string &file) const
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

void FixTMSPHWall::check_points(const std::vector<Point> &points) const
{
  for (size_t k = 0; k + 1 < points.size(); k++)
    if (points[k] == points[k + 1])
      error->all(FLERR, "Points {} and {} of the wall of fix tmsph/wall are the same: {} {}", k + 1,
                 k + 2, points[k][0], points[k][1]);
}

/* ---------------------------------------------------------------------- */

FixTMSPHWall::Input FixTMSPHWall::number_or_variable(const char *word) const
{
  Input input;
  if (utils::strmatch(word, "^v_"))
    input.variable = word + 2;
  else
    input.value = utils::numeric(FLERR, word, false, lmp);
  return input;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::parse(int iarg, int narg, char **arg)
{
  const int d = domain->dimension;
  const auto words_of = [&](const std::string &word) {
    if (word == "velocity") return 1 + d;
    if (word == "rotation") return d == 2 ? 4 : 8;
    if (word == "load") return 3 + d;
    if (word == "friction" || word == "side" || word == "law" || word == "stiffness") return 2;
    error->all(FLERR, "Unknown word '{}' of fix tmsph/wall: use friction, side, velocity, "
                      "rotation, load, law or stiffness", word);
    return 0;
  };
  while (iarg < narg) {
    const std::string word = arg[iarg];
    const int words = words_of(word);
    if (iarg + words > narg) utils::missing_cmd_args(FLERR, "fix tmsph/wall " + word, error);
    char **value = arg + iarg + 1;
    const auto number = [&](int k) { return utils::numeric(FLERR, value[k], false, lmp); };
    if (word == "friction") {
      friction = number(0);
      if (!(friction >= 0.0))
        error->all(FLERR, "Fix tmsph/wall friction {} must not be negative", value[0]);
    } else if (word == "stiffness") {
      stiffness = number(0);
      if (!(stiffness > 0.0))
        error->all(FLERR, "Fix tmsph/wall stiffness {} must be positive: it is a factor to the "
                          "default", value[0]);
    } else if (word == "side") {
      both_sides = strcmp(value[0], "both") == 0;
      if (!both_sides && strcmp(value[0], "one") != 0)
        error->all(FLERR, "Unknown value '{}' of fix tmsph/wall side: use one or both", value[0]);
    } else if (word == "law") {
      const ContactLaw *known = contact_law(value[0]);
      if (!known)
        error->all(FLERR, "Unknown law '{}' of fix tmsph/wall: use {}", value[0], contact_laws());
      law = *known;
    } else if (word == "velocity") {
      for (int a = 0; a < d; a++) velocity[a] = number_or_variable(value[a]);
    } else if (word == "rotation") {
      turns = true;
      for (int a = 0; a < d; a++) motion.pivot[a] = number(a);
      if (d == 3) {
        for (int a = 0; a < 3; a++) motion.axis[a] = number(3 + a);
        const Point &n = motion.axis;
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (!(length > 0.0))
          error->all(FLERR, "The axis of fix tmsph/wall rotation has no length");
        for (double &component : motion.axis) component /= length;
      }
      spin = number_or_variable(value[words - 2]);
    } else if (word == "load") {
      bool any = false;
      for (int a = 0; a < d; a++) {
        is_free[a] = strcmp(value[a], "NULL") != 0;
        any = any || is_free[a];
        if (is_free[a]) load[a] = number_or_variable(value[a]);
      }
      if (!any)
        error->all(FLERR, "All components of fix tmsph/wall load are NULL: give the force of at "
                          "least one direction");
      if (strcmp(value[d], "mass") != 0)
        error->all(FLERR, "Fix tmsph/wall load needs the mass of the wall after its {} components, "
                          "not '{}'", d, value[d]);
      mass = number(d + 1);
      if (!(mass > 0.0))
        error->all(FLERR, "Fix tmsph/wall mass {} must be positive", value[d + 1]);
    }
    iarg += words;
  }
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::setmask()
{
  return POST_FORCE | MIN_POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix tmsph/wall needs pair style tmsph");
  varies = false;
  for (Input *given : {velocity, velocity + 1, velocity + 2, load, load + 1, load + 2, &spin}) {
    if (given->variable.empty()) continue;
    given->index = input->variable->find(given->variable.c_str());
    if (given->index < 0)
      error->all(FLERR, "Variable {} of fix tmsph/wall does not exist: define it first",
                 given->variable);
    if (!input->variable->equalstyle(given->index))
      error->all(FLERR, "Variable {} of fix tmsph/wall must be of equal style", given->variable);
    varies = true;
  }
  version = -1;
  prescribing = TMSPHLastForce::prescribing(lmp);
  find_periods();
}

/* ----------------------------------------------------------------------
   for one particle: anchors or -1, side, force, stamp, the anchors
------------------------------------------------------------------------- */

int FixTMSPHWall::pack_exchange(int i, double *buf)
{
  const auto found = memories.find(atom->tag[i]);
  if (found == memories.end()) {
    buf[0] = ubuf(-1).d;
    return 1;
  }
  const Memory &memory = found->second;
  double *p = buf;
  *p++ = ubuf(memory.count).d;
  *p++ = ubuf(memory.side).d;
  p = std::copy_n(memory.force, 3, p);
  *p++ = ubuf((int64_t) memory.stamp).d;
  for (int n = 0; n < memory.count; n++) {
    *p++ = ubuf(memory.anchors[n].piece).d;
    p = std::copy_n(memory.anchors[n].point.data(), 3, p);
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::unpack_exchange(int nlocal, double *buf)
{
  const double *p = buf;
  const int count = (int) ubuf(*p++).i;
  if (count < 0) return 1;
  const auto take = [&p](double *to) {
    std::copy_n(p, 3, to);
    p += 3;
  };
  Memory &memory = memories[atom->tag[nlocal]];
  memory.count = count;
  memory.side = (int) ubuf(*p++).i;
  take(memory.force);
  memory.stamp = (std::uint64_t) ubuf(*p++).i;
  for (int n = 0; n < count; n++) {
    memory.anchors[n].piece = (int) ubuf(*p++).i;
    take(memory.anchors[n].point.data());
  }
  return p - buf;
}

/* ----------------------------------------------------------------------
   outputs, stored energy, position and velocity of the wall
------------------------------------------------------------------------- */

void FixTMSPHWall::write_restart(FILE *fp)
{
  TMSPHLastForce::stamp(lmp, memories);
  std::vector<double> list = {RESTART_FORMAT};
  for (int n = 0; n < NTOTALS; n++) list.push_back(compute_vector(n));
  list.push_back(compute_scalar());
  for (double s : motion.shift) list.push_back(s);
  for (double v : motion.velocity) list.push_back(v);
  for (double value : {motion.angle, motion.spin, started ? 1.0 : 0.0}) list.push_back(value);
  for (const Input &given : load) list.push_back(given.value);
  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::restart(char *buf)
{
  double list[1 + NTOTALS + 13];
  memcpy(list, buf, sizeof(double));
  check_restart_format(error, "fix tmsph/wall", list[0], RESTART_FORMAT);
  memcpy(list, buf, sizeof(list));
  const double *p = list + 1;
  if (comm->me == 0) {
    std::copy_n(p, (int) NTOTALS, totals);
    energy = p[NTOTALS];
  }
  p += NTOTALS + 1;
  for (double &s : motion.shift) s = *p++;
  for (double &v : motion.velocity) v = *p++;
  motion.angle = *p++;
  motion.spin = *p++;
  started = *p++ > 0.0;
  for (Input &given : load)
    if (!given.variable.empty()) given.value = *p++;
    else p++;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);    // LAMMPS wants the length first
  return 1 + pack_exchange(i, buf + 1);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::unpack_restart(int nlocal, int nth)
{
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(*extra);
  unpack_exchange(nlocal, extra + 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::size_restart(int i)
{
  const auto found = memories.find(atom->tag[i]);
  return found == memories.end() ? 2 : 1 + 6 + 4 * found->second.count;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::maxsize_restart()
{
  return 1 + maxexchange;
}

/* ----------------------------------------------------------------------
   to be drawn, where the wall is now: a plane as far as the box is seen
------------------------------------------------------------------------- */

std::vector<TMSPH::Point> FixTMSPHWall::corners() const
{
  Point middle;
  double square = 0.0;
  for (int k = 0; k < 3; k++) {
    middle[k] = 0.5 * (domain->boxlo[k] + domain->boxhi[k]);
    square += domain->prd[k] * domain->prd[k];
  }
  std::vector<Point> points = shape->picture(motion.to_body(middle), std::sqrt(square));
  for (Point &p : points) p = motion.to_space(p);
  return points;
}

/* ----------------------------------------------------------------------
   lines in 2-D, in 3-D triangles that share the first corner
------------------------------------------------------------------------- */

std::vector<std::vector<TMSPH::Point>> FixTMSPHWall::pieces() const
{
  const std::vector<Point> points = corners();
  std::vector<std::vector<Point>> out;
  const bool flat = domain->dimension == 2;
  for (size_t n = flat ? 0 : 1; n + 1 < points.size(); n++) {
    out.emplace_back();
    if (!flat) out.back().push_back(points[0]);
    out.back().push_back(points[n]);
    out.back().push_back(points[n + 1]);
  }
  return out;
}

/* ----------------------------------------------------------------------
   for dump image, which takes one fix only: any wall draws all of them
------------------------------------------------------------------------- */

int FixTMSPHWall::image(int *&kinds, double **&values)
{
  enum { LINE = 1, TRIANGLE = 2 };    // as in dump_image.cpp
  picture.clear();
  for (Fix *fix : modify->get_fix_by_style("^tmsph/wall$"))
    for (const auto &piece : dynamic_cast<FixTMSPHWall *>(fix)->pieces()) {
      std::array<double, 10> row = {1.0};
      double *to = row.data() + 1;
      for (const Point &p : piece) to = std::copy(p.begin(), p.end(), to);
      picture.push_back(row);
    }
  picture_rows.clear();
  for (auto &row : picture) picture_rows.push_back(row.data());
  picture_kinds.assign(picture.size(), domain->dimension == 2 ? LINE : TRIANGLE);
  kinds = picture_kinds.data();
  values = picture_rows.data();
  return picture.size();
}

/* ---------------------------------------------------------------------- */

double FixTMSPHWall::memory_usage()
{
  return candidates.capacity() * sizeof(Candidate) + touching.capacity() * sizeof(Touching) +
      memories.size() * (sizeof(Memory) + sizeof(tagint));
}
