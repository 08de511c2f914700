/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_cut.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_tmsph.h"
#include "tmsph_geometry.h"
#include "tmsph_pi.h"
#include "tmsph_words.h"

#include <cmath>

using namespace LAMMPS_NS;
using TMSPH::Point2;
using TMSPH::Point3;

/* ---------------------------------------------------------------------- */

void TMSPHCut::command(int narg, char **arg)
{
  if (narg < 2) utils::missing_cmd_args(FLERR, "tmsph/cut", error);
  if (!domain->box_exist)
    error->all(FLERR, "Command tmsph/cut before the simulation box is defined");
  const int igroup = group->find(arg[0]);
  if (igroup < 0)
    error->all(FLERR, "Group {} of tmsph/cut does not exist: define it first", arg[0]);
  const int groupbit = group->bitmask[igroup];
  const Flaw flaw = read_flaw(arg + 1, arg + narg);

  auto pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair)
    error->all(FLERR, "Command tmsph/cut needs pair style tmsph and its coefficients before it");
  prepare_bonds();
  FixTMSPHBond *bonds = pair->bonds();

  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (const auto &[k, j, state] : bonds->family(i, FixTMSPHBond::WHOLE)) {
      if (!(atom->mask[j] & groupbit)) continue;
      const bool upward = atom->tag[i] < atom->tag[j];    // both ends decide alike
      const int low = upward ? i : j, high = upward ? j : i;
      double X[3], a[3];
      bonds->reference_vector(low, high, X);
      bonds->reference_in_box(low, a);
      if (!cuts(flaw, *bonds, a, X)) continue;
      bonds->remove_bond(i, k, FixTMSPHBond::CUT);
      mine++;
    }
  }
  bonds->changed();
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (comm->me == 0) {
    utils::logmesg(lmp, "Cut {} bonds\n", all / 2);
    if (all == 0)
      error->warning(FLERR, "The flaw of tmsph/cut crosses no intact bond of group {}", arg[0]);
  }
}

/* ----------------------------------------------------------------------
   A flaw is there once in each period. One that is longer, through the whole body, is there as it
   is given; a bond across the boundary is then tried at both of its ends.
   @param a end of the bond in the box
   @param X vector to its other end
------------------------------------------------------------------------- */

bool TMSPHCut::cuts(const Flaw &flaw, const FixTMSPHBond &bonds, const double *a,
                    const double *X) const
{
  int first[3], last[3];
  for (int k = 0; k < 3; k++) {
    const double b = a[k] + X[k], period = bonds.reference_period(k);
    first[k] = last[k] = 0;
    if (period == 0.0) continue;
    if (flaw.bounds.repeats(k, period)) {
      if (!flaw.bounds.images(k, period, a[k], b, first[k], last[k])) return false;
    } else if (b < bonds.reference_corner(k))
      first[k] = -1;
    else if (b >= bonds.reference_corner(k) + period)
      last[k] = 1;
  }
  for (int nx = first[0]; nx <= last[0]; nx++)
    for (int ny = first[1]; ny <= last[1]; ny++)
      for (int nz = first[2]; nz <= last[2]; nz++) {
        const int n[3] = {nx, ny, nz};
        double from[3], to[3];
        for (int k = 0; k < 3; k++) {
          from[k] = a[k] - n[k] * bonds.reference_period(k);
          to[k] = from[k] + X[k];
        }
        if (flaw.crosses(from, to)) return true;
      }
  return false;
}

/* ----------------------------------------------------------------------
   families must exist and ghosts be at hand: the steps of a run's setup
------------------------------------------------------------------------- */

void TMSPHCut::prepare_bonds()
{
  lmp->init();
  domain->pbc();
  domain->reset_box();
  comm->setup();
  if (neighbor->style) neighbor->setup_bins();
  comm->exchange();
  comm->borders();
  neighbor->build(1);
  modify->get_fix_by_id(FixTMSPHBond::ID)->setup_post_neighbor();
}

/* ---------------------------------------------------------------------- */

TMSPHCut::Flaw TMSPHCut::read_flaw(char **next, char **last)
{
  Flaw flaw;
  if (domain->dimension == 2) flaw.bounds.low[2] = flaw.bounds.high[2] = 0.0;
  TMSPHWords(
      lmp, "tmsph/cut",
      {{"line", "x1 y1 x2 y2", [&](TMSPHValues &v) { read_line(v, flaw); }, 2},
       {"arc", "xc yc r from to", [&](TMSPHValues &v) { read_arc(v, flaw); }, 2},
       {"disc", "x y z nx ny nz r", [&](TMSPHValues &v) { read_disc(v, flaw); }, 3},
       {"polygon", "n [x1 y1 z1 ... xn yn zn]", [&](TMSPHValues &v) { read_polygon(v, flaw); }, 3}})
      .read_only(next, last);
  return flaw;
}

/* ---------------------------------------------------------------------- */

static Point2 read_point2(TMSPHValues &values)
{
  const double x = values.number();
  return Point2(x, values.number());
}

static Point3 read_point3(TMSPHValues &values)
{
  const double x = values.number(), y = values.number();
  return Point3(x, y, values.number());
}

/* ---------------------------------------------------------------------- */

void TMSPHCut::read_line(TMSPHValues &values, Flaw &flaw)
{
  const Point2 p = read_point2(values), q = read_point2(values);
  if (p == q) error->all(FLERR, "The line of tmsph/cut has no length: give two different points");
  flaw.bounds.add(p, 2);
  flaw.bounds.add(q, 2);
  flaw.crosses = [p, q](const double *a, const double *b) {
    return TMSPH::crosses_segment(Point2(a), Point2(b), p, q);
  };
}

/* ---------------------------------------------------------------------- */

void TMSPHCut::read_arc(TMSPHValues &values, Flaw &flaw)
{
  const double radian = TMSPH::PI / 180.0;
  const Point2 center = read_point2(values);
  const double radius = values.number(), from = values.number(), to = values.number();
  const double start = from * radian, sweep = (to - from) * radian;
  char **const end = values.rest();
  if (radius <= 0.0) error->all(FLERR, "Radius {} of the tmsph/cut arc must be positive", end[-3]);
  if (sweep <= 0.0 || to - from > 360.0)
    error->all(FLERR,
               "The arc of tmsph/cut runs counterclockwise from {} to {} degrees: the second "
               "must be larger, by 360 at most",
               end[-2], end[-1]);
  flaw.bounds.add_arc(center, radius, start, sweep);
  flaw.crosses = [=](const double *a, const double *b) {
    return TMSPH::crosses_arc(Point2(a), Point2(b), center, radius, start, sweep);
  };
}

/* ---------------------------------------------------------------------- */

void TMSPHCut::read_disc(TMSPHValues &values, Flaw &flaw)
{
  const Point3 center = read_point3(values), normal = read_point3(values);
  const double radius = values.number();
  if (normal.norm() == 0.0) error->all(FLERR, "The normal of the tmsph/cut disc is zero");
  if (radius <= 0.0)
    error->all(FLERR, "Radius {} of the tmsph/cut disc must be positive", values.rest()[-1]);
  const Point3 unit = normal.normalized();
  const Point3 half = radius * (1.0 - unit.array().square()).max(0.0).sqrt().matrix();
  flaw.bounds.add(Point3(center - half));
  flaw.bounds.add(Point3(center + half));
  flaw.crosses = [=](const double *a, const double *b) {
    return TMSPH::crosses_disc(Point3(a), Point3(b), center, normal, radius);
  };
}

/* ---------------------------------------------------------------------- */

void TMSPHCut::read_polygon(TMSPHValues &values, Flaw &flaw)
{
  const int corners = values.integer();
  if (corners < 3)
    error->all(FLERR, "A polygon of tmsph/cut needs at least 3 corners, not {}", corners);
  std::vector<Point3> corner;
  for (int k = 0; k < corners; k++) corner.push_back(read_point3(values));
  const Point3 area = TMSPH::polygon_normal(corner);
  if (area.norm() == 0.0) error->all(FLERR, "The polygon of tmsph/cut has no area");
  for (const Point3 &p : corner)    // six digits of the input
    if (std::fabs(area.dot(p - corner[0])) > 1.0e-6 * std::pow(area.norm(), 1.5))
      error->all(FLERR, "The polygon of tmsph/cut is not flat: split it into triangles");
  for (const Point3 &p : corner) flaw.bounds.add(p);
  flaw.crosses = [corner](const double *a, const double *b) {
    return TMSPH::crosses_polygon(Point3(a), Point3(b), corner);
  };
}
