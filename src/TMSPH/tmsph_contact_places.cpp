/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Particles against the segments between the outer particles of another body.
------------------------------------------------------------------------- */

#include "tmsph_contact_places.h"

#include "atom.h"
#include "error.h"
#include "tmsph_wall_shape.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

using Row = SegmentRow;

static constexpr double EQUALLY_DEEP = 1.0e-9;    // in spacings: round-off

// layer between two outlines, in spacings, at least: a particle may stand on the line between two
// of the other body from the start, where the stiffness would have no bound. Outlines that stand
// farther apart do not know of it: 0.01 to 0.5 do the same in test_segments

static constexpr double THINNEST = 0.1;

/* ----------------------------------------------------------------------
   of the centre of i from the line between a and b: half a cell on each side,
   less where the two were closer from the start
------------------------------------------------------------------------- */

double TMSPHContactPlaces::touching_distance(int i, int a, int b, double along) const
{
  const PairTMSPH &pair = *scene.pair;
  const auto half = [&](int p) {
    return 0.5 * scene.bonds->spacing(p) * (1.0 + pair.thermal_strain(p));
  };
  const double cells = half(i) + (1.0 - along) * half(a) + along * half(b);
  const TMSPHContactMemory *memory = memories.find(atom->tag[i]);
  if (!memory || memory->apart == 0.0) return cells;
  const double strain = 0.5 * pair.thermal_strain(i) +
      0.5 * ((1.0 - along) * pair.thermal_strain(a) + along * pair.thermal_strain(b));
  return std::min(cells, memory->apart * (1.0 + strain));
}

/* ----------------------------------------------------------------------
   the deepest first; of those that are equally deep but for round-off, in the order of ids
------------------------------------------------------------------------- */

std::vector<TMSPHContactPlaces::Place> TMSPHContactPlaces::places_of(const Guest &guest,
                                                                     double ahead) const
{
  const int i = guest.i;
  const double *x = atom->x[i];
  std::vector<Place> places;
  std::vector<Point> points;
  for (int c = guest.first; c < guest.last; c++) {
    const int *nodes = outlines.nodes.data() + outlines.chains[c].first;
    const int count = outlines.chains[c].last - outlines.chains[c].first;
    points.clear();
    for (int n = 0; n < count; n++)
      points.push_back({atom->x[nodes[n]][0], atom->x[nodes[n]][1], 0.0});
    const WallPolyline line(points);
    WallTouch touch[2];
    const int found = line.touches({x[0], x[1], 0.0}, OUTLINE_REACH * outlines.coarsest, 1, touch);
    for (int t = 0; t < found; t++) {
      const int segment = touch[t].piece < count - 1 ? touch[t].piece
          : touch[t].piece == 2 * (count - 1)        ? count - 2
                                                     : touch[t].piece - (count - 1);
      Place p;
      p.a = nodes[segment];
      p.b = nodes[segment + 1];
      const Point &A = points[segment], &B = points[segment + 1];
      const double e[2] = {B[0] - A[0], B[1] - A[1]};
      const double along =
          ((x[0] - A[0]) * e[0] + (x[1] - A[1]) * e[1]) / (e[0] * e[0] + e[1] * e[1]);
      p.along = touch[t].piece == 2 * (count - 1) ? 1.0
          : touch[t].piece >= count - 1           ? 0.0
                                                  : std::min(1.0, std::max(0.0, along));
      p.normal[0] = touch[t].normal[0];
      p.normal[1] = touch[t].normal[1];
      p.distance = touch[t].gap;
      p.touching = touching_distance(i, p.a, p.b, p.along);
      p.closing = 0.0;
      double hastening = 0.0;
      const double *mine = rows[i], *a = rows[p.a], *b = rows[p.b];
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
  const auto depth = [this](const Place &p) {
    return std::round((p.touching - p.distance) / (EQUALLY_DEEP * outlines.coarsest));
  };
  std::stable_sort(places.begin(), places.end(),
                   [&depth](const Place &p, const Place &q) { return depth(p) > depth(q); });
  return places;
}

/* ----------------------------------------------------------------------
   the ids of the ends go to all processors that have these
------------------------------------------------------------------------- */

void TMSPHContactPlaces::find(double dt)
{
  const PairTMSPH &pair = *scene.pair;
  const FixTMSPHBond &bonds = *scene.bonds;
  const double ahead = scene.law.ahead(dt);
  for (const int i : outlines.particles)
    if (i < atom->nlocal)
      for (int p = 0; p < Row::PLACES; p++) rows[i][Row::WHERE + p * Row::WHERE_SIZE] = 0.0;

  held.resize(outlines.guests.size());
  for (size_t g = 0; g < held.size(); g++) {
    const int i = outlines.guests[g].i;
    Held &h = held[g];
    const std::vector<Place> places = places_of(outlines.guests[g], ahead);
    h.count = std::min((int) places.size(), Row::PLACES);
    std::copy_n(places.begin(), h.count, h.place);
    h.stiffness = 0.0;
    for (int n = 0; n < h.count; n++) {
      const Place &p = h.place[n];
      const double spacing[2] = {
          bonds.spacing(i), (1.0 - p.along) * bonds.spacing(p.a) + p.along * bonds.spacing(p.b)};
      const HalfCell cells[2] = {{plane_modulus(pair.elastic(i)), spacing[0]},
                                 {plane_modulus(pair.elastic(p.a)), spacing[1]}};
      const double between = 0.5 * (spacing[0] + spacing[1]);
      const double layer = std::max(p.touching, THINNEST * between);
      const double spring =
          half_cells(cells, 2, scene.stiffness * between / layer, p.touching - p.distance) *
          spacing[0];
      h.stiffness = std::max(
          h.stiffness, scene.law.stiffness(spring, scene.stiffness, atom->rmass[i], update->dt));
    }
    for (int n = 0; n < h.count; n++) {
      double *where = rows[i] + Row::WHERE + n * Row::WHERE_SIZE;
      where[Row::START] = ubuf(atom->tag[h.place[n].a]).d;
      where[Row::END] = ubuf(atom->tag[h.place[n].b]).d;
      where[Row::ALONG] = h.place[n].along;
      where[Row::STIFFNESS] = h.place[n].predicted > 0.0 ? h.stiffness : 0.0;
    }
  }
  ghosts.send(rows, Row::WHERE, Row::PLACES * Row::WHERE_SIZE);
}

/* ----------------------------------------------------------------------
   calls use(guest, where, force, weight) for all places at segments that end at
   this particle, in the order of ids
------------------------------------------------------------------------- */

template <class Use> void TMSPHContactPlaces::at_host(const Host &host, Use use) const
{
  const tagint id = atom->tag[host.i];
  for (int n = host.first; n < host.last; n++) {
    const int j = outlines.near[n];
    const double *row = rows[j];
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

/* ---------------------------------------------------------------------- */

double TMSPHContactPlaces::stiffness(int i) const
{
  double sum = 0.0;
  const int guest = outlines.guest_of[i], host = outlines.host_of[i];
  if (guest >= 0)
    for (int n = 0; n < held[guest].count; n++)
      if (held[guest].place[n].predicted > 0.0) sum += held[guest].stiffness;
  if (host >= 0)
    at_host(outlines.hosts[host], [&sum](int, const double *where, const double *, double weight) {
      sum += weight * where[Row::STIFFNESS];
    });
  return sum;
}

/* ---------------------------------------------------------------------- */

void TMSPHContactPlaces::hold(double dt)
{
  for (size_t g = 0; g < held.size(); g++) hold_one(outlines.guests[g], held[g], dt);
  ghosts.send(rows, Row::FORCE, Row::PLACES * Row::FORCE_SIZE);
}

/* ----------------------------------------------------------------------
   a particle of an outline that has been near, or is; else -1
------------------------------------------------------------------------- */

int TMSPHContactPlaces::node(const Guest &guest, tagint id) const
{
  for (int c = guest.first; c < guest.last; c++)
    for (int n = outlines.chains[c].first; n < outlines.chains[c].last; n++)
      if (atom->tag[outlines.nodes[n]] == id) return outlines.nodes[n];
  return -1;
}

/* ----------------------------------------------------------------------
   where an anchor is now
   @return false if its segment is not near any more
------------------------------------------------------------------------- */

bool TMSPHContactPlaces::find_origin(const Guest &guest, const Anchor &anchor, double *origin) const
{
  const int start = node(guest, anchor.start), end = node(guest, anchor.end);
  if (start < 0 || end < 0) return false;
  const double *S = atom->x[start], *E = atom->x[end];
  const double d[2] = {E[0] - S[0], E[1] - S[1]};
  for (int a = 0; a < 2; a++)
    origin[a] = S[a] + anchor.along * d[a] + anchor.left * (a == 0 ? -d[1] : d[0]);
  return true;
}

/* ----------------------------------------------------------------------
   the forces on one particle; an anchor goes with it from one segment to the next
------------------------------------------------------------------------- */

void TMSPHContactPlaces::hold_one(const Guest &guest, const Held &h, double dt)
{
  const int i = guest.i;
  Step step = {scene.law.ahead(dt), h.stiffness, 0.0, {}};
  TMSPHContactMemory &memory = memories.of(atom->tag[i]);
  double frequency = 0.0, normal[2] = {}, predicted[2] = {}, closing[2] = {};
  for (int n = 0; n < h.count; n++) {
    const Place &p = h.place[n];
    predicted[n] = p.predicted;
    closing[n] = p.closing;
    frequency = std::max(frequency,
                         rows[i][Row::COMPLIANCE] + (1.0 - p.along) * rows[p.a][Row::COMPLIANCE] +
                             p.along * rows[p.b][Row::COMPLIANCE]);
  }
  step.q = step.ahead * step.ahead * frequency;
  const double *one = h.place[0].normal, *other = h.place[1].normal;
  const double cosine = h.count == 2 ? one[0] * other[0] + one[1] * other[1] : 0.0;
  hold_across(scene.law, step.k, step.q, frequency, h.count, cosine, predicted, closing, normal);
  for (int n = 0; n < h.count; n++)
    for (int a = 0; a < 2; a++) step.pushed[a] += normal[n] * h.place[n].normal[a];

  std::vector<Anchor> anchors;
  std::vector<char> taken(memory.anchors.size(), 0);
  for (int n = 0; n < h.count; n++) {
    const Place &p = h.place[n];
    double *out = rows[i] + Row::FORCE + n * Row::FORCE_SIZE;
    std::fill_n(out, (int) Row::FORCE_SIZE, 0.0);
    if (!(normal[n] > 0.0) && p.touching - p.distance < -EQUALLY_DEEP * outlines.coarsest) continue;
    double origin[2] = {atom->x[i][0], atom->x[i][1]};
    const int which = anchor_for(memory.anchors.size(), taken.data(), h.count,
                                 [&](int m) { return memory.anchors[m].start == atom->tag[p.a]; });
    if (which >= 0 && find_origin(guest, memory.anchors[which], origin)) taken[which] = 1;
    anchors.push_back(rub(i, p, step, normal[n], origin, out));
  }
  memory.anchors = std::move(anchors);
}

/* ----------------------------------------------------------------------
   friction at a place that touches
   @param normal force
   @param origin where friction is zero; it goes along if the particle slides
   @param out    columns of the row that tell of the place
   @return       the anchor of the next step
------------------------------------------------------------------------- */

TMSPHContactPlaces::Anchor TMSPHContactPlaces::rub(int i, const Place &p, const Step &step,
                                                   double normal, double *origin, double *out)
{
  const double *x = atom->x[i], *A = atom->x[p.a], *B = atom->x[p.b];
  const double e[2] = {B[0] - A[0], B[1] - A[1]}, square = e[0] * e[0] + e[1] * e[1];
  const double tangent[2] = {-p.normal[1], p.normal[0]};
  const double *mine = rows[i], *a = rows[p.a], *b = rows[p.b];
  double slip = 0.0;
  for (int c = 0; c < 2; c++) {
    const auto relative = [&](int column) {
      return mine[column + c] - (1.0 - p.along) * a[column + c] - p.along * b[column + c];
    };
    slip += tangent[c] *
        (x[c] - origin[c] +
         step.ahead *
             (relative(Row::V) +
              step.ahead * (relative(Row::A) + step.pushed[c] / atom->rmass[i])));
  }
  const double ratio = scene.law.shear_ratio(TANGENTIAL);
  const double spacing = scene.bonds->spacing(i);
  const double borne = (1.0 - p.along) * a[Row::BEARS] + p.along * b[Row::BEARS];
  const bool bears = borne > 0.0 || mine[Row::BEARS] != 0.0;
  const double limit = bears ? scene.friction[atom->type[i]][atom->type[p.a]] * normal : 0.0;
  const Friction<1> friction = hold_along<1>(ratio * step.k, ratio * step.q, limit, &slip);
  for (int c = 0; c < 2; c++) origin[c] += friction.excess[0] * tangent[c] - A[c];

  for (int c = 0; c < 2; c++) {
    out[Row::F + c] = friction.force[0] * tangent[c] - normal * p.normal[c];
    out[Row::R + c] = A[c] + p.along * e[c] - x[c];
  }
  out[Row::TOUCHING] = p.touching;
  out[Row::DEPTH] = spacing / (spacing + scene.bonds->spacing(p.a));
  out[Row::BORNE] = borne > 0.0 ? 1.0 / borne : 0.0;
  out[Row::NORMAL] = normal;
  out[Row::HEAT] = friction.work;

  totals.add_place(friction.work, p.touching - p.distance,
                   held_energy<1>(step.k, ratio * step.k, normal, friction.force));
  if (normal > 0.0) {
    totals[TMSPHContactTotals::TOUCHING] += 1.0;
    totals[TMSPHContactTotals::NORMAL] += normal;
  }
  return {atom->tag[p.a], atom->tag[p.b], (origin[0] * e[0] + origin[1] * e[1]) / square,
          (origin[1] * e[0] - origin[0] * e[1]) / square};
}

/* ---------------------------------------------------------------------- */

void TMSPHContactPlaces::add(int i, ContactEffect &counted, ContactEffect &other) const
{
  const double bears = rows[i][Row::BEARS];
  const auto add = [&](int j, double sign, double weight, const double *force, double depth) {
    ContactEffect &effect = atom->type[i] < atom->type[j] ? counted : other;
    const double f[2] = {weight * force[Row::F], weight * force[Row::F + 1]};
    const double borne = sign > 0.0 ? force[Row::BORNE] : force[Row::BORNE] == 0.0;
    const double *r = force + Row::R, length = std::hypot(r[0], r[1]);
    const double normal[2] = {length > 0.0 ? r[0] / length : 1.0,
                              length > 0.0 ? r[1] / length : 0.0};
    effect.add<2>(sign, depth, bears * borne, f, r, normal);
  };
  const int guest = outlines.guest_of[i], host = outlines.host_of[i];
  if (guest >= 0)
    for (int n = 0; n < held[guest].count; n++) {
      const double *force = rows[i] + Row::FORCE + n * Row::FORCE_SIZE;
      add(held[guest].place[n].a, -1.0, 1.0, force, force[Row::DEPTH]);
    }
  if (host >= 0)
    at_host(outlines.hosts[host],
            [&add](int j, const double *, const double *force, double weight) {
              add(j, 1.0, weight, force, 1.0 - force[Row::DEPTH]);
            });
}

/* ----------------------------------------------------------------------
   for heat: a place of area A is worth the weights A kappa/(2 D), divided between the
   ends, since the area of a pair is 2 weight D/kappa
------------------------------------------------------------------------- */

void TMSPHContactPlaces::keep_touches(int i, TMSPHContactMemory &memory) const
{
  using Pressed = TMSPHContactMemory::Pressed;
  const auto keep = [&](tagint partner, int guest, double weight, const double *force) {
    if (!(force[Row::NORMAL] > 0.0) || weight == 0.0) return;
    const double area = atom->vfrac[guest] / scene.bonds->spacing(guest);
    memory.pressed.push_back(
        {partner, weight * area * scene.bonds->interior_kappa() / (2.0 * force[Row::TOUCHING]),
         force[Row::TOUCHING]});
    memory.rubbed += 0.5 * weight * force[Row::HEAT];
  };
  const int guest = outlines.guest_of[i], host = outlines.host_of[i];
  if (guest >= 0)
    for (int n = 0; n < held[guest].count; n++) {
      const Place &p = held[guest].place[n];
      const double *force = rows[i] + Row::FORCE + n * Row::FORCE_SIZE;
      keep(atom->tag[p.a], i, 1.0 - p.along, force);
      keep(atom->tag[p.b], i, p.along, force);
    }
  if (host >= 0)
    at_host(outlines.hosts[host], [&](int j, const double *, const double *force, double weight) {
      keep(atom->tag[j], j, weight, force);
    });
  if (memory.pressed.size() > Row::MOST_PRESSED)
    error->one(FLERR,
               "Particle {} is touched by {} others: method segment of fix tmsph/contact "
               "passes heat to at most {}; use method kernel or closer spacings",
               atom->tag[i], memory.pressed.size(), Row::MOST_PRESSED);
  std::stable_sort(memory.pressed.begin(), memory.pressed.end(),
                   [](const Pressed &p, const Pressed &q) { return p.partner < q.partner; });
}
