// SPDX-License-Identifier: MIT
// Stress of displacements whose stress textbooks state.
#include "cageproof/deformation/stress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace cageproof::deformation::test {
namespace {

using Vector = Vec3<long double>;

constexpr long double half_turn = std::numbers::pi_v<long double>;

// Kelvin's displacement of a force at the origin in an infinite body, of shear modulus mu; in the plane, plane strain.
Vector kelvin(const Vector& x, const Vector& force, int dimension, long double mu, long double nu) {
  const long double r = x.norm(), scale = 1 / ((dimension == 3 ? 16 : 8) * half_turn * mu * (1 - nu));
  if (dimension == 3) return scale / r * ((3 - 4 * nu) * force + x * x.dot(force) / (r * r));
  return scale * (-(3 - 4 * nu) * std::log(r) * force + x * x.dot(force) / (r * r));
}

// Its stress, as Love and Brebbia print it.
Mat3<long double> kelvin_stress(const Vector& x, const Vector& force, int dimension, long double nu) {
  const long double r = x.norm(), scale = -1 / ((dimension == 3 ? 8 * r : 4) * half_turn * (1 - nu) * r);
  const Vector e = x / r;
  Mat3<long double> found = Mat3<long double>::Zero();
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      found(i, j) = scale * (dimension * e[i] * e[j] * e.dot(force) +
                             (1 - 2 * nu) * (e[j] * force[i] + e[i] * force[j] - (i == j ? e.dot(force) : 0)));
  // Plane strain holds its thickness by this stress.
  if (dimension == 2) found(2, 2) = nu * (found(0, 0) + found(1, 1));
  return found;
}

// The Jacobian of x + u(x), by differences of sixth order.
Mat3<double> jacobian_of_kelvin(const Vector& x, const Vector& force, int dimension, long double mu, long double nu) {
  const long double h = 1e-3L * x.norm();
  const auto at = [&](int axis, int steps) -> Vector {
    return kelvin(x + steps * h * Vector::Unit(axis), force, dimension, mu, nu);
  };
  Mat3<double> jacobian = Mat3<double>::Identity();
  for (int i = 0; i < dimension; ++i) {
    const Vector slope = (45 * (at(i, 1) - at(i, -1)) - 9 * (at(i, 2) - at(i, -2)) + at(i, 3) - at(i, -3)) / (60 * h);
    jacobian.col(i) += slope.cast<double>();
  }
  return jacobian;
}

// Roundings of the Jacobian's entries, which are about one, and 1e-16 by differences.
constexpr double roundings = 1e-14;

TEST(stress, of_a_force_in_an_infinite_body) {
  for (const int dimension : {2, 3})
    for (const double nu : {-0.5, 0.0, 0.3, 0.45}) {
      const long double mu = 2.5;
      const Vector x(0.75, -0.5, dimension == 3 ? 1.25 : 0), force(1, 2, dimension == 3 ? -3 : 0);
      const Stress found = stress_of(jacobian_of_kelvin(x, force, dimension, mu, nu), {2.5, nu});
      const Mat3<double> wanted = kelvin_stress(x, force, dimension, nu).cast<double>();
      const double bound = roundings * 2.5 / (1 - 2 * nu);
      EXPECT_LT((found.stress - wanted).norm(), bound) << dimension << ' ' << nu;
      const Vec3<double> normal = Vec3<double>(2, 3, dimension == 3 ? 6 : 0).normalized();
      EXPECT_LT((found.traction(normal) - wanted * normal).norm(), bound) << dimension << ' ' << nu;
      if (dimension == 2) EXPECT_EQ(found.strain.col(2), Vec3<double>::Zero());
    }
}

TEST(stress, of_a_pulled_and_of_a_sheared_rod) {
  const double mu = 0.75, nu = 0.25, young = 2 * mu * (1 + nu), pull = 0.125;
  const Vec3<double> stretches(1 + pull / young, 1 - nu * pull / young, 1 - nu * pull / young);
  const Stress pulled = stress_of(stretches.asDiagonal(), {mu, nu});
  EXPECT_LT((pulled.stress - Vec3<double>(pull, 0, 0).asDiagonal().toDenseMatrix()).norm(), roundings);
  EXPECT_NEAR(pulled.von_mises(), pull, roundings);
  Mat3<double> shear = Mat3<double>::Identity();
  shear(0, 1) = 0.5;
  const Stress sheared = stress_of(shear, {mu, nu});
  EXPECT_NEAR(sheared.strain(0, 1), 0.25, roundings);
  EXPECT_NEAR(sheared.strain(1, 0), 0.25, roundings);
  EXPECT_NEAR(sheared.von_mises(), std::sqrt(3) * mu * 0.5, roundings);
}

// 2 mu nu/(1 - 2 nu) tends to -mu.
TEST(stress, infinite_poisson_ratio_is_the_limit) {
  const Material limit{2, std::numeric_limits<double>::infinity()}, near{2, 1e12};
  EXPECT_EQ(limit.lame(), -2);
  EXPECT_NEAR(near.lame(), limit.lame(), 1e-11);
  EXPECT_TRUE(has_stress(limit.poisson_ratio));
  EXPECT_TRUE(has_stress(-0.99));
  for (const double nu : {-1.0, 0.5, 0.6, std::numeric_limits<double>::quiet_NaN()}) EXPECT_FALSE(has_stress(nu)) << nu;
}

TEST(stress, a_jacobian_without_limit_has_none) {
  Mat3<double> jacobian = Mat3<double>::Identity();
  jacobian(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(stress_of(jacobian, {}).von_mises()));
}

}  // namespace
}  // namespace cageproof::deformation::test
