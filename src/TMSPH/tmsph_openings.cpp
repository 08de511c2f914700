/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_openings.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "tmsph_open_row.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

TMSPHOpenings::TMSPHOpenings(LAMMPS *lmp, FixTMSPHBond &bonds, TMSPHGhostSender &ghosts) :
    Pointers(lmp), bonds(bonds), ghosts(ghosts), values(bonds.bond_values(NAME, OPEN_BOND_SIZE)),
    shapes(bonds.particle_values("shape before opening", domain->dimension == 2 ? 3 : 6))
{
}

/* ---------------------------------------------------------------------- */

void TMSPHOpenings::list_open()
{
  open.clear();
  for (int i = 0; i < atom->nlocal; i++)
    if (values.count(i)) open.push_back(i);
  gathered = false;
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

void TMSPHOpenings::settle()
{
  for (int i = 0; i < atom->nlocal; i++)
    for (int m = 0; m < values.count(i); m++) bond(i, m).settled = bond(i, m).opening.most;
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
static void gather_one(const FixTMSPHBond &bonds, const TMSPHBondValues &values,
                       const TMSPHBondState &s, int i, OpenFit<D> &fit)
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
    b.weight = s.slices.weight[s.slices.at(i, k)];
    b.place = k;
    b.partner = j;
    b.number = values.count(i) ? values.number(i, k) : -1;
    b.jump.setZero();
    fit.bonds.push_back(b);
  }
  const double *const own = s.slices.constants<D>(i);
  fit.shape_inverse = dense<D>(shape_inverse<D>(own));
  const auto constant = [&](int n) { return own[TMSPH::LANES * (SYMMETRIC<D> + n)]; };
  fit.volume = constant(0);
  fit.lambda = constant(1);
  fit.shear = constant(2);
  fit.chi = constant(3);
  fit.heating = mine[R::THERMAL] / mine[R::YOUNG];
  fit.thermal = s.on.thermal == ThermalStrain::CONSTITUTIVE ? fit.heating : 0.0;
}

/* ---------------------------------------------------------------------- */

static double opened_part(const OpenBond &b)
{
  return std::min(1.0, b.opening.most / b.opening.end);
}

/* ----------------------------------------------------------------------
   the Cauchy stress of a fit, as the gradient sweep finds it
------------------------------------------------------------------------- */

template <int D>
static void store_stress(const Features &on, const OpenFit<D> &fit, const SquareMatrix<D> &H,
                         const SquareMatrix<D> &P, double *stress)
{
  const Matrix<D, double> F = deformation(plain<D>(H));
  SquareMatrix<D> sigma = dense<D>(cauchy(plain<D>(P), F));
  if (on.thermal == ThermalStrain::BOND) sigma /= std::pow(1.0 + fit.heating, D);
  if (determinant(F) <= 0.0) sigma = UNBEARABLE * SquareMatrix<D>::Identity();
  for (int a = 0, k = D; a < D; a++) {
    stress[a] = sigma(a, a);
    for (int b = a + 1; b < D; b++) stress[k++] = sigma(a, b);
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::gather(const TMSPHBondState &s)
{
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  fits.resize(open.size());
  for (size_t n = 0; n < open.size(); n++) {
    gather_one<D>(bonds, values, s, open[n], fits[n]);
    fits[n].see();
  }
  take_jumps<D>();
  gathered = true;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::take_jumps()
{
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  for (size_t n = 0; n < open.size(); n++) {
    for (FitBond<D> &seen : fits[n].bonds) {
      if (!seen.open()) continue;
      const OpenBond &b = bond(open[n], seen.number);
      for (int a = 0; a < D; a++) seen.jump[a] = b.jump[a] + b.uneven[a];
    }
    fits[n].take_jumps();
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::correct(const TMSPHBondState &s)
{
  gather<D>(s);
  evaluate<D>(s);
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::evaluate(const TMSPHBondState &s)
{
  using R = Rows<D>;
  double sum = 0.0;
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    OpenFit<D> &fit = fits[n];
    std::visit([&fit](auto elastic) { fit.react(elastic); }, s.on.law);
    sum += fit.energy;
    if (s.force_row) store<D>(fit.B, s.force_row + (size_t) i * R::FORCE);
    if (s.gradient) store<D>(fit.H, s.gradient + (size_t) i * D * D);
    if (s.stress) store_stress<D>(s.on, fit, fit.H, fit.P, s.stress + (size_t) i * STRESS_ROW<D>);
  }
  account.book(sum);
}

/* ----------------------------------------------------------------------
   What a particle at an interface of materials sees with the bonds of its own side alone, less
   their openings, which turn with the fit over all.
------------------------------------------------------------------------- */

template <int D>
static SquareMatrix<D> own_gradient(const TMSPHOwnSide &own_side, int i, const OpenFit<D> &fit)
{
  SquareMatrix<D> H = SquareMatrix<D>::Zero();
  for (const auto &b : fit.bonds) {
    Column<D> left = b.u;
    if (b.open()) left -= fit.rotation() * b.jump;
    H += left * own_side.fit_vector<D>(i, b.place).transpose();
  }
  return H;
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::correct_own_side(const TMSPHBondState &s)
{
  const auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    if (!s.own_side->has(i)) continue;
    const OpenFit<D> &fit = fits[n];
    const SquareMatrix<D> H = own_gradient<D>(*s.own_side, i, fit);
    const SquareMatrix<D> P =
        std::visit([&](auto elastic) { return fit.piola(elastic, H); }, s.on.law);
    store_stress<D>(s.on, fit, H, P, s.stress + (size_t) i * STRESS_ROW<D>);
    store<D>(H, s.own_side->gradients() + (size_t) i * D * D);
  }
}

/* ----------------------------------------------------------------------
   of particles with openings, as their fits have it now
------------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::fill_open_rows(const TMSPHBondState &s)
{
  using O = OpenRow<D>;
  const auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    double *const r = rows[i];
    store<D>(s.own_side && s.own_side->has(i) ? own_gradient<D>(*s.own_side, i, fits[n])
                                              : fits[n].H,
             r + O::H);
    store<D>(fits[n].rotation(), r + O::R);
    store<D>(fits[n].back(), r + O::T);
  }
}

/* ---------------------------------------------------------------------- */

template <int D> void TMSPHOpenings::finish(const TMSPHBondState &s)
{
  using O = OpenRow<D>;
  auto &fits = std::get<std::vector<OpenFit<D>>>(fits_of);
  if (!gathered) gather<D>(s);    // bonds began to open
  energy.resize(open.size());
  make_rows(O::WIDTH);
  for (size_t n = 0; n < open.size(); n++) {
    const int i = open[n];
    OpenFit<D> &fit = fits[n];
    std::visit([&fit](auto elastic) { fit.react(elastic); }, s.on.law);
    store<D>(fit.B_turning, s.force_row + (size_t) i * Rows<D>::FORCE);
    store<D>(fit.rotation(), rows[i] + O::R);
    store<D>(fit.seen, s.gradient + (size_t) i * D * D);    // faces are carried along by it
    energy[n] = {i, fit.energy};
    double opened = 0.0;
    for (int m = 0; m < values.count(i); m++) {
      const OpenBond &b = bond(i, m);
      energy[n].energy +=
          0.5 * b.area * std::visit([&](auto one) { return stored_energy(one, b.opening); }, law);
      opened += opened_part(b);
    }
    bonds.update_damage(i, opened);
  }
  ghosts.send(rows, O::R, D * D);
}

/* ----------------------------------------------------------------------
   -W (chi_i R_i (c + e) + chi_j R_j (c - e))/(1 + theta)
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
      const auto jump = [&](int p, double sign) {
        const double *const turned = rows[p] + O::R;
        const double chi = s.force_row[(size_t) p * R::FORCE + R::CHI];
        Column<D> one;
        for (int a = 0; a < D; a++) {
          one[a] = 0.0;
          for (int k = 0; k < D; k++)
            one[a] += turned[D * a + k] * (b.jump[k] + sign * b.uneven[k]);
          one[a] *= chi;
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
      const Column<D> force = -scale * (jump(i, 1.0) + jump(j, -1.0));
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

TMSPHOpeningBalance::Figures TMSPHOpenings::figures() const
{
  using B = TMSPHOpeningBalance;
  B::Figures sum = account.finished();
  for (const int i : open)
    for (int m = 0; m < values.count(i); m++) {
      const OpenBond &b = bond(i, m);
      std::visit(
          [&](auto one) {
            sum[B::DISSIPATED] += 0.5 * b.area * dissipated_energy(one, b.opening);
            sum[B::STORED] += 0.5 * b.area * stored_energy(one, b.opening);
          },
          law);
      sum[B::AREA] += 0.5 * b.area * opened_part(b);
      sum[B::OPENING] += 0.5;
    }
  return sum;
}

/* ---------------------------------------------------------------------- */

double TMSPHOpenings::bytes() const
{
  const auto size = [](const auto &one) { return one.capacity() * sizeof(one[0]); };
  return rows.bytes() + size(open) + size(energy) +
      size(std::get<std::vector<OpenFit<2>>>(fits_of)) +
      size(std::get<std::vector<OpenFit<3>>>(fits_of));
}

/* ---------------------------------------------------------------------- */

#define INSTANTIATE(D)                                                                        \
  template void TMSPHOpenings::correct<D>(const TMSPHBondState &);                            \
  template void TMSPHOpenings::evaluate<D>(const TMSPHBondState &);                           \
  template void TMSPHOpenings::take_jumps<D>();                                               \
  template void TMSPHOpenings::correct_own_side<D>(const TMSPHBondState &);                   \
  template void TMSPHOpenings::fill_open_rows<D>(const TMSPHBondState &);                     \
  template void TMSPHOpenings::finish<D>(const TMSPHBondState &);                             \
  template void TMSPHOpenings::add_forces<D>(const TMSPHBondState &, double *, int, double *, \
                                             double *) const;

INSTANTIATE(2)
INSTANTIATE(3)
