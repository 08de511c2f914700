/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Particles against the segments between the outer particles of another body,
   in 2-D: the hybrid friction contact of Mu et al. (2022), Sect. 3. One pass,
   the finer body against the outline of the coarser one. The owner of a
   particle finds its force; the owners of the ends of the segment learn it
   from the particle, and add it in the order of ids.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "tmsph_contact_law.h"
#include "tmsph_wall_shape.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

using Row = SegmentRow;

static constexpr double EQUALLY_DEEP = 1.0e-9;    // in spacings

// layer between two outlines, in spacings, at least: a particle may stand on the line between two
// of the other body from the start

static constexpr double THINNEST = 0.1;

/* ----------------------------------------------------------------------
   of the centre of i from the line between a and b: half a cell on each side,
   less where the two were closer from the start
------------------------------------------------------------------------- */

double FixTMSPHContact::touching_distance(int i, int a, int b, double along) const
{
  const auto half = [this](int p) {
    return 0.5 * bonds->spacing(p) * (1.0 + pair->thermal_strain(p));
  };
  const double cells = half(i) + (1.0 - along) * half(a) + along * half(b);
  const auto found = memories.find(atom->tag[i]);
  if (found == memories.end() || found->second.apart == 0.0) return cells;
  const double strain = 0.5 * pair->thermal_strain(i) +
      0.5 * ((1.0 - along) * pair->thermal_strain(a) + along * pair->thermal_strain(b));
  return std::min(cells, found->second.apart * (1.0 + strain));
}

/* ----------------------------------------------------------------------
   where the local particles touch, as they are and at the end of the step; the
   ids of the ends go to all processors that have these
------------------------------------------------------------------------- */

void FixTMSPHContact::find_places(double dt)
{
  Segments &s = *segments;
  const double ahead = law.ahead(dt);
  const auto row = [this](int i) { return rows.data() + (size_t) width * i; };
  for (const Member &m : members)
    for (int p = 0; p < Row::PLACES; p++) row(m.i)[Row::WHERE + p * Row::WHERE_SIZE] = 0.0;
  for (const int i : s.outline)
    if (i < atom->nlocal)
      for (int p = 0; p < Row::PLACES; p++) row(i)[Row::WHERE + p * Row::WHERE_SIZE] = 0.0;

  std::vector<Point> points;
  for (Slave &slave : s.slaves) {
    const int i = slave.i;
    const double *x = atom->x[i];
    const Point here = {x[0], x[1], 0.0};
    std::vector<Place> places;
    for (int c = slave.first; c < slave.last; c++) {
      const int *nodes = s.nodes.data() + s.chains[c].first;
      const int count = s.chains[c].second - s.chains[c].first;
      points.clear();
      for (int n = 0; n < count; n++)
        points.push_back({atom->x[nodes[n]][0], atom->x[nodes[n]][1], 0.0});
      const WallPolyline line(points);
      WallTouch touch[2];
      const int found = line.touches(here, OUTLINE_REACH * s.coarsest, 1, touch);
      for (int t = 0; t < found; t++) {
        const int segment = touch[t].piece < count - 1 ? touch[t].piece
            : touch[t].piece == 2 * (count - 1)        ? count - 2
                                                       : touch[t].piece - (count - 1);
        Place p;
        p.a = nodes[segment];
        p.b = nodes[segment + 1];
        const Point &A = points[segment], &B = points[segment + 1];
        const double e[2] = {B[0] - A[0], B[1] - A[1]};
        const double along = ((x[0] - A[0]) * e[0] + (x[1] - A[1]) * e[1]) /
            (e[0] * e[0] + e[1] * e[1]);
        p.along = touch[t].piece == 2 * (count - 1) ? 1.0
            : touch[t].piece >= count - 1           ? 0.0
                                                    : std::min(1.0, std::max(0.0, along));
        p.normal[0] = touch[t].normal[0];
        p.normal[1] = touch[t].normal[1];
        p.distance = touch[t].gap;
        p.touching = touching_distance(i, p.a, p.b, p.along);
        p.closing = 0.0;
        double hastening = 0.0;
        const double *mine = row(i), *a = row(p.a), *b = row(p.b);
        for (int k = 0; k < 2; k++) {
          const auto relative = [&](int column) {
            return mine[column + k] - (1.0 - p.along) * a[column + k] - p.along * b[column + k];
          };
          p.closing -= p.normal[k] * relative(Row::V);
          hastening -= p.normal[k] * relative(Row::A);
        }
        p.predicted = p.touching - p.distance + ahead * (p.closing + ahead * hastening);
        places.push_back(p);
      }
    }
    // the deepest first; of those that are equally deep but for round-off, in the order of ids

    const auto depth = [&s](const Place &p) {
      return std::round((p.touching - p.distance) / (EQUALLY_DEEP * s.coarsest));
    };
    std::stable_sort(places.begin(), places.end(), [&depth](const Place &p, const Place &q) {
      return depth(p) > depth(q);
    });
    slave.count = std::min((int) places.size(), Row::PLACES);
    std::copy_n(places.begin(), slave.count, slave.place);
    slave.stiffness = 0.0;
    for (int n = 0; n < slave.count; n++) {
      const Place &p = slave.place[n];
      const double spacing[2] = {bonds->spacing(i), (1.0 - p.along) * bonds->spacing(p.a) +
                                                          p.along * bonds->spacing(p.b)};
      const HalfCell cells[2] = {{plane_modulus(pair->elastic(i)), spacing[0]},
                                 {plane_modulus(pair->elastic(p.a)), spacing[1]}};
      const double between = 0.5 * (spacing[0] + spacing[1]);
      const double layer = std::max(p.touching, THINNEST * between);
      const double spring =
          half_cells(cells, 2, stiffness * between / layer, p.touching - p.distance) * spacing[0];
      slave.stiffness = std::max(
          slave.stiffness, law.stiffness(spring, stiffness, atom->rmass[i], update->dt));
    }
    for (int n = 0; n < slave.count; n++) {
      double *where = row(i) + Row::WHERE + n * Row::WHERE_SIZE;
      where[Row::START] = ubuf(atom->tag[slave.place[n].a]).d;
      where[Row::END] = ubuf(atom->tag[slave.place[n].b]).d;
      where[Row::ALONG] = slave.place[n].along;
      where[Row::STIFFNESS] = slave.place[n].predicted > 0.0 ? slave.stiffness : 0.0;
    }
  }
  send(Row::WHERE, Row::PLACES * Row::WHERE_SIZE);
}

/* ----------------------------------------------------------------------
   calls use(slave, where, force, weight) for all places at segments that end at
   this particle, in the order of ids
------------------------------------------------------------------------- */

template <class Use> void FixTMSPHContact::places_at_master(const Master &m, Use use) const
{
  const tagint id = atom->tag[m.i];
  for (int n = m.first; n < m.last; n++) {
    const int j = segments->near[n];
    const double *row = rows.data() + (size_t) width * j;
    for (int p = 0; p < Row::PLACES; p++) {
      const double *where = row + Row::WHERE + p * Row::WHERE_SIZE;
      const double *force = row + Row::FORCE + p * Row::FORCE_SIZE;
      const auto start = (tagint) ubuf(where[Row::START]).i;
      if (start == 0) continue;
      if (start == id) use(j, where, force, 1.0 - where[Row::ALONG]);
      if ((tagint) ubuf(where[Row::END]).i == id) use(j, where, force, where[Row::ALONG]);
    }
  }
}

/* ----------------------------------------------------------------------
   of all places that press on local particle i
------------------------------------------------------------------------- */

double FixTMSPHContact::segment_stiffness(int i) const
{
  const Segments &s = *segments;
  double sum = 0.0;
  if (s.slave_of[i] >= 0) {
    const Slave &slave = s.slaves[s.slave_of[i]];
    for (int n = 0; n < slave.count; n++)
      if (slave.place[n].predicted > 0.0) sum += slave.stiffness;
  }
  if (s.master_of[i] >= 0)
    places_at_master(s.masters[s.master_of[i]], [&sum](int, const double *where, const double *,
                                                       double weight) {
      sum += weight * where[Row::STIFFNESS];
    });
  return sum;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::hold_places(double dt)
{
  for (Slave &slave : segments->slaves) hold(slave, dt);
  send(Row::FORCE, Row::PLACES * Row::FORCE_SIZE);
}

/* ----------------------------------------------------------------------
   the forces on one particle; an anchor goes with it from one segment to the next
------------------------------------------------------------------------- */

void FixTMSPHContact::hold(Slave &slave, double dt)
{
  const Segments &s = *segments;
  const int i = slave.i;
  const double *x = atom->x[i];
  const double ahead = law.ahead(dt), k = slave.stiffness;
  const auto row = [this](int p) { return rows.data() + (size_t) width * p; };
  Memory &memory = memories[atom->tag[i]];
  double frequency = 0.0, normal[2] = {}, predicted[2] = {}, pushed[2] = {};
  for (int n = 0; n < slave.count; n++) {
    const Place &p = slave.place[n];
    predicted[n] = p.predicted;
    frequency = std::max(frequency, row(i)[Row::COMPLIANCE] +
                             (1.0 - p.along) * row(p.a)[Row::COMPLIANCE] +
                             p.along * row(p.b)[Row::COMPLIANCE]);
  }
  const double q = ahead * ahead * frequency;
  if (slave.count == 2) {
    const double *one = slave.place[0].normal, *other = slave.place[1].normal;
    implicit_corner(k, q, one[0] * other[0] + one[1] * other[1], predicted, normal);
  } else if (slave.count == 1)
    normal[0] = implicit_normal(k, q, predicted[0]);
  for (int n = 0; n < slave.count; n++) {
    if (normal[n] > 0.0)
      normal[n] = law.normal(normal[n], k, frequency, slave.place[n].closing);
    for (int a = 0; a < 2; a++) pushed[a] += normal[n] * slave.place[n].normal[a];
  }

  // a particle of an outline that has been near, or is

  const auto node = [&](tagint id) {
    for (int c = slave.first; c < slave.last; c++)
      for (int n = s.chains[c].first; n < s.chains[c].second; n++)
        if (atom->tag[s.nodes[n]] == id) return s.nodes[n];
    return -1;
  };
  std::vector<Anchor> anchors;
  std::vector<char> taken(memory.anchors.size(), 0);
  for (int n = 0; n < slave.count; n++) {
    const Place &p = slave.place[n];
    double *out = row(i) + Row::FORCE + n * Row::FORCE_SIZE;
    std::fill_n(out, (int) Row::FORCE_SIZE, 0.0);
    if (!(normal[n] > 0.0) && p.touching - p.distance < -EQUALLY_DEEP * s.coarsest) continue;

    const double *A = atom->x[p.a], *B = atom->x[p.b];
    const double e[2] = {B[0] - A[0], B[1] - A[1]}, square = e[0] * e[0] + e[1] * e[1];
    const double tangent[2] = {-p.normal[1], p.normal[0]};
    double origin[2] = {x[0], x[1]};
    int which = -1;
    for (int m = 0; m < (int) memory.anchors.size(); m++) {
      const bool same = memory.anchors[m].start == atom->tag[p.a];
      if (!taken[m] && (same || (which < 0 && slave.count == 1))) which = m;
    }
    if (which >= 0) {
      const Anchor &anchor = memory.anchors[which];
      const int start = node(anchor.start), end = node(anchor.end);
      if (start >= 0 && end >= 0) {
        taken[which] = 1;
        const double *S = atom->x[start], *E = atom->x[end];
        const double d[2] = {E[0] - S[0], E[1] - S[1]};
        for (int a = 0; a < 2; a++)
          origin[a] = S[a] + anchor.along * d[a] + anchor.left * (a == 0 ? -d[1] : d[0]);
      }
    }

    const double *mine = row(i), *a = row(p.a), *b = row(p.b);
    double slip = 0.0;
    for (int c = 0; c < 2; c++) {
      const auto relative = [&](int column) {
        return mine[column + c] - (1.0 - p.along) * a[column + c] - p.along * b[column + c];
      };
      slip += tangent[c] * (x[c] - origin[c] + ahead *
          (relative(Row::V) + ahead * (relative(Row::A) + pushed[c] / atom->rmass[i])));
    }
    const double ratio = law.shear_ratio(TANGENTIAL);
    const double share = bonds->spacing(i) / (bonds->spacing(i) + bonds->spacing(p.a));
    const double borne = (1.0 - p.along) * a[Row::BEARS] + p.along * b[Row::BEARS];
    const bool held = borne > 0.0 || mine[Row::BEARS] != 0.0;
    const double limit = held ? friction[atom->type[i]][atom->type[p.a]] * normal[n] : 0.0;
    double rubbing, excess;
    implicit_friction<1>(ratio * k, ratio * q, limit, &slip, &rubbing, &excess);
    for (int c = 0; c < 2; c++) origin[c] += excess * tangent[c] - A[c];
    anchors.push_back({atom->tag[p.a], atom->tag[p.b],
                       (origin[0] * e[0] + origin[1] * e[1]) / square,
                       (origin[1] * e[0] - origin[0] * e[1]) / square});

    for (int c = 0; c < 2; c++) {
      out[Row::F + c] = rubbing * tangent[c] - normal[n] * p.normal[c];
      out[Row::R + c] = A[c] + p.along * e[c] - x[c];
    }
    out[Row::TOUCHING] = p.touching;
    out[Row::SHARE] = share;
    out[Row::BORNE] = borne > 0.0 ? 1.0 / borne : 0.0;
    out[Row::NORMAL] = normal[n];
    out[Row::HEAT] = rubbing * excess;

    totals[WORK] += rubbing * excess;
    totals[DEEPEST] = std::max(totals[DEEPEST], p.touching - p.distance);
    if (normal[n] > 0.0) {
      totals[TOUCHING] += 1.0;
      totals[NORMAL] += normal[n];
    }
    energy += 0.5 * normal[n] * normal[n] / k + 0.5 * rubbing * rubbing / (ratio * k);
  }
  memory.anchors = std::move(anchors);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::add_places(int i, Effect &counted, Effect &other) const
{
  const Segments &s = *segments;
  const double bears = rows[(size_t) width * i + Row::BEARS];
  const auto add = [&](int j, double sign, double weight, const double *force, double share) {
    Effect &effect = atom->type[i] < atom->type[j] ? counted : other;
    const double f[2] = {weight * force[Row::F], weight * force[Row::F + 1]};
    const double borne = sign > 0.0 ? force[Row::BORNE] : force[Row::BORNE] == 0.0;
    const double *r = force + Row::R, length = std::hypot(r[0], r[1]);
    const double normal[2] = {length > 0.0 ? r[0] / length : 1.0, length > 0.0 ? r[1] / length : 0.0};
    effect.add<2>(sign, share, bears * borne, f, r, normal);
  };
  if (s.slave_of[i] >= 0)
    for (int n = 0; n < s.slaves[s.slave_of[i]].count; n++) {
      const double *force = rows.data() + (size_t) width * i + Row::FORCE + n * Row::FORCE_SIZE;
      add(s.slaves[s.slave_of[i]].place[n].a, -1.0, 1.0, force, force[Row::SHARE]);
    }
  if (s.master_of[i] >= 0)
    places_at_master(s.masters[s.master_of[i]],
                     [&add](int j, const double *, const double *force, double weight) {
                       add(j, 1.0, weight, force, 1.0 - force[Row::SHARE]);
                     });
}

/* ----------------------------------------------------------------------
   for heat: a place of area A is worth the weights A kappa/(2 D), shared between the
   ends, since the area of a pair is 2 weight D/kappa
------------------------------------------------------------------------- */

void FixTMSPHContact::keep_places(int i, Memory &memory) const
{
  const Segments &s = *segments;
  const auto keep = [&](tagint partner, int slave, double share, const double *force) {
    if (!(force[Row::NORMAL] > 0.0) || share == 0.0) return;
    const double area = atom->vfrac[slave] / bonds->spacing(slave);
    memory.pressed.push_back({partner, share * area * bonds->interior_kappa() /
                                           (2.0 * force[Row::TOUCHING]), force[Row::TOUCHING]});
    memory.rubbed += 0.5 * share * force[Row::HEAT];
  };
  if (s.slave_of[i] >= 0) {
    const Slave &slave = s.slaves[s.slave_of[i]];
    for (int n = 0; n < slave.count; n++) {
      const Place &p = slave.place[n];
      const double *force = rows.data() + (size_t) width * i + Row::FORCE + n * Row::FORCE_SIZE;
      keep(atom->tag[p.a], i, 1.0 - p.along, force);
      keep(atom->tag[p.b], i, p.along, force);
    }
  }
  if (s.master_of[i] >= 0)
    places_at_master(s.masters[s.master_of[i]],
                     [&](int j, const double *, const double *force, double weight) {
                       keep(atom->tag[j], j, weight, force);
                     });
  if (memory.pressed.size() > PRESSED_AT_SEGMENTS)
    error->one(FLERR, "Particle {} is touched by {} others: method segment of fix tmsph/contact "
                      "passes heat to at most {}; use method kernel or closer spacings",
               atom->tag[i], memory.pressed.size(), PRESSED_AT_SEGMENTS);
  std::stable_sort(memory.pressed.begin(), memory.pressed.end(),
                   [](const Pressed &p, const Pressed &q) { return p.partner < q.partner; });
}
