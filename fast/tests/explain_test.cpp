// SPDX-License-Identifier: MIT
// The explained operations are those of the evaluation: bit for bit, wherever it computes in double.
#include "cageproof/closed_form/explain.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/fast/triangle/hybrid.h"
#include "segment_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cageproof::closed_form {
namespace {

struct Input {
  std::vector<Vec3<double>> corners;
  Vec3<double> point;
};

// Triangles of all shapes, and points from 1e-9 to 1e4 off them, over, beside and on them.
Input triangle_input(int i) {
  RandomStream random(43, "explain", i);
  Input x;
  for (int k = 0; k < 3; ++k)
    x.corners.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  if (i % 3 == 1) {  // thin, or with a short edge
    const double thin = std::pow(10., -random.uniform(0, 4));
    const double along = i % 2 == 0 ? 0.5 : 1;
    x.corners[2] = (1 - along) * x.corners[0] + along * x.corners[1] + thin * (x.corners[2] - x.corners[0]);
  }
  if (i % 5 == 4)
    for (auto& corner : x.corners) corner = (4 * corner).array().round();
  const double u = random.uniform(-0.2, 1.2), v = random.uniform(-0.2, 1.2),
               reach = std::pow(10., random.uniform(-9, 4));
  x.point = x.corners[0] + u * (x.corners[1] - x.corners[0]) + v * (x.corners[2] - x.corners[0]) +
            reach * Vec3<double>(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  if (i % 11 == 10) x.point = 0.5 * (x.corners[0] + x.corners[1]);
  return x;
}

Input segment_input(int i) {
  const auto regimes = segment::segment_regimes();
  const auto sample = regimes[i % regimes.size()].second(i / static_cast<int>(regimes.size()));
  return {{sample.s[0], sample.s[1]}, sample.point};
}

bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// The entry in 200 digits, and the norm of its tensor.
std::pair<Mp200, double> truth_of(const Formula& formula, const Query<double>& query, std::size_t entry) {
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(query.corners.size());
  for (const auto& corner : query.corners) corners.push_back(convert<Mp200>(corner));
  const std::vector<Mp200> parameters(query.parameters.begin(), query.parameters.end());
  Result<Mp200> result;
  evaluation_named(formula.name, "closed_form")(
      Query<Mp200>{corners, convert<Mp200>(query.point), query.order, parameters}, result);
  double norm = 0;
  for (const Mp200& x : result.of(query.order)) norm = std::hypot(norm, static_cast<double>(x));
  return {result.of(query.order)[entry], norm};
}

using Named = std::pair<std::string_view, std::string_view>;
class Explained : public testing::TestWithParam<Named> {};

TEST_P(Explained, is_what_is_computed) {
  const auto [formula_name, evaluation] = GetParam();
  const Formula& formula = formula_named(formula_name);
  std::vector<double> parameters;
  parameters.reserve(formula.parameters.size());
  for (const Parameter& p : formula.parameters) parameters.push_back(p.preset);
  const bool plane = formula.dim() == 2;
  int kept = 0, refined = 0, entries = 0, compared = 0;
  for (int i = 0; i < (plane ? 160 : 45); ++i) {
    const Input input = plane ? segment_input(i) : triangle_input(i);
    if (!plane && (input.corners[1] - input.corners[0]).cross(input.corners[2] - input.corners[0]).norm() == 0)
      continue;
    const int order = i % 3;
    Result<double> result, alone;
    const Query<double> query{input.corners, input.point, order, parameters};
    evaluation_named(formula.name, evaluation)(query, alone);
    const std::size_t entry = static_cast<std::size_t>(i) % alone.of(order).size();
    const Explanation e = explain(formula, evaluation, query, entry, result);
    EXPECT_EQ(e.entry, entry);
    EXPECT_TRUE(evaluation == "hybrid" || e.route.find("Gauss") == std::string::npos) << e.route;
    EXPECT_TRUE(same(e.value, alone.of(order)[entry])) << "sample " << i;
    ++entries;
    // In exact arithmetic the operations give the formula. Only rules and series for double's digits err by a little,
    // at most one rounding where each of a few points' weights is the product of three rounded numbers.
    const auto [truth, norm] = truth_of(formula, query, entry);
    const bool on_border = e.route.find("on the border") != std::string::npos;
    // Where double was given up, what cancels makes large what constants of polyharmonic kernels, which have the digits
    // of long double, are wrong by.
    const bool is_given_up = plane && evaluation == "closed_form" && !e.is_the_value;
    if (!e.lines.empty() && !on_border && std::isfinite(norm) && !is_given_up) {
      EXPECT_LE(static_cast<double>(Mp200(abs(e.exact - truth))), 0x1p-53 * norm) << "sample " << i << ": " << e.route;
      ++compared;
    }
    if (e.is_the_value) {
      ++kept;
      EXPECT_TRUE(same(e.value, e.counted)) << "sample " << i << ": " << e.value << " " << e.counted;
      double sum = 0, sizes = 0;
      for (const CountedLine& line : e.lines) {
        sum += line.net;
        sizes += line.rounded;
      }
      const double error = static_cast<double>(Mp200(Mp200(e.value) - e.exact));
      const double allowed = 1e-6 * sizes + 1e-3 * std::abs(error);
      EXPECT_TRUE(!std::isfinite(error) || std::abs(sum - error) <= allowed) << "sample " << i;
    } else if (e.route.find("in vectors") != std::string::npos) {
      // The same points in another order.
      ++kept;
      EXPECT_LE(std::abs(e.value - e.counted), 0x1p-47 * norm) << "sample " << i << ": " << e.route;
    } else {
      ++refined;
      // Only where the closed form says so itself.
      EXPECT_TRUE(
          e.route.find("more digits") != std::string::npos || e.route.find("since in double") != std::string::npos ||
          e.route.find("the value diverges") != std::string::npos || e.route.find("extreme") != std::string::npos ||
          e.route.find("none in double") != std::string::npos || e.route.find("on the border") != std::string::npos)
          << "sample " << i << ": " << e.route << ", " << e.value << " is not " << e.counted;
    }
  }
  EXPECT_GE(kept, entries / 4) << refined;
  EXPECT_GE(compared, evaluation == "closed_form" ? entries / 4 : entries / 2);
}

std::vector<Named> of_triangles_and_segments() {
  std::vector<Named> names;
  for (const std::string_view evaluation : {"closed_form", "hybrid"})
    for (const std::string_view formula : explained_formulas(evaluation)) names.emplace_back(formula, evaluation);
  return names;
}

TEST(explain, explains_both_of_every_formula) {
  EXPECT_EQ(explained_formulas("closed_form"), explained_formulas("hybrid"));
  EXPECT_EQ(explained_formulas("hybrid").size(), 20U);
  EXPECT_EQ(explained_evaluations("quad.mean_value"), std::vector<std::string_view>{"line_form"});
}

INSTANTIATE_TEST_SUITE_P(formulas, Explained, testing::ValuesIn(of_triangles_and_segments()), [](const auto& tested) {
  std::string name = std::string(tested.param.first) + "_" + std::string(tested.param.second);
  std::ranges::replace(name, '.', '_');
  return name;
});

TEST(explain, refuses_what_it_does_not_know) {
  const Formula& formula = formula_named("triangle.solid_angle");
  const std::array<Vec3<double>, 3> corners{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0)};
  Result<double> result;
  const Query<double> query{corners, Vec3<double>(0.25, 0.25, 1), 1};
  EXPECT_THROW(explain(formula, "hybrid", query, 3, result), InputError);
  EXPECT_THROW(explain(formula, "closed_form", query, 3, result), InputError);
  EXPECT_THROW(explain(formula, "accurate", query, 0, result), InputError);
  EXPECT_THROW(explain(formula_named("triangle.mean_value"), "hybrid", query, 9, result), InputError);
}

// How often the form in double was kept, by its bound; an entry may only differ from it where it was not.
template <int O>
int kept_by_its_bound() {
  const Formula& formula = formula_named("triangle.single_layer");
  using F = triangle::SingleLayer;
  int kept = 0;
  for (int i = 0; i < 100; ++i) {
    // Farther away than the shortest edge is long, which then takes atanh: tracked numbers take another than double.
    RandomStream random(44, "explain", i);
    const Triangle<double> t{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0),
                             Vec3<double>(random.uniform(0.8, 1), random.uniform(0.1, 0.35), 0)};
    const Input input{{t[0], t[1], t[2]},
                      {random.uniform(0, 1), random.uniform(-0.1, 0.1), random.uniform(0.001, 0.1)}};
    fast::triangle::HybridMoments<O> at(t, input.point);
    if (fast::triangle::hybrid<F, O>(at, {}).route != fast::triangle::Route::Tracked) continue;
    ++kept;
    Result<double> result;
    for (std::size_t entry = 0; entry < derivative_count(3, O); ++entry)
      EXPECT_TRUE(explain(formula, "hybrid", {input.corners, input.point, O}, entry, result).is_the_value)
          << "order " << O << ", sample " << i;
  }
  return kept;
}

TEST(explain, more_digits_are_no_excuse) {
  EXPECT_GT(kept_by_its_bound<0>(), 30);
  EXPECT_GT(kept_by_its_bound<1>(), 10);
}

// Next to the plane the value is exact to a unit, and no operation is accused of more.
TEST(explain, compensated_geometry_is_not_accused) {
  const Formula& formula = formula_named("triangle.double_layer");
  const std::array<Vec3<double>, 3> corners{Vec3<double>(0.1, 0.2, 0.3), Vec3<double>(1.1, 0.3, 0.2),
                                            Vec3<double>(0.3, 1.2, 0.4)};
  const Vec3<double> point = 0.3 * corners[0] + 0.3 * corners[1] + 0.4 * corners[2] + Vec3<double>(0, 0, 1e-12);
  Result<double> result;
  for (const std::string_view evaluation : {"closed_form", "hybrid"}) {
    const Explanation e = explain(formula, evaluation, {corners, point, 0}, std::nullopt, result);
    ASSERT_TRUE(e.is_the_value);
    ASSERT_FALSE(e.lines.empty());
    for (const CountedLine& line : e.lines)
      EXPECT_LE(std::max(line.lost, line.rounded), 8 * 0x1p-53 * std::abs(e.value)) << line.file << ":" << line.line;
  }
}

// Far away the hybrid takes Gauss points, and the algebra climbs: double, double-double, 200 digits, as the point goes.
TEST(explain, says_which_rung_the_algebra_stands_on) {
  const Formula& formula = formula_named("triangle.double_layer");
  const std::array<Vec3<double>, 3> corners{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0)};
  const auto explained = [&](std::string_view evaluation, double height) {
    Result<double> result;
    return explain(formula, evaluation, {corners, Vec3<double>(0.25, 0.25, height), 0}, std::nullopt, result);
  };
  const auto starts = [](const Explanation& e, std::string_view with) { return e.route.starts_with(with); };
  const Explanation near = explained("closed_form", 0.5), far = explained("closed_form", 100);
  EXPECT_TRUE(starts(near, "edge form in double, with a bound of its error of ")) << near.route;
  EXPECT_TRUE(near.is_the_value);
  EXPECT_TRUE(starts(far, "edge form in double-double, since in double the bound of its error is ")) << far.route;
  EXPECT_TRUE(starts(explained("closed_form", 1e9), "edge form in 200 digits")) << explained("closed_form", 1e9).route;
  EXPECT_TRUE(explained("hybrid", 100).route.find("Gauss points") != std::string::npos);
  // The operation that loses the digits is a sum of the engine's.
  ASSERT_FALSE(far.lines.empty());
  EXPECT_FALSE(far.is_the_value);
  EXPECT_NE(far.lines.front().file.find("closed_form/triangle/engine/edge_"), std::string::npos)
      << far.lines.front().file;
  EXPECT_GE(far.lines.front().bits, 10);
}

}  // namespace
}  // namespace cageproof::closed_form
