/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Averaging of the dilatation, and the depth of a particle under an interface.
------------------------------------------------------------------------- */

#include "tmsph_dilatation.h"

#include "body.h"
#include "tmsph_interface.h"

using namespace TMSPH;
using namespace TMSPH_TEST;

namespace {

template <class Dimension> class Averaging : public ::testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  Body<D> body = random_body<D>(11);
  Layout<D> layout{body, 0.1};

  Averaging()
  {
    for (auto &p : body.p) p.averaged = true;
    body.average(WendlandC2(), body.kappa());
    Slices &bonds = layout.bonds;
    bonds.averaging.assign(bonds.weight.size(), 0.0f);
    for (int q = 0; q < bonds.count(); q++)
      for (int l = 0; l < bonds.valid[q]; l++)
        for (int b = 0; b < bonds.offset[q + 1] - bonds.offset[q]; b++) {
          const size_t at = bonds.at(q, l, b);
          if (bonds.weight[at] != 0.0f)
            bonds.averaging[at] = body.M(bonds.particle[q * LANES + l], bonds.partner[at]);
        }
  }

  std::vector<double> mean(const std::vector<double> &value)
  {
    std::vector<double> result(body.size());
    average_sweep<D>(layout.bonds, value.data(), result.data());
    return result;
  }
  std::vector<double> random_values(unsigned seed)
  {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double> value(body.size());
    for (double &v : value) v = uniform(engine);
    return value;
  }
};

TYPED_TEST_SUITE(Averaging, Dimensions, DimensionName);

// a homogeneous state stays as it is, at surfaces and beside broken bonds: what makes it exact
TYPED_TEST(Averaging, keeps_a_constant)
{
  for (double m : this->mean(std::vector<double>(this->body.size(), 0.7))) EXPECT_EQ(m, 0.7);
}

// sum V a mean(b) = sum V mean(a) b: the pressure is the same mean as the dilatation, and forces
// are the gradient of the energy
TYPED_TEST(Averaging, is_its_own_transpose)
{
  const auto a = this->random_values(1), b = this->random_values(2);
  const auto mean_a = this->mean(a), mean_b = this->mean(b);
  double one = 0.0, other = 0.0, size = 0.0;
  for (int i = 0; i < this->body.size(); i++) {
    const double V = this->body.p[i].volume;
    one += V * a[i] * mean_b[i];
    other += V * mean_a[i] * b[i];
    size += V * std::fabs(a[i] * b[i]);
  }
  EXPECT_NEAR(one, other, 1.0e-14 * size);
}

// it smooths: values without any order shrink, by the root of the weights' squares
TYPED_TEST(Averaging, smooths)
{
  const auto a = this->random_values(3), m = this->mean(a);
  double before = 0.0, after = 0.0;
  for (int i = 0; i < this->body.size(); i++) {
    before += a[i] * a[i];
    after += m[i] * m[i];
  }
  EXPECT_LT(after, 0.5 * before);
}

// finely spaced layers, their share of the kernel summed with the trapezoidal rule
TEST(InterfaceDepth, is_the_distance_to_a_plane)
{
  for (const auto &each : kernels())
    for (int dimension : {2, 3}) {
      const double delta = 3.0;
      const InterfaceDepth depth(each.second, dimension, delta);
      EXPECT_NEAR(depth(0.5), 0.0, 1.0e-12);
      EXPECT_EQ(depth(1.0), delta);
      EXPECT_EQ(depth(0.3), 0.0);
      const int n = dimension == 2 ? 120 : 40;
      double all = 0.0, below = 0.0;
      const double step = delta / n, plane = 0.4 * delta;
      for (int i = -n; i <= n; i++)
        for (int j = -n; j <= n; j++)
          for (int k = dimension == 2 ? 0 : -n; k <= (dimension == 2 ? 0 : n); k++) {
            const double R = step * std::sqrt(1.0 * i * i + j * j + k * k);
            const double W = kernel_value(each.second, dimension, R, delta);
            all += W;
            below += W * (i * step < plane - 1.0e-9 ? 1.0 : i * step < plane + 1.0e-9 ? 0.5 : 0.0);
          }
      EXPECT_NEAR(depth(below / all), plane, 0.002 * delta);    // trapezoids of width delta/40
    }
}

}    // namespace
