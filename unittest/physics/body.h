/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Small bodies for the tests: particles and bond weights as plain Eigen types,
   and the same body laid out as the sweeps want it.
------------------------------------------------------------------------- */

#ifndef TMSPH_TEST_BODY_H
#define TMSPH_TEST_BODY_H

#include "tmsph_interface.h"
#include "tmsph_kernel.h"
#include "tmsph_sweep.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace TMSPH_TEST {

template <int D> using Vector = Eigen::Matrix<double, D, 1>;
template <int D> using Square = Eigen::Matrix<double, D, D>;

/// for TYPED_TEST_SUITE: each test in the plane and in space
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
struct DimensionName {
  template <class T> static std::string GetName(int) { return std::to_string(T::value) + "d"; }
};

template <int D> struct Particle {
  Vector<D> X = Vector<D>::Zero(), u = X, v = X;
  double volume = 0.0, density = 0.0;
  double thermal = 0.0;    ///< thermal strain a = alpha* (T - T0)
  TMSPH::Elastic material;
  bool singular = false;    ///< too few bonds: neither pulls nor resists
  int type = 0;
  bool averaged = false;    ///< its material averages the dilatation
};

/** W(i, j) = V_i V_j w_ij rounded to float as the package does; 0 is no bond. */
template <int D> struct Body {
  std::vector<Particle<D>> p;
  Eigen::MatrixXf W;
  double spacing = 0.0, horizon = 0.0;

  // of materials that average, see average()
  Eigen::MatrixXf M;            ///< M_ij of the averaging
  Eigen::MatrixXf across;       ///< W_ij of bonds across coupled interfaces, which are not in W
  std::vector<double> depth;    ///< under the interface

  int size() const { return (int) p.size(); }

  /// Kbar_i = sum_j W_ij X_ij X_ij^T
  Square<D> shape(int i) const
  {
    Square<D> K = Square<D>::Zero();
    for (int j = 0; j < size(); j++) {
      const Vector<D> X = p[j].X - p[i].X;
      K += (double) W(i, j) * X * X.transpose();
    }
    return K;
  }

  /// tr K/D where a particle has all its neighbors: the viscosity's measure of the kernel
  double kappa() const
  {
    double largest = 0.0;
    for (int i = 0; i < size(); i++)
      largest = std::max(largest, shape(i).trace() / (D * p[i].volume));
    return largest;
  }

  void form_bonds(TMSPH::Kernel kernel)
  {
    W = Eigen::MatrixXf::Zero(size(), size());
    for (int i = 0; i < size(); i++)
      for (int j = 0; j < i; j++)
        W(i, j) = W(j, i) =
            (float) (p[i].volume * p[j].volume *
                     TMSPH::kernel_slope(kernel, D, (p[j].X - p[i].X).norm(), horizon));
  }

  /// sets up what averaging needs from the bonds that there are, and takes those across out of W
  void average(TMSPH::Kernel kernel, double interior)
  {
    const TMSPH::InterfaceDepth interface_depth(kernel, D, horizon);
    M = across = Eigen::MatrixXf::Zero(size(), size());
    depth.assign(size(), 0.0);
    for (int i = 0; i < size(); i++) {
      double own = 0.0, all = 0.0;
      for (int j = 0; j < size(); j++) {
        if (j != i && W(i, j) == 0.0f) continue;
        const double value = TMSPH::kernel_value(kernel, D, (p[j].X - p[i].X).norm(), horizon);
        const bool same = p[j].type == p[i].type;
        const bool coupled = !same && (p[i].averaged || p[j].averaged);
        if (same) own += p[j].volume * value;
        if (same || coupled) all += p[j].volume * value;
        if (same && j != i && p[i].averaged)
          M(i, j) = (float) (p[i].volume * p[j].volume / interior * value);
        if (coupled) across(i, j) = W(i, j);
      }
      depth[i] = std::max(interface_depth(own / all), 0.05 * std::pow(p[i].volume, 1.0 / D));
    }
    W -= across;
  }
};

/** A jittered block of two rocks with a random part of the bonds broken. Strains and thermal
    strains are of the order of a per cent, velocities of a per cent of the wave speed: large
    against round-off, and large enough for every nonlinear term to show. */
template <int D>
Body<D> random_body(unsigned seed, TMSPH::Kernel kernel = TMSPH::WendlandC2(), double broken = 0.1)
{
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto random_vector = [&](double scale) -> Vector<D> {
    Vector<D> r;
    for (int k = 0; k < D; k++) r[k] = scale * uniform(engine);
    return r;
  };
  Body<D> body;
  body.spacing = 1.0e-3;
  body.horizon = (D == 2 ? 3.015 : 2.2) * body.spacing;
  const int n[3] = {6, D == 2 ? 5 : 3, D == 2 ? 1 : 3};    // 30 and 54: pads in the last slice
  const TMSPH::Elastic rock[2] = {
      TMSPH::elastic_constants(D, TMSPH::Plane::STRAIN, 40.0e9, 0.3, 1.5e-5),
      TMSPH::elastic_constants(D, TMSPH::Plane::STRAIN, 20.0e9, 0.2, 1.0e-5)};
  Square<D> H;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) H(a, b) = 0.01 * uniform(engine);
  for (int i = 0; i < n[0] * n[1] * n[2]; i++) {
    const int at[3] = {i % n[0], i / n[0] % n[1], i / n[0] / n[1]};
    Particle<D> p;
    for (int k = 0; k < D; k++) p.X[k] = body.spacing * at[k];
    p.X += random_vector(0.2 * body.spacing);
    p.u = H * p.X + random_vector(0.01 * body.spacing);
    p.volume = std::pow(body.spacing, D) * (1.0 + 0.1 * uniform(engine));
    p.material = rock[at[0] >= n[0] / 2];
    p.density = at[0] >= n[0] / 2 ? 2500.0 : 2700.0;
    p.thermal = 0.005 * (1.0 + uniform(engine));
    p.v = random_vector(0.01 * std::sqrt(p.material.wave_modulus / p.density));
    body.p.push_back(p);
  }
  body.form_bonds(kernel);
  for (int i = 0; i < body.size(); i++)
    for (int j = 0; j < i; j++)
      if (0.5 * (1.0 + uniform(engine)) < broken) body.W(i, j) = body.W(j, i) = 0.0f;
  return body;
}

/** The arrays of the sweeps for a body. */
template <int D> struct Layout {
  TMSPH::Slices bonds;
  std::vector<double> kinematic, force_row;

  /** @param hourglass zeta: chi = zeta E
      @param lanes     particles per slice, the others are pads */
  Layout(const Body<D> &body, double hourglass, int lanes = TMSPH::LANES)
  {
    using R = TMSPH::Rows<D>;
    using TMSPH::LANES;
    const int n = body.size();
    bonds.offset.push_back(0);
    for (int first = 0; first < n; first += lanes) {
      const int q = bonds.count(), valid = std::min(lanes, n - first);
      size_t rows = 0;
      std::vector<int> family[LANES];
      for (int l = 0; l < valid; l++) {
        for (int j = 0; j < n; j++)
          if (j != first + l && (body.p[j].X - body.p[first + l].X).norm() < body.horizon)
            family[l].push_back(j);
        rows = std::max(rows, family[l].size());
      }
      bonds.valid.push_back(valid);
      bonds.offset.push_back(bonds.offset.back() + (int) rows);
      bonds.partner.resize((size_t) bonds.offset.back() * LANES);
      bonds.weight.resize(bonds.partner.size());
      bonds.own.resize((size_t) (q + 1) * TMSPH::CONSTANTS<D> * LANES, 0.0);
      for (int l = 0; l < LANES; l++) {
        const int i = l < valid ? first + l : first;
        bonds.particle.push_back(i);
        for (size_t b = 0; b < rows; b++) {
          const bool here = b < family[l].size();
          bonds.partner[bonds.at(q, l, b)] = here ? family[l][b] : i;
          bonds.weight[bonds.at(q, l, b)] = here ? body.W(i, family[l][b]) : 0.0f;
        }
        if (l < valid)
          set_constants(body, hourglass, i,
                        bonds.own.data() + (size_t) q * TMSPH::CONSTANTS<D> * LANES + l);
      }
    }
    kinematic.assign((size_t) n * R::KINEMATIC, 0.0);
    force_row.assign((size_t) n * R::FORCE, 0.0);
    for (int i = 0; i < n; i++) {
      const Particle<D> &p = body.p[i];
      double *row = kinematic.data() + (size_t) i * R::KINEMATIC;
      double *end = force_row.data() + (size_t) i * R::FORCE;
      for (int k = 0; k < D; k++) {
        row[R::X + k] = p.X[k];
        row[R::U + k] = p.u[k];
        end[R::V + k] = p.v[k];
      }
      row[R::YOUNG] = p.material.young;
      row[R::THERMAL] = p.material.young * p.thermal;
      (D == 2 ? row : end)[R::SPEED] = std::sqrt(p.material.wave_modulus / p.density);
      (D == 2 ? row : end)[R::DENSITY] = p.density;
    }
  }

 private:
  static void set_constants(const Body<D> &body, double hourglass, int i, double *own)
  {
    const Particle<D> &p = body.p[i];
    const Square<D> inverse = p.singular ? Square<D>(Square<D>::Zero()) : body.shape(i).inverse();
    int entry = 0;
    const auto put = [&](double value) { own[TMSPH::LANES * entry++] = value; };
    for (int a = 0; a < D; a++)
      for (int b = a; b < D; b++) put(inverse(a, b));
    put(p.volume);
    put(p.material.lambda);
    put(p.material.shear);
    put(p.singular ? 0.0 : hourglass * p.material.young);
  }
};

}    // namespace TMSPH_TEST
#endif
