/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   How openings begin and grow, and when a bond leaves the fit.
------------------------------------------------------------------------- */

#include "tmsph_openings.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_open_row.h"
#include "tmsph_opening_update.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;
using namespace TMSPH;

namespace {

// a bond leaves the fit only if the smallest eigenvalue of Kbar stays above this part of that in
// the interior at both its ends; chosen, not scanned, in the study of opening bonds with shear

constexpr double LEAST_SHAPE = 0.2;

// updates until a bond that may not leave the fit is tried again

constexpr double PATIENCE = 20.0;

// A bond may leave if the fits of its ends gain no more than this part of what its opening took.
// They gain a little where it has gone where they want it: free faces are free of stress only
// nearly. All gains together are to stay below 1e-4

constexpr double MOST_GAIN = 2.0e-5;

// so close are tractions to their laws, in units of the strength; more than a few sweeps are rare

constexpr double CLOSE_TO_LAW = 1.0e-3;
constexpr int MOST_SWEEPS = 30;

// in a search for equilibrium, whose forces are to be a derivative; less than the residual, in the
// same unit, with which tmsph/quasistatic ends one

constexpr double CLOSE_IN_SEARCH = 1.0e-5;
constexpr int MOST_IN_SEARCH = 300;

// Changes of openings are found with so much more than half of the second derivative, with which no
// update from where it is gains energy. Updates that build on each other are stable with 3/2 of it:
// a mode of curvature l swings out where the step is longer than (2 + 2 b)/(1 + 2 b)/l with the
// momentum b, up to 1. A tenth more for what the bound leaves out

constexpr double SURELY = 1.65;

// opened by this part of the end of the law a bond is fully open

constexpr double FULLY = 0.999;

// bonds along the faces of a crack do not open it; with the cosine the area that they stand for
// goes to zero

constexpr double SMALLEST_COSINE = 1.0e-6;

// the area of a bond is at least and at most so many times that in the interior, where
// K = V kappa I

constexpr double SMALLEST_AREA = 0.2, LARGEST_AREA = 5.0;

template <int D> double least_of_shape(const SquareMatrix<D> &inverse, double volume, double kappa)
{
  Eigen::SelfAdjointEigenSolver<SquareMatrix<D>> eigen;
  eigen.computeDirect(inverse, Eigen::EigenvaluesOnly);
  const double largest = eigen.eigenvalues()[D - 1];
  return largest > 0.0 ? 1.0 / (largest * volume * kappa) : 0.0;
}

/// direction of the largest principal stress; compiled once: the same bits at both ends of a bond
template <int D> [[gnu::noinline]] Column<D> pulled_direction(const double *stress)
{
  SquareMatrix<D> s;
  for (int a = 0, k = D; a < D; a++) {
    s(a, a) = stress[a];
    for (int b = a + 1; b < D; b++) s(a, b) = s(b, a) = stress[k++];
  }
  const Eigen::SelfAdjointEigenSolver<SquareMatrix<D>> eigen(s);
  return eigen.eigenvectors().col(D - 1);
}

/// energy that an opening took
double taken_by(const CohesiveLaw &law, const OpenBond &b)
{
  return b.area * std::visit([&](auto one) { return dissipated_energy(one, b.opening); }, law);
}

/// N or -N, that with N.X > 0; 0 if X lies along the faces
template <int D> Column<D> towards(const Column<D> &N, const double *X)
{
  const Eigen::Map<const Column<D>> along(X);
  const double cosine = N.dot(along) / along.norm();
  if (!(std::fabs(cosine) > SMALLEST_COSINE)) return Column<D>::Zero();
  return cosine > 0.0 ? N : -N;
}

/// N of the crack that a stress opens across bond (i, j), N.X > 0, in the material; 0 along its faces
template <int D>
Column<D> crack_normal(const FixTMSPHBond &bonds, const TMSPHGhostRows &rows, int i, int j,
                       const double *stress)
{
  using O = OpenRow<D>;
  const Column<D> n = pulled_direction<D>(stress);
  const auto back = [&](int p) {    // what of the body is seen in the material
    const double *const r = rows[p];
    const SquareMatrix<D> R = r[O::LEAST] > 0.0
        ? row_major<D>(r + O::R)
        : Polar<D>(SquareMatrix<D>::Identity() + row_major<D>(r + O::H)).rotation;
    return Column<D>(R.transpose() * n);
  };
  const Column<D> one = back(i), other = back(j), N = (one + other).normalized();
  double X[3];
  bonds.reference_vector(i, j, X);
  return towards<D>(N, X);
}

}    // namespace

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::exchange(const TMSPHBondState &s, const char *near)
{
  using O = OpenRow<D>;
  using R = Rows<D>;
  make_rows(O::WIDTH);
  near_column = O::NEAR;
  kinematic = s.kinematic;
  heated = s.on.thermal == ThermalStrain::BOND;
  const double *const own_side = s.own_side ? s.own_side->gradients() : nullptr,
                      *const gradient = own_side ? own_side : s.gradient;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *const own = s.slices.constants<D>(i);
    const auto constant = [&](int n) { return own[TMSPH::LANES * (SYMMETRIC<D> + n)]; };
    double *const r = rows[i];
    std::copy_n(s.kinematic + (size_t) i * R::KINEMATIC + R::U, D, r + O::U);
    std::copy_n(gradient + (size_t) i * D * D, D * D, r + O::H);
    r[O::CHI] = constant(3);
    r[O::MODULUS] = D * constant(1) + 2.0 * constant(2);
    r[O::NEAR] = near && near[i];
    r[O::LEAST] = 0.0;    // no openings
  }
  fill_open_rows<D>(s);
  const auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  for (size_t n = 0; n < open.size(); n++) {
    const auto &fit = fits[n];
    rows[open[n]][O::LEAST] =
        std::max(least_of_shape<D>(fit.shape_inverse, fit.volume, bonds.interior_kappa()),
                 std::numeric_limits<double>::min());
    if (near) find_candidate<D>(open[n], fit, s.on.law);
  }
  ghosts.send(rows, 0, O::WIDTH);
}

/* ----------------------------------------------------------------------
   Of the fully open bonds of a particle the one that is open most may leave the fit, if it is
   that of its partner too: then no decision depends on another one of the same step. What its
   leaving does to the energy is tried here, each end for itself.
------------------------------------------------------------------------- */

template <int D>
void TMSPHOpenings::find_candidate(int i, const OpenFit<D> &fit, const ElasticLaw &elastic_law)
{
  using O = OpenRow<D>;
  double *const r = rows[i];
  r[O::CANDIDATE] = ubuf((tagint) 0).d;
  r[O::RISE] = HUGE_VAL;
  int best = -1;
  double most = 0.0;
  for (int m = 0; m < values.count(i); m++) {    // by ascending ids: ties go to the lowest
    const OpenBond &b = bond(i, m);
    if (b.patience > 0.0 || b.opening.now < FULLY * b.opening.end) continue;
    const double opened = b.opening.now / b.opening.end;
    if (opened <= most) continue;
    most = opened;
    best = values.place(i, m);
  }
  if (best < 0) return;
  r[O::CANDIDATE] = ubuf(bonds.partner_tag(i, best)).d;
  OpenFit<D> without = fit;
  SquareMatrix<D> K = SquareMatrix<D>::Zero();
  auto &all = without.bonds;
  all.erase(std::remove_if(all.begin(), all.end(), [=](const auto &b) { return b.place == best; }),
            all.end());
  for (const auto &b : all) K += b.weight * b.X * b.X.transpose();
  Eigen::SelfAdjointEigenSolver<SquareMatrix<D>> eigen;
  eigen.computeDirect(K, Eigen::EigenvaluesOnly);
  if (!(eigen.eigenvalues()[0] > LEAST_SHAPE * fit.volume * bonds.interior_kappa())) return;
  without.shape_inverse = K.inverse();
  std::visit([&without](auto elastic) { without.evaluate(elastic); }, elastic_law);
  r[O::RISE] = without.energy - fit.energy;
}

/* ---------------------------------------------------------------------- */

template <int D> double TMSPHOpenings::relative(int i, int j, double *X, double *u) const
{
  using R = Rows<D>;
  using O = OpenRow<D>;
  double x[3];
  bonds.reference_vector(i, j, x);
  const double *const mine = kinematic + (size_t) i * R::KINEMATIC,
                      *const his = kinematic + (size_t) j * R::KINEMATIC;
  const double young = mine[R::YOUNG] + his[R::YOUNG];
  const double push = heated ? mine[R::THERMAL] + his[R::THERMAL] : 0.0;
  double square = 0.0;
  for (int a = 0; a < D; a++) {
    X[a] = x[a];
    u[a] = (young * (rows[j][O::U + a] - rows[i][O::U + a]) - push * x[a]) / (young + push);
    square += x[a] * x[a];
  }
  return std::sqrt(square);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::add_residual(int i, int j, double *stress) const
{
  using O = OpenRow<D>;
  double X[D], u[D], r[D];
  const double R = relative<D>(i, j, X, u);
  const double *const mine = rows[i], *const his = rows[j];
  const bool lame[2] = {mine[O::CHI] == 0.0, his[O::CHI] == 0.0};
  if (lame[0] && lame[1]) return;
  const double part_i = lame[0] ? 0.0 : lame[1] ? 1.0 : 0.5, part_j = 1.0 - part_i;
  double along = 0.0, square = 0.0;
  for (int a = 0; a < D; a++) {
    r[a] = u[a];
    for (int b = 0; b < D; b++)
      r[a] -= (part_i * mine[O::H + D * a + b] + part_j * his[O::H + D * a + b]) * X[b];
    along += r[a] * X[a];
    square += r[a] * r[a];
  }
  if (!(along > 0.0)) return;
  const double scale =
      0.5 * (mine[O::CHI] + his[O::CHI]) * bonds.interior_kappa() / (R * std::sqrt(square));
  for (int a = 0, n = D; a < D; a++) {
    stress[a] += scale * r[a] * r[a];
    for (int b = a + 1; b < D; b++) stress[n++] += scale * r[a] * r[b];
  }
}

/* ---------------------------------------------------------------------- */

bool TMSPHOpenings::crosses(int i, int j, const double *stress) const
{
  return domain->dimension == 2 ? !crack_normal<2>(bonds, rows, i, j, stress).isZero()
                                : !crack_normal<3>(bonds, rows, i, j, stress).isZero();
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOpenings::begin(int i, int k, int j, const double *stress, double strength,
                          double crack_energy)
{
  const Column<D> N = crack_normal<D>(bonds, rows, i, j, stress);
  OpenBond b;
  b.opening.strength = strength;
  b.opening.end = std::visit(
      [&](auto one) { return crack_energy / (decltype(one)::area(1.0) * strength); }, law);
  std::copy_n(N.data(), D, b.normal);
  std::copy_n(reinterpret_cast<double *>(&b), OPEN_BOND_SIZE, values.insert(i, k, atom->nmax));
}

/* ----------------------------------------------------------------------
   Of the crack that bonds open together. The direction that one bond is pulled in follows the bond
   itself: its residual, and the end that is nearer to the tip. So oblique ones would count too much
   area, N.X, and slide where the faces are pressed together. All that are open at both ends have a
   say in the normal of those that begin, as much as they have area.
------------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::sum_normals(int i, double *sum) const
{
  std::fill_n(sum, SYMMETRIC<D>, 0.0);
  for (int m = 0; m < values.count(i); m++) {
    const double *const N = bond(i, m).normal;
    double X[3], along = 0.0;
    const int j = bonds.partner_index(i, values.place(i, m));
    bonds.reference_vector(i, j, X);
    for (int a = 0; a < D; a++) along += N[a] * X[a];
    along *= bonds.weight(i, j);
    for (int a = 0, n = D; a < D; a++) {
      sum[a] += along * N[a] * N[a];
      for (int b = a + 1; b < D; b++) sum[n++] += along * N[a] * N[b];
    }
  }
}

/* ----------------------------------------------------------------------
   A = W N.(V_i K_i^-1 + V_j K_j^-1) X with the shapes of before anything opened
------------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::complete(const TMSPHBondState &s)
{
  using O = OpenRow<D>;
  if (!shapes.carried()) {
    shapes.start(atom->nmax);
    for (int i = 0; i < atom->nlocal; i++)
      for (int n = 0; n < SYMMETRIC<D>; n++)
        shapes[i][n] = s.slices.constants<D>(i)[TMSPH::LANES * n];
  }
  list_open();
  for (const int i : open) {
    for (int a = 0, n = 0; a < D; a++)
      for (int b = a; b < D; b++)
        rows[i][O::R + D * a + b] = rows[i][O::R + D * b + a] = atom->vfrac[i] * shapes[i][n++];
    sum_normals<D>(i, rows[i] + O::T);
  }
  ghosts.send(rows, O::R, 2 * D * D);
  for (const int i : open)
    for (int m = 0; m < values.count(i); m++) {
      OpenBond &one = bond(i, m);
      if (one.area > 0.0) continue;
      const int j = bonds.partner_index(i, values.place(i, m));
      double X[3], sum[6];
      bonds.reference_vector(i, j, X);
      for (int n = 0; n < SYMMETRIC<D>; n++) sum[n] = rows[i][O::T + n] + rows[j][O::T + n];
      const Column<D> N = towards<D>(pulled_direction<D>(sum), X);
      if (!N.isZero()) std::copy_n(N.data(), D, one.normal);
      const double W = bonds.weight(i, j);
      double across = 0.0, along = 0.0;
      for (int a = 0; a < D; a++) {
        along += one.normal[a] * X[a];
        for (int b = 0; b < D; b++)
          across += one.normal[a] * (rows[i][O::R + D * a + b] + rows[j][O::R + D * a + b]) * X[b];
      }
      const double inside = 2.0 * W * along / bonds.interior_kappa();
      one.area = std::clamp(W * std::fabs(across), SMALLEST_AREA * inside, LARGEST_AREA * inside);
    }
}

/* ----------------------------------------------------------------------
   All openings follow at once, again and again, until the tractions are on their laws.
------------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::update(TMSPHBondState s)
{
  s.stress = nullptr;    // ghosts have that of before
  follow_laws<D>(s, false);
  settle();
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::relax(TMSPHBondState s)
{
  s.stress = nullptr;
  s.own_side = nullptr;    // nothing is tested
  exchange<D>(s, nullptr);
  follow_laws<D>(s, true);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::follow_laws(const TMSPHBondState &s, bool search)
{
  using O = OpenRow<D>;
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  auto followed = followed_bonds<D>();
  const auto energy_of_openings = [this] {
    const auto sum = figures();
    return sum[TMSPHOpeningBalance::DISSIPATED] + sum[TMSPHOpeningBalance::STORED];
  };
  account.rise_by(-energy_of_openings());
  const double close = search ? CLOSE_IN_SEARCH : CLOSE_TO_LAW;
  const int most = search ? MOST_IN_SEARCH : MOST_SWEEPS;
  for (int sweep = 0; sweep < most; sweep++) {
    if (sweep) {
      for (size_t n = 0; n < open.size(); n++) {
        OpenFit<D> &fit = fits[n];
        std::visit([&fit](auto elastic) { fit.respond(elastic); }, s.on.law);
        store<D>(fit.back(), rows[open[n]] + O::T);
      }
      ghosts.send(rows, O::T, D * D);
    }
    double mine = 0.0, largest;
    std::visit(
        [&](auto one) {
          auto b = followed.begin();
          for (size_t n = 0; n < open.size(); n++) {
            const double *const T = rows[open[n]] + O::T;
            SquareMatrix<D> jumps = SquareMatrix<D>::Zero();
            for (; b != followed.end() && b->fit == (int) n; b++) {
              mine = std::max(mine, b->update(one, T, rows[b->partner] + O::T));
              jumps += b->weight * b->jump() * b->X.transpose();
            }
            fits[n].jumps = jumps;
          }
        },
        law);
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    if (largest <= close * close) break;
  }
  if (!search)
    for (FollowedBond<D> &b : followed) decide_leaving<D>(open[b.fit], b.partner, *b.bond);
  account.rise_by(energy_of_openings());
  account.end_update();
  take_jumps<D>();
  evaluate<D>(s);
  fill_open_rows<D>(s);
  if (!search) ghosts.send(rows, O::H, D * D);
}

/* ----------------------------------------------------------------------
   from the rows of both ends
------------------------------------------------------------------------- */

template <int D> std::vector<FollowedBond<D>> TMSPHOpenings::followed_bonds()
{
  using O = OpenRow<D>;
  std::vector<FollowedBond<D>> all;
  const auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  for (size_t n = 0; n < open.size(); n++)
    for (const FitBond<D> &seen : fits[n].bonds) {
      if (!seen.open()) continue;
      const double *const mine = rows[open[n]], *const his = rows[seen.partner];
      FollowedBond<D> one;
      one.bond = &bond(open[n], seen.number);
      one.fit = n;
      one.partner = seen.partner;
      one.X = seen.X;
      one.mine = turned_back<D>(mine + O::R, seen.u);
      one.his = turned_back<D>(his + O::R, -seen.u);
      one.weight = seen.weight;
      one.chi_mine = mine[O::CHI];
      one.chi_his = his[O::CHI];
      one.stiffness = SURELY *
          opening_stiffness(seen.weight, 0.5 * (mine[O::MODULUS] + his[O::MODULUS]),
                            bonds.interior_kappa(),
                            std::min(1.0, std::min(mine[O::LEAST], his[O::LEAST])),
                            0.5 * (mine[O::CHI] + his[O::CHI]), one.bond->area);
      std::copy_n(one.bond->jump, D, one.c.data());
      std::copy_n(one.bond->uneven, D, one.e.data());
      all.push_back(one);
    }
  return all;
}

/* ----------------------------------------------------------------------
   both ends see the same candidates and decide alike
------------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::decide_leaving(int i, int j, OpenBond &b)
{
  using O = OpenRow<D>;
  const double *const mine = rows[i] + O::CANDIDATE, *const his = rows[j] + O::CANDIDATE;
  b.patience = std::max(0.0, b.patience - 1.0);
  if (ubuf(mine[0]).i != (bigint) atom->tag[j] || ubuf(his[0]).i != (bigint) atom->tag[i]) return;
  if (mine[1] + his[1] <= MOST_GAIN * taken_by(law, b)) {
    b.leaves = 1.0;
    account.leave(0.5 * (mine[1] + his[1]));    // of the bond, half at each end
  } else
    b.patience = PATIENCE;
}

/* ---------------------------------------------------------------------- */

std::vector<TMSPHOpenings::Leaving> TMSPHOpenings::leaving()
{
  std::vector<Leaving> all;
  for (const int i : open)
    for (int m = values.count(i) - 1; m >= 0; m--)
      if (bond(i, m).leaves != 0.0) {
        const OpenBond &b = bond(i, m);
        const double taken = taken_by(law, b);
        all.push_back({i, values.place(i, m), taken});
        account.finish(0.5 * taken, 0.5 * b.area);
      }
  return all;
}

/* ---------------------------------------------------------------------- */

#define INSTANTIATE(D)                                                                  \
  template void TMSPHOpenings::exchange<D>(const TMSPHBondState &, const char *);       \
  template void TMSPHOpenings::add_residual<D>(int, int, double *) const;               \
  template void TMSPHOpenings::begin<D>(int, int, int, const double *, double, double); \
  template void TMSPHOpenings::complete<D>(const TMSPHBondState &);                     \
  template void TMSPHOpenings::update<D>(TMSPHBondState);                               \
  template void TMSPHOpenings::relax<D>(TMSPHBondState);

INSTANTIATE(2)
INSTANTIATE(3)
