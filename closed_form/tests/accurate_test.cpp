// SPDX-License-Identifier: MIT
// What `accurate` is made of: the frame next to an edge, the bound of an order's error, and the finite part.
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/engine/closed_form.h"
#include "cageproof/closed_form/triangle/single_layer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::closed_form::triangle::accurate_test {
namespace {

using Vec = Vec3<double>;

// Coordinates are quotients of Fibonacci numbers, whose products differ only in the last of their 106 bits.
TEST(accurate_frame, knows_how_far_beside_an_edge_it_is_however_much_cancels) {
  std::array<double, 80> f{0, 1};
  for (int i = 2; i < 80; ++i) f[i] = f[i - 1] + f[i - 2];
  const double unit = 0x1p-53;
  const Vec along = unit * Vec(f[78], f[77], f[76]);
  const Triangle<double> t{Vec(0, 0, 0), along, Vec(.25, .5, -1)};
  for (const Vec& eta : {Vec(unit * Vec(f[77], f[76], f[75])), Vec(unit * Vec(f[76], f[75], f[74]))}) {
    const Frame<double> found(t, eta);
    const Frame<Mp200> exact({convert<Mp200>(t[0]), convert<Mp200>(t[1]), convert<Mp200>(t[2])}, convert<Mp200>(eta));
    ASSERT_FALSE(found.extreme);
    for (int i = 0; i < 3; ++i) {
      const auto h = static_cast<double>(exact.edges[i].h);
      EXPECT_NEAR(found.edges[i].h * found.unit, h, 1e-14 * std::abs(h)) << i;
    }
  }
}

// The bound is relative to the norm over all entries of a tensor, of which a mixed derivative is two.
TEST(accurate_bound, counts_every_entry_of_the_hessian) {
  for (const bool mixed_errs : {false, true}) {
    Components<SingleLayer, Tracked<double>, 2> from;
    for (int m = 0; m < Monomials<2>::count; ++m) {
      const auto& e = Monomials<2>::exponents[m];
      const bool mixed = e[0] + e[1] + e[2] == 2 && derivative_factor<2>(m) == 1;
      from[0].c[m] = mixed == mixed_errs ? Tracked<double>(1., 3.) : Tracked<double>(1.);
    }
    // The derivatives of second order: twice the coefficients of squares, the others as they are.
    const double squares = 3 * 4, mixed = 6 * 1, error = 3 * std::sqrt(mixed_errs ? mixed : squares);
    const auto found = bounded<SingleLayer, 2, double>(from, 1., 3, std::numeric_limits<double>::max());
    EXPECT_DOUBLE_EQ(found.bound[2], roundoff_of<double>() * error / std::sqrt(squares + mixed));
  }
}

// An entry that becomes an infinity is no part of the norm: others have digits of their own. Its sign must be certain.
template <class T>
void expect_norm_within(const T& beyond, double largest) {
  const double u = static_cast<double>(roundoff_of<T>());
  Components<SingleLayer, Tracked<T>, 2> from;
  for (int m = 0; m < Monomials<2>::count; ++m) from[0].c[m] = Tracked<T>(T(0), 0);
  const auto set = [&](const T& large, double error) {
    from[0].c[1] = Tracked<T>(large, error);
    from[0].c[2] = Tracked<T>(T(3), 0);
    from[0].c[3] = Tracked<T>(T(4), 1 / u * 1e-3);
    return bounded<SingleLayer, 2, double>(from, 1., 3, largest).bound[1];
  };
  const double rounding = std::same_as<T, double> ? 0 : 0x1p-53;
  EXPECT_DOUBLE_EQ(set(beyond, 0), 1e-3 / 5 + rounding);
  EXPECT_DOUBLE_EQ(set(T(-beyond), 0), 1e-3 / 5 + rounding);
  EXPECT_EQ(set(beyond, std::numeric_limits<double>::infinity()), 1);
  EXPECT_LE(set(T(largest), 0), rounding + 1e-30);
}

TEST(accurate_bound, leaves_what_becomes_infinite_out_of_the_norm) {
  constexpr double largest = std::numeric_limits<double>::max();
  constexpr float in_float = std::numeric_limits<float>::max();
  expect_norm_within<double>(1e40, in_float);
  expect_norm_within<Mp200>(Mp200(1e40), in_float);
  expect_norm_within<Mp200>(Mp200("1e400"), largest);
}

// Off the triangle nothing diverges, and the finite part is all.
template <class F>
void expect_finite_part_changes_nothing() {
  const Triangle<double> t{Vec(0, 0, 0), Vec(1, 0, .25), Vec(.25, 1, 0)};
  for (const Vec& eta : {Vec(.3, .3, .5), Vec(.25, .25, 1e-9), Vec(3, -2, 5), Vec(.5, -1e-7, .125)}) {
    const auto plain = accurate<F, 2>(t, eta, {}), finite = accurate<F, 2>(t, eta, {}, true);
    for (int c = 0; c < F::components; ++c) {
      EXPECT_TRUE(std::isfinite(plain.jet.value[c]) && plain.jet.gradient[c].allFinite());
      EXPECT_EQ(finite.jet.value[c], plain.jet.value[c]) << eta.transpose();
      EXPECT_EQ(finite.jet.gradient[c], plain.jet.gradient[c]) << eta.transpose();
      EXPECT_EQ(finite.jet.hessian[c], plain.jet.hessian[c]) << eta.transpose();
    }
  }
}

TEST(accurate, finite_part_is_all_where_nothing_diverges) {
  expect_finite_part_changes_nothing<SingleLayer>();
  expect_finite_part_changes_nothing<DoubleLayer>();
}

}  // namespace
}  // namespace cageproof::closed_form::triangle::accurate_test
