/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Gradient, force and energy sweeps; see tmsph_sweep.h for the equations.
------------------------------------------------------------------------- */

#include "tmsph_sweep.h"

#include <utility>

namespace TMSPH {
namespace {

// part of h^2 that keeps the viscosity of particles that come close finite: Monaghan, Annu. Rev.
// Astron. Astrophys. 30 (1992) 543

constexpr double SOFTENING = 0.01;

/// What the eight bonds of one row look like: X_ij, u'_ij and the factor 1/(1 + theta_ij).
/// In 2-D half of the kinematic row (X and u) will do unless WHOLE is asked for.
template <int D, bool THERMAL, bool WHOLE = THERMAL> struct BondRow {
  Lanes X[D], u[D], stretch;

  TMSPH_INLINE BondRow(const Lanes *own, const double *kinematic, const int *partner, Lanes *other)
  {
    using R = Rows<D>;
    constexpr int N = (D == 2 && !WHOLE) ? 4 : 8;
    load_rows<N>(kinematic, R::KINEMATIC, partner, other);
    for (int k = 0; k < D; k++) {
      X[k] = other[R::X + k] - own[R::X + k];
      u[k] = other[R::U + k] - own[R::U + k];
    }
    if constexpr (THERMAL) {
      // theta = (E_i a_i + E_j a_j)/(E_i + E_j); u' = (u - theta X)/(1 + theta)
      const Lanes young = own[R::YOUNG] + other[R::YOUNG];
      const Lanes thermal = own[R::THERMAL] + other[R::THERMAL];
      const Lanes inverse = 1.0 / (young + thermal);
      stretch = young * inverse;
      const Lanes theta = thermal * inverse;
      for (int k = 0; k < D; k++) u[k] = stretch * u[k] - theta * X[k];
    }
  }
};

/// The particles of a slice and their kinematic rows.
template <int D> struct Own {
  Lanes row[8];
  const double *constants;
  TMSPH_INLINE Own(const Slices &bonds, int q, const double *kinematic)
  {
    load_rows<8>(kinematic, Rows<D>::KINEMATIC, bonds.particle.data() + q * LANES, row);
    constants = bonds.own.data() + (size_t) q * CONSTANTS<D> * LANES;
  }
  TMSPH_INLINE Lanes constant(int k) const { return load(constants + (size_t) k * LANES); }
  TMSPH_INLINE Lanes volume() const { return constant(SYMMETRIC<D>); }
  TMSPH_INLINE Lanes lambda() const { return constant(SYMMETRIC<D> + 1); }
  TMSPH_INLINE Lanes shear() const { return constant(SYMMETRIC<D> + 2); }
  TMSPH_INLINE Lanes chi() const { return constant(SYMMETRIC<D> + 3); }
  TMSPH_INLINE Lanes thermal_strain() const { return row[Rows<D>::THERMAL] / row[Rows<D>::YOUNG]; }
  TMSPH_INLINE Matrix<D, Lanes> shape_inverse() const
  {
    Matrix<D, Lanes> K;
    int k = 0;
    for (int i = 0; i < D; i++)
      for (int j = i; j < D; j++) K[i][j] = K[j][i] = constant(k++);
    return K;
  }
};

/// H_i = (sum W u' X^T) Kbar^-1
template <int D, bool THERMAL>
TMSPH_INLINE Matrix<D, Lanes> displacement_gradient(const Slices &bonds, int q, const Own<D> &own,
                                                    const double *kinematic)
{
  Matrix<D, Lanes> A;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) A[i][j] = broadcast(0.0);
  Lanes other[8];
  for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
    const size_t at = (size_t) b * LANES;
    const BondRow<D, THERMAL> bond(own.row, kinematic, bonds.partner.data() + at, other);
    const Lanes weight = load(bonds.weight.data() + at);
    Lanes g[D];
    for (int k = 0; k < D; k++) g[k] = weight * bond.X[k];
    for (int i = 0; i < D; i++)
      for (int j = 0; j < D; j++) A[i][j] += bond.u[i] * g[j];
  }
  return product(A, own.shape_inverse());
}

/// H_i = sum u' g^T
template <int D, bool THERMAL>
Matrix<D, Lanes> fitted_gradient(const Slices &bonds, int q, const Own<D> &own,
                                 const double *kinematic)
{
  Matrix<D, Lanes> H;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) H[i][j] = broadcast(0.0);
  Lanes other[8];
  for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
    const size_t at = (size_t) b * LANES;
    const BondRow<D, THERMAL> bond(own.row, kinematic, bonds.partner.data() + at, other);
    for (int j = 0; j < D; j++) {
      const Lanes g = load(bonds.fit.data() + D * at + j * LANES);
      for (int i = 0; i < D; i++) H[i][j] += bond.u[i] * g;
    }
  }
  return H;
}

template <int D>
TMSPH_INLINE void store_stress(const Matrix<D, Lanes> &sigma, const int *particle, int n,
                               double *stress)
{
  constexpr int N = STRESS_ROW<D>;
  Lanes s[N];
  for (int i = 0, k = D; i < D; i++) {
    s[i] = sigma[i][i];
    for (int j = i + 1; j < D; j++) s[k++] = sigma[i][j];
  }
  for (int l = 0; l < n; l++)
    for (int k = 0; k < N; k++) stress[(size_t) particle[l] * N + k] = s[k][l];
}

template <int D, class Law, ThermalStrain THERMAL>
void gradient(const Slices &bonds, int first, int last, const double *kinematic,
              const GradientOutput &out)
{
  using R = Rows<D>;
  for (int q = first; q < last; q++) {
    const Own<D> own(bonds, q, kinematic);
    const int *particle = bonds.particle.data() + q * LANES;
    const int n = bonds.valid[q];
    constexpr bool HEATED = THERMAL == ThermalStrain::BOND;
    const Matrix<D, Lanes> H = bonds.fit.empty()
        ? displacement_gradient<D, HEATED>(bonds, q, own, kinematic)
        : fitted_gradient<D, HEATED>(bonds, q, own, kinematic);
    const Lanes thermal = THERMAL == ThermalStrain::CONSTITUTIVE ? own.thermal_strain()
                                                                 : broadcast(0.0);
    const Matrix<D, Lanes> P = Law::first_piola(H, own.lambda(), own.shear(), thermal);
    if (out.inverted) {
      const Lanes J = determinant(deformation(H));
      const auto fine = out.inverted_breaks ? J == J : J > 0.0;    // both are false for NaN
      for (int l = 0; l < n; l++)
        if (!fine[l]) *out.inverted = particle[l];
    }
    if (out.stress) {
      Matrix<D, Lanes> sigma = cauchy(P, deformation(H));
      if constexpr (THERMAL == ThermalStrain::BOND) {
        // H is the elastic part of F = (1 + a)(I + H), and so are P and J
        Lanes heated = 1.0 / (1.0 + own.thermal_strain()), scale = heated;
        for (int i = 1; i < D; i++) scale *= heated;
        for (int i = 0; i < D; i++)
          for (int j = 0; j < D; j++) sigma[i][j] *= scale;
      }
      if (out.inverted_breaks) {
        const auto turned = determinant(deformation(H)) <= 0.0;
        for (int i = 0; i < D; i++)
          for (int j = 0; j < D; j++)
            sigma[i][j] = turned ? broadcast(i == j ? UNBEARABLE : 0.0) : sigma[i][j];
      }
      store_stress(sigma, particle, n, out.stress);
    }
    if (out.gradient)
      for (int l = 0; l < n; l++)
        for (int k = 0; k < D * D; k++)
          out.gradient[(size_t) particle[l] * D * D + k] = H[k / D][k % D][l];
    if (out.force_row) {
      const Matrix<D, Lanes> PK = product(P, own.shape_inverse());
      const Lanes volume = own.volume(), chi = own.chi();
      double row[D * D + 1][LANES];
      for (int i = 0; i < D; i++)
        for (int j = 0; j < D; j++) store(row[i * D + j], volume * PK[i][j] - chi * H[i][j]);
      store(row[D * D], chi);
      for (int l = 0; l < n; l++)
        for (int k = 0; k <= D * D; k++)
          out.force_row[(size_t) particle[l] * R::FORCE + k] = row[k][l];
    }
  }
}

/// Viscosity of the bonds of one row: their forces are factor times x, their power factor times
/// rate. Speeds and densities are sums of both ends.
template <int D> struct ViscousRow {
  Lanes factor, rate;

  TMSPH_INLINE ViscousRow(double h, double alpha1, double alpha2, const Lanes *X, const Lanes *x,
                          const Lanes *own, const Lanes *other, const Lanes *mine, const Lanes *his)
  {
    using R = Rows<D>;
    Lanes r2 = x[0] * x[0], X2 = X[0] * X[0];
    rate = (his[R::V] - mine[R::V]) * x[0];
    for (int k = 1; k < D; k++) {
      r2 += x[k] * x[k];
      X2 += X[k] * X[k];
      rate += (his[R::V + k] - mine[R::V + k]) * x[k];
    }
    // in 2-D wave speed and density end the kinematic row, in 3-D the force row
    const Lanes *const i_end = D == 2 ? own : mine;
    const Lanes *const j_end = D == 2 ? other : his;
    const Lanes speed = i_end[R::SPEED] + j_end[R::SPEED];
    const Lanes density = i_end[R::DENSITY] + j_end[R::DENSITY];
    r2 += 1.0e-300;    // pads have x = 0; lost in any other square
    const Lanes soft = r2 + SOFTENING * h * h;
    const Lanes mu = h * rate / soft;
    factor = mu * density * square_root(X2 / r2) *
        (alpha1 * speed - alpha2 * minimum(mu, broadcast(0.0)));
  }
};

/// What a sweep with the forces of the bonds sums up.
enum class Sum { FORCE, VIRIAL, HEAT };

template <int D, bool THERMAL, bool HOURGLASS, bool VISCOUS, Sum SUM>
void force(const Slices &bonds, const Viscosity &viscosity, const double *kinematic,
           const double *force_row, double *out, int stride, double *sum)
{
  using R = Rows<D>;
  constexpr bool VIRIAL = SUM == Sum::VIRIAL;
  // without hourglass and viscosity 2-D needs B only: half the row
  constexpr int N = R::FORCE == 8 && !HOURGLASS && !VISCOUS ? 4
      : D == 3 && !VISCOUS                                  ? 12
                                                            : R::FORCE;
  const double h = viscosity.smoothing_length;
  // halves of the sums of wave speeds and of densities of both ends
  const double alpha1 = 0.25 * viscosity.alpha1 / viscosity.kappa;
  const double alpha2 = 0.5 * viscosity.alpha2 / viscosity.kappa;
  for (int q = 0; q < bonds.count(); q++) {
    const Own<D> own(bonds, q, kinematic);
    const int *particle = bonds.particle.data() + q * LANES;
    Lanes mine[R::FORCE], his[R::FORCE], other[8], total[D], work[6], heat = broadcast(0.0);
    load_rows<N>(force_row, R::FORCE, particle, mine);
    for (auto &t : total) t = broadcast(0.0);
    if constexpr (VIRIAL)
      for (auto &t : work) t = broadcast(0.0);
    for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
      const size_t at = (size_t) b * LANES;
      const int *partner = bonds.partner.data() + at;
      const BondRow<D, THERMAL, THERMAL || VISCOUS> bond(own.row, kinematic, partner, other);
      load_rows<N>(force_row, R::FORCE, partner, his);
      const Lanes weight = load(bonds.weight.data() + at);
      Lanes t[D];
      for (int i = 0; i < D; i++) {
        t[i] = (mine[R::B + i * D] + his[R::B + i * D]) * bond.X[0];
        for (int k = 1; k < D; k++)
          t[i] += (mine[R::B + i * D + k] + his[R::B + i * D + k]) * bond.X[k];
      }
      if constexpr (HOURGLASS) {
        const Lanes chi = mine[R::CHI] + his[R::CHI];
        for (int i = 0; i < D; i++) t[i] += chi * bond.u[i];
      }
      if constexpr (THERMAL)
        for (int i = 0; i < D; i++) t[i] *= bond.stretch;
      Lanes x[D];
      if constexpr (VISCOUS || VIRIAL)
        for (int k = 0; k < D; k++) x[k] = bond.X[k] + (other[R::U + k] - own.row[R::U + k]);
      if constexpr (VISCOUS) {
        const ViscousRow<D> viscous(h, alpha1, alpha2, bond.X, x, own.row, other, mine, his);
        for (int k = 0; k < D; k++) t[k] += viscous.factor * x[k];
        if constexpr (SUM == Sum::HEAT) heat += weight * viscous.factor * viscous.rate;
      }
      for (int i = 0; i < D; i++) {
        t[i] *= weight;
        total[i] += t[i];
      }
      if constexpr (VIRIAL) {
        for (int i = 0, k = D; i < D; i++) {
          work[i] -= x[i] * t[i];
          for (int j = i + 1; j < D; j++) work[k++] -= 0.5 * (x[i] * t[j] + x[j] * t[i]);
        }
      }
    }
    for (int l = 0; l < bonds.valid[q]; l++) {
      const size_t i = particle[l];
      if constexpr (VIRIAL) {
        for (double *v : {out ? out + stride * i : nullptr, sum}) {
          if (!v) continue;
          for (int k = 0; k < D; k++) v[k] += 0.5 * work[k][l];
          for (int k = 0; k < D * (D - 1) / 2; k++) v[3 + k] += 0.5 * work[D + k][l];
        }
      } else if constexpr (SUM == Sum::HEAT)
        out[stride * i] = 0.5 * heat[l];
      else
        for (int k = 0; k < D; k++) out[stride * i + k] += total[k][l];
    }
  }
}

template <int D, class Law, ThermalStrain MODE>
double energies(const Slices &bonds, const double *kinematic, double *energy)
{
  double sum = 0.0;
  constexpr bool THERMAL = MODE == ThermalStrain::BOND;
  for (int q = 0; q < bonds.count(); q++) {
    const Own<D> own(bonds, q, kinematic);
    const Matrix<D, Lanes> H = displacement_gradient<D, THERMAL>(bonds, q, own, kinematic);
    const Lanes thermal = MODE == ThermalStrain::CONSTITUTIVE ? own.thermal_strain()
                                                              : broadcast(0.0);
    Lanes penalty = broadcast(0.0), other[8];
    for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
      const size_t at = (size_t) b * LANES;
      const BondRow<D, THERMAL> bond(own.row, kinematic, bonds.partner.data() + at, other);
      Lanes sum = broadcast(0.0);
      for (int i = 0; i < D; i++) {
        Lanes r = bond.u[i];
        for (int k = 0; k < D; k++) r -= H[i][k] * bond.X[k];
        sum += r * r;
      }
      penalty += load(bonds.weight.data() + at) * sum;
    }
    const Lanes total = own.volume() * Law::energy(H, own.lambda(), own.shear(), thermal) +
        0.5 * own.chi() * penalty;
    for (int l = 0; l < bonds.valid[q]; l++) {
      sum += total[l];
      if (energy) energy[bonds.particle[q * LANES + l]] = total[l];
    }
  }
  return sum;
}

/// Calls fn with the scene's law and thermal mode as compile-time constants.
template <class FN> void with_law(const Features &on, FN fn)
{
  std::visit(
      [&](auto law) {
        switch (on.thermal) {
          case ThermalStrain::NONE:
            fn(law, std::integral_constant<ThermalStrain, ThermalStrain::NONE>());
            break;
          case ThermalStrain::BOND:
            fn(law, std::integral_constant<ThermalStrain, ThermalStrain::BOND>());
            break;
          case ThermalStrain::CONSTITUTIVE:
            fn(law, std::integral_constant<ThermalStrain, ThermalStrain::CONSTITUTIVE>());
        }
      },
      on.law);
}

template <class FN> void with_bool(bool value, FN fn)
{
  if (value)
    fn(std::true_type());
  else
    fn(std::false_type());
}

/// The same for what a force depends on.
template <class FN> void with_features(const Features &on, FN fn)
{
  with_bool(on.thermal == ThermalStrain::BOND, [&](auto thermal) {
    with_bool(on.hourglass, [&](auto hourglass) {
      with_bool(on.viscosity, [&](auto viscous) { fn(thermal, hourglass, viscous); });
    });
  });
}

}    // namespace

template <int D>
void gradient_sweep(const Features &on, const Slices &bonds, int first_slice, int last_slice,
                    const double *kinematic, const GradientOutput &out)
{
  with_law(on, [&](auto law, auto thermal) {
    gradient<D, decltype(law), thermal()>(bonds, first_slice, last_slice, kinematic, out);
  });
}

template <int D>
void force_sweep(const Features &on, const Slices &bonds, const Viscosity &viscosity,
                 const double *kinematic, const double *force_row, double *f, int stride)
{
  with_features(on, [&](auto thermal, auto hourglass, auto viscous) {
    force<D, thermal(), hourglass(), viscous(), Sum::FORCE>(bonds, viscosity, kinematic, force_row,
                                                            f, stride, nullptr);
  });
}

template <int D>
void virial_sweep(const Features &on, const Slices &bonds, const Viscosity &viscosity,
                  const double *kinematic, const double *force_row, double *virial, double *total)
{
  with_features(on, [&](auto thermal, auto hourglass, auto viscous) {
    force<D, thermal(), hourglass(), viscous(), Sum::VIRIAL>(bonds, viscosity, kinematic, force_row,
                                                             virial, 6, total);
  });
}

template <int D>
void viscous_heat_sweep(const Features &on, const Slices &bonds, const Viscosity &viscosity,
                        const double *kinematic, const double *force_row, double *power)
{
  with_bool(on.thermal == ThermalStrain::BOND, [&](auto thermal) {
    force<D, thermal(), false, true, Sum::HEAT>(bonds, viscosity, kinematic, force_row, power, 1,
                                                nullptr);
  });
}

template <int D>
double energy_sweep(const Features &on, const Slices &bonds, const double *kinematic,
                    double *energy)
{
  double sum = 0.0;
  with_law(on, [&](auto law, auto thermal) {
    sum = energies<D, decltype(law), thermal()>(bonds, kinematic, energy);
  });
  return sum;
}

template void gradient_sweep<2>(const Features &, const Slices &, int, int, const double *,
                                const GradientOutput &);
template void gradient_sweep<3>(const Features &, const Slices &, int, int, const double *,
                                const GradientOutput &);
template void force_sweep<2>(const Features &, const Slices &, const Viscosity &, const double *,
                             const double *, double *, int);
template void force_sweep<3>(const Features &, const Slices &, const Viscosity &, const double *,
                             const double *, double *, int);
template void virial_sweep<2>(const Features &, const Slices &, const Viscosity &, const double *,
                              const double *, double *, double *);
template void virial_sweep<3>(const Features &, const Slices &, const Viscosity &, const double *,
                              const double *, double *, double *);
template void viscous_heat_sweep<2>(const Features &, const Slices &, const Viscosity &,
                                    const double *, const double *, double *);
template void viscous_heat_sweep<3>(const Features &, const Slices &, const Viscosity &,
                                    const double *, const double *, double *);
template double energy_sweep<2>(const Features &, const Slices &, const double *, double *);
template double energy_sweep<3>(const Features &, const Slices &, const double *, double *);

}    // namespace TMSPH
