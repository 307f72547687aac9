// SPDX-License-Identifier: MIT
// The explained operations are those of the line form: bit for bit for derivatives; its values in double take four
// lines at a time, while the explained ones take one.
#include "cageproof/closed_form/explain.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace cageproof::adaptive_qmvc {
namespace {

using closed_form::CountedLine;
using closed_form::Explanation;

struct QuadInput {
  std::array<Vec3<double>, 4> corners;
  Vec3<double> point;
};

// A bent square, and points from far away down to 1e-9 off it.
QuadInput quad_input(int i) {
  RandomStream random(47, "explain", i);
  const auto noise = [&random](double size) {
    return Vec3<double>(size * random.uniform(-1, 1), size * random.uniform(-1, 1), size * random.uniform(-1, 1));
  };
  QuadInput x{{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, 0), Vec3<double>(0, 1, 0)}, {}};
  if (i % 4 != 0)
    for (auto& corner : x.corners) corner += noise(0.25);
  const double u = random.uniform(-0.1, 1.1), v = random.uniform(-0.1, 1.1);
  x.point = (1 - v) * ((1 - u) * x.corners[0] + u * x.corners[1]) + v * ((1 - u) * x.corners[3] + u * x.corners[2]) +
            noise(std::pow(10., random.uniform(-9, 1.5)));
  return x;
}

// The entry by the line form in 50 digits, and the norm of its tensor.
std::pair<Mp50, double> truth_of(const Query<double>& query, std::size_t entry) {
  std::array<Vec3<Mp50>, 4> corners;
  for (int k = 0; k < 4; ++k) corners[k] = convert<Mp50>(query.corners[k]);
  Result<Mp50> result;
  evaluation_named("quad.mean_value", "closed_form")(Query<Mp50>{corners, convert<Mp50>(query.point), query.order},
                                                     result);
  double norm = 0;
  for (const Mp50& x : result.of(query.order)) norm = std::hypot(norm, static_cast<double>(x));
  return {result.of(query.order)[entry], norm};
}

TEST(explain_line_form, is_what_the_line_form_computes) {
  const Formula& formula = formula_named("quad.mean_value");
  int kept = 0;
  for (int i = 0; i < 40; ++i) {
    const auto [corners, point] = quad_input(i);
    const int order = i % 4 == 3 ? 0 : 1 + i % 2;
    Result<double> result;
    const std::size_t entry = static_cast<std::size_t>(i) % (4 * derivative_count(3, order));
    const Explanation e = closed_form::explain(formula, "line_form", {corners, point, order}, entry, result);
    const double value = result.of(order)[entry];
    EXPECT_EQ(e.value, value);
    const auto [truth, norm] = truth_of({corners, point, order}, entry);
    EXPECT_LE(static_cast<double>(abs(Mp50(e.exact) - truth)), 4 * 0x1p-53 * norm) << "sample " << i;
    if (order == 0) {
      EXPECT_NEAR(e.counted, value, 1e-9 * std::abs(value)) << "sample " << i;
      EXPECT_NE(e.route.find("one line at a time"), std::string::npos);
      continue;
    }
    EXPECT_EQ(std::bit_cast<std::uint64_t>(e.counted), std::bit_cast<std::uint64_t>(value)) << "sample " << i;
    kept += e.is_the_value;
    double sum = 0, sizes = 0;
    for (const CountedLine& line : e.lines) {
      sum += line.net;
      sizes += line.rounded;
    }
    EXPECT_NEAR(sum, static_cast<double>(Mp200(Mp200(e.counted) - e.exact)), 1e-4 * sizes) << "sample " << i;
  }
  EXPECT_EQ(kept, 30);
}

// A point at zero's distance has nothing to explain.
TEST(explain_line_form, says_where_nothing_was_computed_in_double) {
  const std::array<Vec3<double>, 4> corners{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, 0),
                                            Vec3<double>(0, 1, 0)};
  Result<double> result;
  const Explanation e = closed_form::explain(formula_named("quad.mean_value"), "line_form",
                                             {corners, Vec3<double>(0.5, 0.25, 0x1p-60), 1}, std::nullopt, result);
  EXPECT_FALSE(e.is_the_value);
  EXPECT_TRUE(e.lines.empty());
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
