/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_openings.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

namespace {

/** What a bond that opens, or may, needs from its other end. The first part is there for all
    particles, the second for those with openings. */
template <int D> struct OpenRow {
  static constexpr int U = 0, H = D, CHI = H + D * D, MODULUS = CHI + 1, NEAR = MODULUS + 1;
  static constexpr int R = NEAR + 1, B = R + D * D, LEAST = B + D * D, CANDIDATE = LEAST + 1,
                       RISE = CANDIDATE + 1, WIDTH = RISE + 1;
};

// a bond leaves the fit only if the smallest eigenvalue of Kbar stays above this part of that in the
// interior at both its ends; chosen, not scanned, in the study of opening bonds with shear

constexpr double LEAST_SHAPE = 0.2;

// updates until a bond that may not leave the fit is tried again

constexpr double PATIENCE = 20.0;

// so close are tractions to their laws, in units of the strength; more than a few sweeps are rare

constexpr double CLOSE_TO_LAW = 1.0e-3;
constexpr int MOST_SWEEPS = 30;

// opened by this part of the end of the law a bond is fully open

constexpr double FULLY = 0.999;

// bonds along the faces of a crack do not open it; with the cosine the area that they stand for goes
// to zero

constexpr double SMALLEST_COSINE = 1.0e-6;

// The area of a bond is at least and at most so many times that in the interior, where K = V kappa I

constexpr double SMALLEST_AREA = 0.2, LARGEST_AREA = 5.0;

template <int D> double least_of_shape(const SquareMatrix<D> &inverse, double volume, double kappa)
{
  Eigen::SelfAdjointEigenSolver<SquareMatrix<D>> eigen;
  eigen.computeDirect(inverse, Eigen::EigenvaluesOnly);
  const double largest = eigen.eigenvalues()[D - 1];
  return largest > 0.0 ? 1.0 / (largest * volume * kappa) : 0.0;
}

template <int D> SquareMatrix<D> row_major(const double *a)
{
  return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(a);
}

template <int D> void store(const SquareMatrix<D> &A, double *a)
{
  Eigen::Map<Eigen::Matrix<double, D, D, Eigen::RowMajor>> to(a);
  to = A;
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

}    // namespace

/* ---------------------------------------------------------------------- */

TMSPHOpenings::TMSPHOpenings(LAMMPS *lmp, FixTMSPHBond &bonds, TMSPHGhostSender &ghosts) :
    Pointers(lmp), bonds(bonds), ghosts(ghosts), values(bonds.bond_values("opening", OPEN_BOND_SIZE)),
    shapes(bonds.particle_values("shape before opening", domain->dimension == 2 ? 3 : 6))
{
}

/* ---------------------------------------------------------------------- */

void TMSPHOpenings::list_open()
{
  open.clear();
  for (int i = 0; i < atom->nlocal; i++)
    if (values.count(i)) open.push_back(i);
}

/* ---------------------------------------------------------------------- */

void TMSPHOpenings::follow()
{
  if (!watch.laid_out_anew(bonds)) return;
  watch.see(bonds);
  list_open();
  int mine = !open.empty(), all;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  any = all;
}

/* ---------------------------------------------------------------------- */

void TMSPHOpenings::make_rows(int width)
{
  if (rows.columns() != width) rows.set_columns(width);
  rows.resize(atom->nlocal + atom->nghost);
}

/* ---------------------------------------------------------------------- */

int TMSPHOpenings::most_sent() const
{
  return domain->dimension == 2 ? OpenRow<2>::WIDTH : OpenRow<3>::WIDTH;
}

/* ----------------------------------------------------------------------
   the bonds of a particle as its fit sees them, see the sweeps
------------------------------------------------------------------------- */

template <int D>
void TMSPHOpenings::gather(const TMSPHBondState &s, int i, OpenFit<D> &fit) const
{
  using R = Rows<D>;
  const bool heated = s.on.thermal == ThermalStrain::BOND;
  const auto at = [&](int p) { return s.kinematic + (size_t) p * R::KINEMATIC; };
  const double *const mine = at(i);
  fit.bonds.clear();
  for (const auto &[k, j, state] : bonds.family(i, FixTMSPHBond::WHOLE)) {
    const double *const his = at(j);
    FitBond<D> b;
    for (int c = 0; c < D; c++) {
      b.X[c] = his[R::X + c] - mine[R::X + c];
      b.u[c] = his[R::U + c] - mine[R::U + c];
    }
    if (heated) {
      const double young = mine[R::YOUNG] + his[R::YOUNG];
      const double push = mine[R::THERMAL] + his[R::THERMAL];
      b.u = (young * b.u - push * b.X) / (young + push);
    }
    b.weight = s.slices.weight[s.slices.at(i / TMSPH::WIDTH, i % TMSPH::WIDTH, k)];
    b.open = 0.0;
    b.normal.setZero();
    b.place = k;
    const int m = values.count(i) ? values.number(i, k) : -1;
    if (m >= 0) {
      b.open = bond(i, m).opening.now;
      for (int c = 0; c < D; c++) b.normal[c] = bond(i, m).normal[c];
    }
    fit.bonds.push_back(b);
  }
  const double *const own =
      s.slices.own.data() + (size_t) (i / TMSPH::WIDTH) * CONSTANTS<D> * TMSPH::WIDTH + i % TMSPH::WIDTH;
  fit.shape_inverse = dense<D>(shape_inverse<D>(own));
  const auto constant = [&](int n) { return own[TMSPH::WIDTH * (SYMMETRIC<D> + n)]; };
  fit.volume = constant(0);
  fit.lambda = constant(1);
  fit.shear = constant(2);
  fit.chi = constant(3);
  fit.heating = mine[R::THERMAL] / mine[R::YOUNG];
  fit.thermal = s.on.thermal == ThermalStrain::CONSTITUTIVE ? fit.heating : 0.0;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::correct(const TMSPHBondState &s)
{
  using R = Rows<D>;
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  fits.resize(open.size());
  double sum = 0.0;
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    OpenFit<D> &fit = fits[n];
    gather(s, i, fit);
    std::visit([&fit](auto elastic) { fit.evaluate(elastic); }, s.on.law);
    sum += fit.energy;
    if (s.force_row) store<D>(fit.B, s.force_row + (size_t) i * R::FORCE);
    if (s.gradient) store<D>(fit.H, s.gradient + (size_t) i * D * D);
    if (!s.stress) continue;
    const Matrix<D, double> F = deformation(plain<D>(fit.H));
    SquareMatrix<D> sigma = dense<D>(cauchy(plain<D>(fit.P), F));
    if (s.on.thermal == ThermalStrain::BOND) sigma /= std::pow(1.0 + fit.heating, D);
    if (determinant(F) <= 0.0) sigma = UNBEARABLE * SquareMatrix<D>::Identity();
    double *const stress = s.stress + (size_t) i * STRESS_ROW<D>;
    for (int a = 0, k = D; a < D; a++) {
      stress[a] = sigma(a, a);
      for (int b = a + 1; b < D; b++) stress[k++] = sigma(a, b);
    }
  }
  book(sum);
}

/* ----------------------------------------------------------------------
   at fixed positions no update raises the energy of fits and openings together
------------------------------------------------------------------------- */

void TMSPHOpenings::book(double energy_of_fits)
{
  if (updated) done[GAINED] += std::max(0.0, energy_of_fits - fits_energy + rise);
  fits_energy = energy_of_fits;
  rise = 0.0;
  updated = false;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::finish(const TMSPHBondState &s)
{
  using O = OpenRow<D>;
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  fits.resize(open.size());
  energy.resize(open.size());
  make_rows(O::WIDTH);
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    OpenFit<D> &fit = fits[n];
    gather(s, i, fit);
    std::visit([&fit](auto elastic) { fit.evaluate(elastic); }, s.on.law);
    store<D>(fit.B_turning, s.force_row + (size_t) i * Rows<D>::FORCE);
    store<D>(fit.rotation, rows[i] + O::R);
    energy[n] = {i, fit.energy};
    for (int m = 0; m < values.count(i); m++)
      energy[n].energy += 0.5 * bond(i, m).area *
          std::visit([&](auto one) { return stored_energy(one, bond(i, m).opening); }, law);
  }
  ghosts.send(rows, O::R, D * D);
}

/* ----------------------------------------------------------------------
   -W (chi_i c R_i N + chi_j c R_j N)/(1 + theta)
------------------------------------------------------------------------- */

template <int D>
void TMSPHOpenings::add_forces(const TMSPHBondState &s, double *f, int stride, double *total,
                               double *each) const
{
  using O = OpenRow<D>;
  using R = Rows<D>;
  const bool heated = s.on.thermal == ThermalStrain::BOND;
  for (const int i : open)
    for (int m = 0; m < values.count(i); m++) {
      const OpenBond &b = bond(i, m);
      const int j = bonds.partner_index(i, values.place(i, m));
      const double c = b.opening.now;
      const auto jump = [&](int p) {
        const double *const turned = rows[p] + O::R;
        const double chi = s.force_row[(size_t) p * R::FORCE + R::CHI];
        Column<D> one;
        for (int a = 0; a < D; a++) {
          one[a] = 0.0;
          for (int k = 0; k < D; k++) one[a] += turned[D * a + k] * b.normal[k];
          one[a] *= chi * c;
        }
        return one;
      };
      double scale = bonds.weight(i, j);
      if (heated) {
        const double *const mine = s.kinematic + (size_t) i * R::KINEMATIC,
                     *const his = s.kinematic + (size_t) j * R::KINEMATIC;
        const double young = mine[R::YOUNG] + his[R::YOUNG];
        scale *= young / (young + (mine[R::THERMAL] + his[R::THERMAL]));
      }
      const Column<D> force = -scale * (jump(i) + jump(j));
      if (f)
        for (int a = 0; a < D; a++) f[(size_t) stride * i + a] += force[a];
      if (!total && !each) continue;
      double v[6] = {}, r[3], g[3] = {};
      for (int a = 0; a < 3; a++) r[a] = atom->x[j][a] - atom->x[i][a];
      for (int a = 0; a < D; a++) g[a] = force[a];
      for (int a = 0; a < 3; a++) v[a] = -0.5 * r[a] * g[a];
      v[3] = -0.5 * r[0] * g[1];
      v[4] = -0.5 * r[0] * g[2];
      v[5] = -0.5 * r[1] * g[2];
      for (int a = 0; a < 6; a++) {
        if (total) total[a] += v[a];
        if (each) each[6 * (size_t) i + a] += v[a];
      }
    }
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOpenings::exchange(const TMSPHBondState &s, const std::vector<char> &near)
{
  using O = OpenRow<D>;
  using R = Rows<D>;
  const auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  make_rows(O::WIDTH);
  near_column = O::NEAR;
  candidate_column = O::CANDIDATE;
  kinematic = s.kinematic;
  heated = s.on.thermal == ThermalStrain::BOND;
  for (int i = 0; i < atom->nlocal; i++) {
    const double *const own = s.slices.own.data() +
        (size_t) (i / TMSPH::WIDTH) * CONSTANTS<D> * TMSPH::WIDTH + i % TMSPH::WIDTH;
    const auto constant = [&](int n) { return own[TMSPH::WIDTH * (SYMMETRIC<D> + n)]; };
    double *const r = rows[i];
    std::copy_n(s.kinematic + (size_t) i * R::KINEMATIC + R::U, D, r + O::U);
    std::copy_n(s.gradient + (size_t) i * D * D, D * D, r + O::H);
    r[O::CHI] = constant(3);
    r[O::MODULUS] = constant(1) + 2.0 * constant(2);
    r[O::NEAR] = near[i];
    r[O::LEAST] = 0.0;    // no openings
  }
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    double *const r = rows[i];
    store<D>(fits[n].rotation, r + O::R);
    store<D>(fits[n].B, r + O::B);
    r[O::LEAST] = std::max(least_of_shape<D>(fits[n].shape_inverse, fits[n].volume,
                                             bonds.interior_kappa()), 1.0e-300);
    find_candidate<D>(i, fits[n], s.on.law);
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
  const double scale = 0.5 * (mine[O::CHI] + his[O::CHI]) * bonds.interior_kappa() /
      (R * std::sqrt(square));
  for (int a = 0, n = D; a < D; a++) {
    stress[a] += scale * r[a] * r[a];
    for (int b = a + 1; b < D; b++) stress[n++] += scale * r[a] * r[b];
  }
}

/* ---------------------------------------------------------------------- */

template <int D>
void TMSPHOpenings::begin(int i, int k, int j, const double *stress, double strength,
                          double crack_energy)
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
  double X[3], along = 0.0, square = 0.0;
  bonds.reference_vector(i, j, X);
  for (int a = 0; a < D; a++) {
    along += N[a] * X[a];
    square += X[a] * X[a];
  }
  if (!(std::fabs(along) > SMALLEST_COSINE * std::sqrt(square))) return;
  OpenBond b;
  b.opening.strength = strength;
  b.opening.end = std::visit(
      [&](auto one) { return crack_energy / (decltype(one)::area(1.0) * strength); }, law);
  for (int a = 0; a < D; a++) b.normal[a] = along > 0.0 ? N[a] : -N[a];
  std::copy_n(reinterpret_cast<double *>(&b), OPEN_BOND_SIZE, values.insert(i, k, atom->nmax));
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
        shapes[i][n] = s.slices.own[(size_t) (i / TMSPH::WIDTH) * CONSTANTS<D> * TMSPH::WIDTH +
                                    TMSPH::WIDTH * n + i % TMSPH::WIDTH];
  }
  list_open();
  for (const int i : open)
    for (int a = 0, n = 0; a < D; a++)
      for (int b = a; b < D; b++)
        rows[i][O::R + D * a + b] = rows[i][O::R + D * b + a] = atom->vfrac[i] * shapes[i][n++];
  ghosts.send(rows, O::R, D * D);
  for (const int i : open)
    for (int m = 0; m < values.count(i); m++) {
      OpenBond &one = bond(i, m);
      if (one.area > 0.0) continue;
      const int j = bonds.partner_index(i, values.place(i, m));
      const double W = bonds.weight(i, j);
      double X[3], across = 0.0, along = 0.0;
      bonds.reference_vector(i, j, X);
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

template <int D>
void TMSPHOpenings::update(TMSPHBondState s, const std::vector<char> &near)
{
  s.stress = nullptr;    // ghosts have that of before
  for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
    if (sweep) exchange<D>(s, near);
    const double mine = update_once<D>(sweep == 0);
    correct<D>(s);
    double largest;
    MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    if (largest <= CLOSE_TO_LAW) break;
  }
}

/* ----------------------------------------------------------------------
   @param decides which bonds leave the fit next
   @return        the largest change of a traction over the strength
------------------------------------------------------------------------- */

template <int D> double TMSPHOpenings::update_once(bool decides)
{
  using O = OpenRow<D>;
  double largest = 0.0;
  for (const int i : open)
    for (int m = 0; m < values.count(i); m++) {
      OpenBond &b = bond(i, m);
      const int j = bonds.partner_index(i, values.place(i, m));
      const double W = bonds.weight(i, j), c = b.opening.now;
      double X[D], u[D], minus[3][D];
      relative<D>(i, j, X, u);
      for (int a = 0; a < D; a++) {
        minus[0][a] = -X[a];
        minus[1][a] = -u[a];
        minus[2][a] = -b.normal[a];
      }
      const double *const mine = rows[i], *const his = rows[j];
      const double pull =
          end_traction<D>(mine + O::R, mine + O::B, mine[O::CHI], X, u, b.normal, W, c) +
          end_traction<D>(his + O::R, his + O::B, his[O::CHI], minus[0], minus[1], minus[2], W, c);
      const double stiffness = opening_stiffness(
          W, 0.5 * (mine[O::MODULUS] + his[O::MODULUS]), bonds.interior_kappa(),
          std::min(1.0, std::min(mine[O::LEAST], his[O::LEAST])),
          0.5 * (mine[O::CHI] + his[O::CHI]), b.area);
      std::visit(
          [&](auto one) {
            const auto total = [&] {
              return stored_energy(one, b.opening) + dissipated_energy(one, b.opening);
            };
            rise -= 0.5 * b.area * total();
            TMSPH::update(one, b.opening, pull / b.area, stiffness);
            rise += 0.5 * b.area * total();
          },
          law);
      largest = std::max(largest, stiffness * std::fabs(b.opening.now - c) / b.opening.strength);
      if (decides) decide_leaving(i, j, b);
    }
  updated = true;
  return largest;
}

/* ----------------------------------------------------------------------
   both ends see the same candidates and decide alike
------------------------------------------------------------------------- */

void TMSPHOpenings::decide_leaving(int i, int j, OpenBond &b)
{
  const double *const mine = rows[i] + candidate_column, *const his = rows[j] + candidate_column;
  b.patience = std::max(0.0, b.patience - 1.0);
  if (ubuf(mine[0]).i != (bigint) atom->tag[j] || ubuf(his[0]).i != (bigint) atom->tag[i]) return;
  if (mine[1] + his[1] <= 0.0) {
    b.leaves = 1.0;
    done[LOST] -= mine[1];
  } else
    b.patience = PATIENCE;
}

/* ---------------------------------------------------------------------- */

std::vector<TMSPHOpenings::Leaving> TMSPHOpenings::take_leaving()
{
  std::vector<Leaving> leaving;
  for (const int i : open)
    for (int m = values.count(i) - 1; m >= 0; m--)
      if (bond(i, m).leaves != 0.0) {
        const OpenBond &b = bond(i, m);
        leaving.push_back({i, values.place(i, m), b});
        done[DISSIPATED] += 0.5 * b.area *
            std::visit([&](auto one) { return dissipated_energy(one, b.opening); }, law);
        done[AREA] += 0.5 * b.area;
        values.erase(i, values.place(i, m));
      }
  if (!leaving.empty()) list_open();
  return leaving;
}

/* ---------------------------------------------------------------------- */

TMSPHOpenings::Balance TMSPHOpenings::balance() const
{
  Balance sum = done;
  for (const int i : open)
    for (int m = 0; m < values.count(i); m++) {
      const OpenBond &b = bond(i, m);
      std::visit(
          [&](auto one) {
            sum[DISSIPATED] += 0.5 * b.area * dissipated_energy(one, b.opening);
            sum[STORED] += 0.5 * b.area * stored_energy(one, b.opening);
          },
          law);
      sum[AREA] += 0.5 * b.area * std::min(1.0, b.opening.most / b.opening.end);
      sum[OPENING] += 0.5;
    }
  return sum;
}

/* ---------------------------------------------------------------------- */

#define INSTANTIATE(D)                                                                           \
  template void TMSPHOpenings::correct<D>(const TMSPHBondState &);                               \
  template void TMSPHOpenings::finish<D>(const TMSPHBondState &);                                      \
  template void TMSPHOpenings::add_forces<D>(const TMSPHBondState &, double *, int, double *,    \
                                             double *) const;                                    \
  template void TMSPHOpenings::exchange<D>(const TMSPHBondState &, const std::vector<char> &);   \
  template void TMSPHOpenings::add_residual<D>(int, int, double *) const;                   \
  template void TMSPHOpenings::begin<D>(int, int, int, const double *, double, double);          \
  template void TMSPHOpenings::complete<D>(const TMSPHBondState &);                              \
  template void TMSPHOpenings::update<D>(TMSPHBondState, const std::vector<char> &);

INSTANTIATE(2)
INSTANTIATE(3)
