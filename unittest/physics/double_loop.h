/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The method as it is written on paper: particle by particle, pair by pair,
   with F instead of H and without any rearrangement. What the sweeps and the
   reference forces of the force style tests are measured against.
------------------------------------------------------------------------- */

#ifndef TMSPH_TEST_DOUBLE_LOOP_H
#define TMSPH_TEST_DOUBLE_LOOP_H

#include "body.h"

namespace TMSPH_TEST {

template <int D> struct Answer {
  std::vector<Vector<D>> force;
  std::vector<Square<D>> F, cauchy;    ///< F without the thermal stretch of the bonds
  std::vector<Square<D>> virial;       ///< half of -sum x_ij f_ij, symmetric part
  std::vector<double> energy;
};

inline double size_of(double a)
{
  return std::fabs(a);
}
template <class M> double size_of(const Eigen::MatrixBase<M> &a)
{
  return a.norm();
}

template <class List> double largest_of(const List &list)
{
  double largest = 0.0;
  for (const auto &a : list) largest = std::max(largest, size_of(a));
  return largest;
}

template <int D>
Answer<D> double_loop(const Body<D> &body, const TMSPH::Features &on, double zeta,
                      const TMSPH::Viscosity &viscosity)
{
  const int n = body.size();
  const auto &p = body.p;
  const Square<D> one = Square<D>::Identity();
  const bool bond = on.thermal == TMSPH::ThermalStrain::BOND;
  const auto stretch = [&](int i, int j) {
    const double Ei = p[i].material.young, Ej = p[j].material.young;
    return bond ? 1.0 + (Ei * p[i].thermal + Ej * p[j].thermal) / (Ei + Ej) : 1.0;
  };
  const auto y = [&](int i, int j) -> Vector<D> {
    return (p[j].X + p[j].u - p[i].X - p[i].u) / stretch(i, j);
  };
  const auto chi = [&](int i) { return p[i].singular ? 0.0 : zeta * p[i].material.young; };

  Answer<D> out;
  std::vector<Square<D>> PK(n);    // P_i K_i^-1
  std::vector<Square<D>> inverse_of(n);
  for (int i = 0; i < n; i++) {
    const double V = p[i].volume;
    const Square<D> K = body.shape(i) / V;
    const Square<D> inverse = p[i].singular ? Square<D>(Square<D>::Zero()) : K.inverse();
    inverse_of[i] = inverse;
    Square<D> sum = Square<D>::Zero();
    for (int j = 0; j < n; j++) {
      const Vector<D> X = p[j].X - p[i].X;
      if (j != i) sum += body.W(i, j) / V * (y(i, j) - X) * X.transpose();
    }
    const Square<D> F = one + sum * inverse;
    const double J = F.determinant();
    const double a = on.thermal == TMSPH::ThermalStrain::CONSTITUTIVE ? p[i].thermal : 0.0;
    // averaged dilatation has its share below
    const double lambda = p[i].averaged ? 0.0 : p[i].material.lambda;
    const double mu = p[i].material.shear;
    const Square<D> green = 0.5 * (F.transpose() * F - one);
    Square<D> e, P;
    double scale = 1.0, density;
    const auto hooke = [&]() { return lambda * e.trace() * one + 2.0 * mu * e; };
    if (std::holds_alternative<TMSPH::NeoHookean>(on.law)) {
      const Square<D> elastic = F / (1.0 + a), T = elastic.transpose().inverse();
      const double volume = elastic.determinant();
      P = (mu * (elastic - T) + 0.5 * lambda * (volume * volume - 1.0) * T) / (1.0 + a);
      density = 0.5 * mu * ((elastic.transpose() * elastic).trace() - D) - mu * std::log(volume) +
          0.25 * lambda * (volume * volume - 1.0 - 2.0 * std::log(volume));
    } else {
      if (std::holds_alternative<TMSPH::StVenantKirchhoff>(on.law)) {
        e = green - a * one;
        P = F * hooke();
      } else {
        e = F.transpose().inverse() * green * F.inverse() - a * one;
        P = J * hooke() * F.transpose().inverse();
        scale = J;
      }
      density = scale * (0.5 * lambda * e.trace() * e.trace() + mu * (e.transpose() * e).trace());
    }
    double energy = V * density;
    for (int j = 0; j < n; j++)
      if (j != i)
        energy += 0.5 * chi(i) * body.W(i, j) * (y(i, j) - F * (p[j].X - p[i].X)).squaredNorm();
    out.energy.push_back(energy);
    PK[i] = P * inverse;
    out.F.push_back(F);
    // with thermal bonds F is elastic; the whole one is (1 + a) F, and P belongs to it divided by
    // 1 + a
    const double stretch = on.thermal == TMSPH::ThermalStrain::BOND ? 1.0 + p[i].thermal : 1.0;
    out.cauchy.push_back((P / stretch) * (stretch * F).transpose() / (stretch * F).determinant());
  }

  // pressures of materials that average their dilatation
  if (body.M.size()) {
    const auto mean = [&](const std::vector<double> &value) {
      std::vector<double> result(value);
      for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) result[i] += body.M(i, j) / p[i].volume * (value[j] - value[i]);
      return result;
    };
    std::vector<double> theta(n, 0.0);
    for (int i = 0; i < n; i++)
      if (p[i].averaged && !p[i].singular) {
        const double a = on.thermal == TMSPH::ThermalStrain::CONSTITUTIVE ? p[i].thermal : 0.0;
        theta[i] = 0.5 * (out.F[i].transpose() * out.F[i] - one).trace() - D * a;
      }
    std::vector<double> pressure = mean(theta);
    for (int i = 0; i < n; i++) {
      if (p[i].averaged)
        out.energy[i] += p[i].volume * 0.5 * p[i].material.lambda * pressure[i] * pressure[i];
      pressure[i] *= p[i].averaged ? p[i].material.lambda : 0.0;
    }
    pressure = mean(pressure);
    for (int i = 0; i < n; i++) PK[i] += pressure[i] * out.F[i] * inverse_of[i];
  }

  // bonds across the interfaces of such materials: what is left between the displacements of
  // both sides, each taken to the interface with its own gradient
  const auto gap = [&](int i, int j) -> Vector<D> {
    const double s = body.depth[i] / (body.depth[i] + body.depth[j]);
    const auto whole = [&](int k) -> Square<D> {
      return (bond ? 1.0 + p[k].thermal : 1.0) * out.F[k];
    };
    return (p[j].X + p[j].u - p[i].X - p[i].u) -
        (s * whole(i) + (1.0 - s) * whole(j)) * (p[j].X - p[i].X);
  };
  const auto pull = [&](int i, int j) -> Vector<D> {
    const double Ei = p[i].material.young, Ej = p[j].material.young;
    return 20.0 * Ei * Ej / (Ei + Ej) * body.across(i, j) * gap(i, j);
  };
  const auto joined = [&](int i, int j) { return body.across.size() && body.across(i, j) != 0.0f; };
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      if (!joined(i, j)) continue;
      out.energy[i] += 0.25 * pull(i, j).dot(gap(i, j));
      const double s = body.depth[i] / (body.depth[i] + body.depth[j]);
      const double stretch = bond ? 1.0 + p[i].thermal : 1.0;
      PK[i] -=
          s * stretch / p[i].volume * pull(i, j) * (p[j].X - p[i].X).transpose() * inverse_of[i];
    }

  const double h = viscosity.smoothing_length;
  for (int i = 0; i < n; i++) {
    Vector<D> f = Vector<D>::Zero();
    Square<D> virial = Square<D>::Zero();
    for (int j = 0; j < n; j++) {
      if (body.W(i, j) == 0.0f) continue;
      const Vector<D> X = p[j].X - p[i].X, x = p[j].X + p[j].u - p[i].X - p[i].u;
      Vector<D> t = ((PK[i] + PK[j]) * X + chi(i) * (y(i, j) - out.F[i] * X) +
                     chi(j) * (y(i, j) - out.F[j] * X)) /
          stretch(i, j);
      if (on.viscosity) {
        const auto speed = [&](int k) {
          return std::sqrt(p[k].material.wave_modulus / p[k].density);
        };
        const double r = x.norm(), mu = h * (p[j].v - p[i].v).dot(x) / (r * r + 0.01 * h * h);
        const double rho = 0.5 * (p[i].density + p[j].density);
        const double c = 0.5 * (speed(i) + speed(j));
        double pressure = viscosity.alpha1 * c * mu;
        if (mu < 0.0) pressure -= viscosity.alpha2 * mu * mu;
        t += rho * pressure * X.norm() / viscosity.kappa * x / r;
      }
      t *= body.W(i, j);
      f += t;
      virial -= 0.25 * (x * t.transpose() + t * x.transpose());
    }
    for (int j = 0; j < n; j++) {
      if (!joined(i, j)) continue;
      const Vector<D> x = p[j].X + p[j].u - p[i].X - p[i].u, t = pull(i, j);
      f += t;
      virial -= 0.25 * (x * t.transpose() + t * x.transpose());
    }
    out.force.push_back(f);
    out.virial.push_back(virial);
  }
  return out;
}

}    // namespace TMSPH_TEST
#endif
