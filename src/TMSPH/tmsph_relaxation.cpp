/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Moves particles to an irregular arrangement that is as good as a lattice.
------------------------------------------------------------------------- */

#include "tmsph_relaxation.h"

#include "tmsph_cells.h"
#include "tmsph_pi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace TMSPH {

// support of the kernel that pushes, in spacings: the horizon that the documentation gives for
// bonds

static constexpr double PUSH_HORIZON = 3.015;

// A move is STEP spacing^2 times the sum, plus what is left of the move before: differences in
// density run over the body as damped waves. W has the integral 1, so that a long wave goes
// sqrt(STEP) spacings in a move. The longest, of twice the length of the body, falls to DECAY;
// where it is slow it is damped critically, for which BRIEF would be too much. Short waves have
// rates of about 1 per move; 2 is unstable.

static constexpr double STEP = 0.5, BRIEF = 0.9, DECAY = 1.0e-3, BALANCE_KEEPS = 0.8;
static constexpr int LEAST_PUSHES = 150;    // short waves: see test_relax

// in spacings: longest moves, how far particles stay from a surface at least, what they may move
// before lists are made anew

static constexpr double PUSH_MOST = 0.1, BALANCE_MOST = 0.05, MARGIN = 0.05, SKIN = 0.4;

// Both sums hardly see two particles that are close to each other, and let some pairs be. Below
// CORE spacings, where few are in a cloud that is spread, two push each other apart by CORE_PUSH.

static constexpr double CORE = 0.8, CORE_PUSH = 0.5;

// Two mirrors show an image of an image if they stand about across each other; if the angle between
// them is wide, images in one fill what the other lacks.

static constexpr double ACROSS = 0.5;

// a matrix whose determinant is a smaller part of that of an even arrangement has too few bonds

static constexpr double SINGULAR = 1.0e-3;

/* ---------------------------------------------------------------------- */

template <int D>
Relaxation<D>::Relaxation(std::vector<CloudParticle<D>> particles, const CloudBox<D> &box,
                          const BodyShapes<D> &shapes, const CloudBonds &bonds,
                          const CloudShare &share) :
    cloud(std::move(particles)),
    box(box), shapes(shapes), bonds(bonds), share(share)
{
  for (const CloudParticle<D> &p : cloud) spacing.push_back(std::pow(p.size, 1.0 / D));
  smallest = *std::min_element(spacing.begin(), spacing.end());
  largest = *std::max_element(spacing.begin(), spacing.end());
  find_joined();
  inverse.resize(cloud.size());
  make_lists();
}

/* ---------------------------------------------------------------------- */

template <int D> void Relaxation<D>::find_joined()
{
  int bodies = 0, types = 0;
  for (const CloudParticle<D> &p : cloud) {
    bodies = std::max(bodies, p.body + 1);
    types = std::max(types, p.type + 1);
  }
  std::vector<std::vector<char>> has(bodies, std::vector<char>(types));
  for (const CloudParticle<D> &p : cloud) has[p.body][p.type] = true;
  joined.assign(bodies, std::vector<char>(bodies));
  longest = 0.0;
  for (int a = 0; a < bodies; a++)
    for (int b = 0; b < bodies; b++)
      for (int s = 0; s < types; s++)
        for (int t = 0; t < types; t++) {
          if (!has[a][s] || !has[b][t]) continue;
          const double horizon = bonds.horizon[s][t];
          if (horizon > 0.0) joined[a][b] = true;
          longest = std::max(longest, horizon);
        }
}

/// where the kernel that pushes two particles of a body apart vanishes
template <int D> double Relaxation<D>::push_support(int i, int j) const
{
  return cloud[i].body == cloud[j].body ? PUSH_HORIZON * 0.5 * (spacing[i] + spacing[j]) : 0.0;
}

/* ----------------------------------------------------------------------
   particles in the box and their images around it, as far as lists reach
------------------------------------------------------------------------- */

template <int D> void Relaxation<D>::make_points()
{
  const double reach = std::max(PUSH_HORIZON * largest, longest) + SKIN * smallest;
  points.clear(), owner.clear(), shift.clear();
  for (CloudParticle<D> &p : cloud) {
    for (int k = 0; k < D; k++)
      if (box.period[k] > 0.0)
        p.place[k] -= box.period[k] * std::floor((p.place[k] - box.low[k]) / box.period[k]);
    owner.push_back(points.size());
    points.push_back(p.place);
    shift.push_back(Vector::Zero());
  }
  for (int k = 0; k < D; k++) {
    if (box.period[k] == 0.0) continue;
    const int copies = std::ceil(reach / box.period[k]), count = points.size();
    for (int n = -copies; n <= copies; n++)
      for (int q = 0; n && q < count; q++) {
        Vector by = shift[q], at = points[q];
        by[k] += n * box.period[k];
        at[k] += n * box.period[k];
        if (at[k] < box.low[k] - reach || at[k] > box.low[k] + box.period[k] + reach) continue;
        owner.push_back(owner[q]);
        points.push_back(at);
        shift.push_back(by);
      }
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void Relaxation<D>::make_lists()
{
  make_points();
  const int count = points.size();
  std::vector<std::array<double, 3>> x(count, {0.0, 0.0, 0.0});
  std::vector<const double *> rows;
  std::vector<int> members;
  for (int q = 0; q < count; q++) {
    for (int k = 0; k < D; k++) x[q][k] = points[q][k];
    rows.push_back(x[q].data());
    members.push_back(q);
  }
  const double skin = SKIN * smallest;
  const Cells cells(rows.data(), members, std::max(PUSH_HORIZON * largest, longest) + skin);
  offset.assign(1, 0);
  list.clear();
  for (int i = share.first; i < share.last; i++) {
    cells.near(rows[i], [&](int q) {
      const int j = owner[q];
      const double within =
          std::max(push_support(i, j), bonds.horizon[cloud[i].type][cloud[j].type]) + skin;
      if (q != i && (points[q] - points[i]).squaredNorm() < within * within) list.push_back(q);
    });
    offset.push_back(list.size());
  }
  built.clear();
  for (const CloudParticle<D> &p : cloud) built.push_back(p.place);
}

/* ----------------------------------------------------------------------
   the particles have moved
------------------------------------------------------------------------- */

template <int D> void Relaxation<D>::follow()
{
  const double most = 0.5 * SKIN * smallest;
  for (size_t i = 0; i < cloud.size(); i++)
    if ((cloud[i].place - built[i]).squaredNorm() > most * most) {
      make_lists();
      return;
    }
  for (size_t q = 0; q < points.size(); q++) points[q] = cloud[owner[q]].place + shift[q];
}

/* ----------------------------------------------------------------------
   -sum V grad W over neighbors and their mirror images, and those of the particle itself
------------------------------------------------------------------------- */

template <int D> typename Relaxation<D>::Vector Relaxation<D>::pushed(int i) const
{
  const Kernel kernel = WendlandC2();
  const auto mirrors = shapes.planes(cloud[i].body, cloud[i].place, PUSH_HORIZON * largest);
  Vector sum = Vector::Zero();
  const auto add = [&](int j, const Vector &X) {
    const double R = X.norm();
    if (R > 0.0) sum -= cloud[j].size * kernel_slope(kernel, D, R, push_support(i, j)) * X;
  };
  // sets of mirrors that show an image of one point together, as bits
  std::vector<unsigned> sets;
  for (unsigned set = 1; set < 1u << std::min<size_t>(mirrors.size(), 2 * D); set++) {
    bool across = true;
    for (size_t a = 0; a < mirrors.size(); a++)
      for (size_t b = 0; b < a; b++)
        if ((set >> a & 1) && (set >> b & 1))
          across = across && std::fabs(mirrors[a].normal.dot(mirrors[b].normal)) < ACROSS;
    if (across) sets.push_back(set);
  }
  const auto add_images = [&](int j, const Vector &X) {
    for (const unsigned set : sets) {
      Vector image = X;
      bool seen = true;    // by a mirror that it stands before
      for (size_t a = 0; a < mirrors.size(); a++) {
        if (!(set >> a & 1)) continue;
        const double before = mirrors[a].depth - mirrors[a].normal.dot(image);
        seen = seen && before > 0.0;
        image += 2.0 * before * mirrors[a].normal;
      }
      if (seen) add(j, image);
    }
  };
  for (int n = offset[i - share.first]; n < offset[i - share.first + 1]; n++) {
    const int j = owner[list[n]];
    if (cloud[j].body != cloud[i].body) continue;
    const Vector X = points[list[n]] - points[i];
    add(j, X);
    add_images(j, X);
  }
  add_images(i, Vector::Zero());
  return sum;
}

/// away from those that are too close
template <int D> typename Relaxation<D>::Vector Relaxation<D>::off_the_nearest(int i) const
{
  Vector sum = Vector::Zero();
  for (int n = offset[i - share.first]; n < offset[i - share.first + 1]; n++) {
    const Vector X = points[list[n]] - points[i];
    const double core = 0.5 * CORE * (spacing[i] + spacing[owner[list[n]]]), R = X.norm();
    if (R > 0.0 && R < core) sum -= CORE_PUSH * (1.0 - R / core) / (R * spacing[i]) * X;
  }
  return sum;
}

/* ----------------------------------------------------------------------
   where a particle that would go somewhere gets: into the body, and not up to its surface
------------------------------------------------------------------------- */

template <int D>
typename Relaxation<D>::Vector Relaxation<D>::confined(int i, const Vector &to) const
{
  const int body = cloud[i].body;
  if (!shapes.inside(body, to)) return cloud[i].place;
  const double margin = MARGIN * spacing[i];
  Vector inner = to;
  for (const TangentPlane<D> &plane : shapes.planes(body, to, margin))
    inner -= (margin - plane.depth) * plane.normal;
  return shapes.inside(body, inner) ? inner : cloud[i].place;
}

/* ----------------------------------------------------------------------
   one move of all particles
   @param keeps        what is left of the last move
   @param longest_step in spacings
   @param along        the sum of a particle that is moved here
------------------------------------------------------------------------- */

template <int D>
void Relaxation<D>::move(double keeps, double longest_step, const std::function<Vector(int)> &along)
{
  std::vector<double> rows(D * cloud.size());
  for (int i = share.first; i < share.last; i++) {
    Vector &last = motion[i - share.first];
    Vector step = keeps * last + STEP * spacing[i] * spacing[i] * along(i);
    const double length = step.norm(), most = longest_step * spacing[i];
    if (length > most) step *= most / length;
    const Vector to = confined(i, cloud[i].place + step);
    last = to - cloud[i].place;
    std::copy_n(to.data(), D, &rows[D * i]);
  }
  share.complete(rows.data(), D);
  for (size_t i = 0; i < cloud.size(); i++)
    cloud[i].place = Eigen::Map<Vector>(rows.data() + D * i);
  follow();
}

/* ---------------------------------------------------------------------- */

/// of the longest wave of density in any body, in radians per move
template <int D> double Relaxation<D>::lowest_rate() const
{
  std::map<int, std::array<Vector, 2>> ends;    // by body
  for (const CloudParticle<D> &p : cloud) {
    auto &[low, high] = ends.insert({p.body, {p.place, p.place}}).first->second;
    low = low.cwiseMin(p.place);
    high = high.cwiseMax(p.place);
  }
  double most = 1.0;    // spacings across
  for (const CloudParticle<D> &p : cloud) {
    const auto &[low, high] = ends[p.body];
    most = std::max(most, (high - low).maxCoeff() / std::pow(p.size, 1.0 / D));
  }
  return std::sqrt(STEP) * PI / most;
}

template <int D> int Relaxation<D>::pushes() const
{
  return std::max(LEAST_PUSHES, (int) std::ceil(-std::log(DECAY) / lowest_rate()));
}

/* ---------------------------------------------------------------------- */

template <int D> void Relaxation<D>::push(int moves)
{
  const double keeps = std::max(BRIEF, 1.0 - 2.0 * lowest_rate());
  motion.assign(share.last - share.first, Vector::Zero());
  for (int n = 0; n < moves; n++)
    move(keeps, PUSH_MOST, [this](int i) -> Vector { return pushed(i) + off_the_nearest(i); });
}

/* ---------------------------------------------------------------------- */

template <int D> void Relaxation<D>::balance(int moves)
{
  motion.assign(share.last - share.first, Vector::Zero());
  for (int n = 0; n < moves; n++) {
    find_inverses();
    move(BALANCE_KEEPS, BALANCE_MOST, [this](int i) -> Vector {
      return 0.5 * along_surfaces(i, unbalanced(i)) + off_the_nearest(i);
    });
  }
}

/* ----------------------------------------------------------------------
   of the shape matrices; 0 where bonds are too few
------------------------------------------------------------------------- */

template <int D> void Relaxation<D>::find_inverses()
{
  std::vector<double> rows(D * D * cloud.size());
  for (int i = share.first; i < share.last; i++) {
    Matrix K = Matrix::Zero();
    for (int n = offset[i - share.first]; n < offset[i - share.first + 1]; n++) {
      const int j = owner[list[n]];
      const Vector X = points[list[n]] - points[i];
      const double horizon = bonds.horizon[cloud[i].type][cloud[j].type], R = X.norm();
      if (R > 0.0 && horizon > 0.0)
        K += cloud[j].size * kernel_slope(bonds.kernel, D, R, horizon) * X * X.transpose();
    }
    if (K.determinant() > SINGULAR) Eigen::Map<Matrix>(rows.data() + D * D * i) = K.inverse();
  }
  share.complete(rows.data(), D * D);
  for (size_t i = 0; i < cloud.size(); i++)
    inverse[i] = Eigen::Map<Matrix>(rows.data() + D * D * i);
}

/// g of a particle that is moved here
template <int D> typename Relaxation<D>::Vector Relaxation<D>::unbalanced(int i) const
{
  Vector g = Vector::Zero();
  for (int n = offset[i - share.first]; n < offset[i - share.first + 1]; n++) {
    const int j = owner[list[n]];
    const Vector X = points[list[n]] - points[i];
    const double horizon = bonds.horizon[cloud[i].type][cloud[j].type], R = X.norm();
    if (R > 0.0 && horizon > 0.0)
      g -= cloud[j].size * kernel_slope(bonds.kernel, D, R, horizon) *
          ((inverse[i] + inverse[j]) * X);
  }
  return g;
}

/* ----------------------------------------------------------------------
   Without what points across the free surfaces that its bonds reach: an even stress has no force
   there, and the neighbors that are missing leave a g that nothing can balance. Deeper below a
   surface all of g can vanish, though not on a lattice, and then grips and walls at it act evenly.
------------------------------------------------------------------------- */

template <int D> typename Relaxation<D>::Vector Relaxation<D>::along_surfaces(int i, Vector g) const
{
  const CloudParticle<D> &p = cloud[i];
  std::vector<Vector> across;    // an orthonormal basis of their normals
  for (const TangentPlane<D> &plane : shapes.planes(p.body, p.place, longest)) {
    if (plane.beyond != TangentPlane<D>::NOTHING && joined[p.body][plane.beyond]) continue;
    Vector n = plane.normal;
    for (const Vector &known : across) n -= known * known.dot(n);
    if (n.norm() > 0.1) across.push_back(n.normalized());
  }
  for (const Vector &n : across) g -= n * n.dot(g);
  return g;
}

/* ---------------------------------------------------------------------- */

template <int D> std::vector<CloudFigures> Relaxation<D>::figures()
{
  constexpr int WIDTH = 3;
  find_inverses();
  std::vector<double> rows(WIDTH * cloud.size());
  for (int i = share.first; i < share.last; i++) {
    double nearest = HUGE_VAL;
    int neighbor = -1;
    for (int n = offset[i - share.first]; n < offset[i - share.first + 1]; n++) {
      const int j = owner[list[n]];
      const double ratio = (points[list[n]] - points[i]).norm() / (0.5 * (spacing[i] + spacing[j]));
      if (ratio >= nearest) continue;
      nearest = ratio;
      neighbor = j;
    }
    rows[WIDTH * i] = nearest;
    rows[WIDTH * i + 1] = neighbor;
    rows[WIDTH * i + 2] = along_surfaces(i, unbalanced(i)).norm() * spacing[i];
  }
  share.complete(rows.data(), WIDTH);
  std::vector<CloudFigures> all;
  for (size_t i = 0; i < cloud.size(); i++)
    all.push_back({rows[WIDTH * i], (int) rows[WIDTH * i + 1], rows[WIDTH * i + 2]});
  return all;
}

template class Relaxation<2>;
template class Relaxation<3>;

}    // namespace TMSPH
