// SPDX-License-Identifier: MIT
// Rules that are asked for so many digits have them where a singularity, a line far away or a zero takes some: each
// input lost its truth once.
#include "quads.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;

template <Scalar R>
Result<R> asked(std::string_view formula, std::string_view evaluation, const Quad<double>& corners,
                const Vec3<R>& point, int order, std::vector<R> parameters = {}) {
  const Quad<R> wide = convert_quad<R>(corners);
  Result<R> result;
  evaluation_named(formula, evaluation)({.corners = wide, .point = point, .order = order, .parameters = parameters},
                                        result);
  EXPECT_TRUE(result.converged) << evaluation;
  return result;
}

double relative_difference(const std::vector<Mp200>& a, const std::vector<Mp200>& b) {
  Mp200 difference(0), size(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  return static_cast<double>(Mp200(sqrt(Mp200(difference / size))));
}

// All but a triangle, next to a side: the lines have no length at v = -0.20 +- 0.74i, which the logarithm meets once it
// is continued past the side's own singularity.
TEST(StatedDigits, hold_next_to_a_side_of_a_quad_with_a_short_one) {
  const Quad<double> quad{Vec(-0x1.2e9421bfbaeacp-4, -0x1.c7def1418d3dp-3, -0x1.7d9c257fa4668p-3),
                          Vec(0x1.ae7538c137134p-3, -0x1.0890f721743fbp-3, -0x1.48c678f0d5b66p-1),
                          Vec(0x1.af5cc78a25696p-3, -0x1.06fe755151bfbp-3, -0x1.4884b17089104p-1),
                          Vec(0x1.9c058c7e0fcecp-4, 0x1.3661439b51611p-2, 0x1.03d1c0c2ae89bp-2)};
  const auto point = convert<Mp200>(Vec(0x1.15d4d7f3c9bd2p-37, 0x1.32db1159de11p-39, -0x1.9393d01ecc451p-38));
  for (const char* formula : {"quad.single_layer", "quad.double_layer", "quad.biharmonic_single_layer",
                              "quad.biharmonic_double_layer", "quad.kelvin_displacement", "quad.kelvin_traction"}) {
    const bool kelvin = std::string_view(formula).starts_with("quad.kelvin");
    const std::vector<Mp200> parameters = kelvin ? std::vector<Mp200>{Mp200(1), Mp200(0.25)} : std::vector<Mp200>{};
    const auto found = asked<Mp200>(formula, "line-36", quad, point, 2, parameters),
               more = asked<Mp200>(formula, "line-80", quad, point, 2, parameters);
    for (int o = 0; o <= 2; ++o) EXPECT_LT(relative_difference(found.of(o), more.of(o)), 1e-34) << formula << ' ' << o;
  }
}

// N.x all but vanishes next to the point, and lines far from it have all but all of the integral.
TEST(StatedDigits, hold_where_the_nearest_lines_add_nothing) {
  const Quad<double> quad{Vec(1, 0, 0), Vec(0, 0, 0), Vec(0, 1, -0x1.1d44ccb15054fp-856), Vec(1, 1, 0)};
  const auto point = convert<Mp200>(Vec(1, -0x0.00000000057f5p-1022, 0));
  const auto found = asked<Mp200>("quad.mean_value", "line-36", quad, point, 0),
             more = asked<Mp200>("quad.mean_value", "line-80", quad, point, 0);
  EXPECT_LT(relative_difference(found.value, more.value), 1e-34);
}

// The Hessian is odd about the centre of a symmetric quad: next to it, it is linear in the distance, and taken at
// another distance it says what it is.
TEST(StatedDigits, hold_next_to_the_centre_of_a_symmetric_quad) {
  const Quad<double> quad{Vec(1, 1, 0), Vec(1, 0, 1), Vec(-1, -1, 0), Vec(-1, 0, -1)};
  const auto at = [&]<Scalar R>(const R& distance) {
    return asked<R>("quad.solid_angle", "closed_form", quad, Vec3<R>(R(0), R(-distance), R(0)), 2);
  };
  // Cubic terms are 2^-140 of the linear ones.
  const auto near = at(ldexp(Mp200(1), -70));
  for (const int exponent : {-343, -524, -956, -1074}) {
    const auto expected = [&](std::size_t i) { return ldexp(near.hessian[i], exponent + 70); };
    const auto found = at(ldexp(Mp100(1), exponent));
    const auto rounded = at(std::ldexp(1.0, exponent));
    const Mp200 size = ldexp(Mp200(1), exponent);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_LT(static_cast<double>(Mp200(abs(Mp200(Mp200(found.hessian[i]) - expected(i))) / size)), 1e-38)
          << exponent;
      // Entries below 8 are rounded once.
      if (exponent > -1000)
        EXPECT_LT(static_cast<double>(Mp200(abs(Mp200(Mp200(rounded.hessian[i]) - expected(i))) / size)), 0x1p-50)
            << exponent;
    }
  }
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
