// SPDX-License-Identifier: MIT
// Next to vertices and edges derivatives of single elements' integrals leave double's range. Those of the coordinates
// stay numbers where their own size allows it: against truths in 1500 digits, from mpmath's logarithms of hat
// functions' Cauchy transforms, and against what coordinates reproduce.
#include "cageproof/core/cage/cage.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/coordinates/coordinates.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cageproof {
namespace {

using Place = Vec3<double>;
constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

Cage pentagon() {
  std::vector<Face> sides;
  sides.reserve(5);
  for (int i = 0; i < 5; ++i) sides.push_back({{i, (i + 1) % 5, -1, -1}});
  return Cage::make_polygon("pentagon", {{0, 0, 0}, {2, -1, 0}, {3, 1, 0}, {1.5, 3, 0}, {-0.5, 1, 0}}, sides);
}

// The gradient, or xx, xy and yy of the Hessian, of each vertex.
template <std::size_t N>
using Rows = std::array<std::array<double, N>, 5>;

void expect_near(double found, double truth, double relative) {
  if (std::isnan(truth)) EXPECT_TRUE(std::isnan(found)) << found;
  else if (std::isinf(truth)) EXPECT_EQ(found, truth);
  else EXPECT_NEAR(found, truth, relative * std::abs(truth) + 0x1p-60);
}

void expect_hessians(const std::vector<double>& found, const Rows<3>& truth) {
  for (std::size_t v = 0; v < 5; ++v)
    for (const std::size_t i : {0, 1, 2, 3}) expect_near(found[4 * v + i], truth[v][(i + 1) / 2], 1e-13);
}

TEST(beyond_range, of_a_polygon_next_to_a_vertex) {
  const Rows<2> gradients{{{-59.634642154171022, -47.830933476533361},
                           {12.074416081213543, 23.741256880039356},
                           {0.035935760358668023, 0.023281270288082466},
                           {0.047608978109432609, 0.03093402006140096},
                           {47.476681334489378, 24.035461306144521}}};
  const Rows<3> hessians{{{2.7495335767521228e+161, 5.9573227496295995e+161, -2.7495335767521228e+161},
                          {-0.02864788975654116, -2.291277980626769e+161, 0.02864788975654116},
                          {0.018037560217081471, 0.020159626124973409, -0.018037560217081471},
                          {-0.014854461355243565, 0.044563384065730694, 0.014854461355243565},
                          {-2.7495335767521228e+161, -3.6660447690028305e+161, 2.7495335767521228e+161}}};
  // Terms of 1e643 leave 200 digits no word on their sums of 1e320, at the vertex: these are said to be unknown.
  // Nothing else is summed.
  const Rows<3> at_the_least{{{nan, nan, nan},
                              {-inf, -inf, inf},
                              {0.018037560217081471, 0.020159626124973409, -0.018037560217081471},
                              {-0.014854461355243565, 0.044563384065730694, 0.014854461355243565},
                              {-inf, -inf, inf}}};
  const Rows<3> of_sides{{{-inf, inf, inf},
                          {0.049823378039202394, -0.0071176254341717706, -0.049823378039202394},
                          {0.0053051647697298445, 0.037136153388108912, -0.0053051647697298445},
                          {-0.12004217548761414, 0, 0.12004217548761414},
                          {inf, -inf, -inf}}};
  for (const char* evaluation : {"batched", "closed_form"}) {
    const CageCoordinates green(pentagon(), coordinate_kind_named("green"), evaluation, Triangulation::Shortest);
    const auto phi = green.at(Place(0x1p-540, 0x1p-541, 0), 2)[0];
    for (std::size_t v = 0; v < 5; ++v)
      for (std::size_t i = 0; i < 2; ++i) expect_near(phi.gradient[2 * v + i], gradients[v][i], 1e-13);
    expect_hessians(phi.hessian, hessians);
    const auto least = green.at(Place(0x1p-1068, 0x1p-1070, 0), 2);
    expect_hessians(least[0].hessian, at_the_least);
    expect_hessians(least[1].hessian, of_sides);
  }
}

// An octahedron with a vertex at the origin and an edge along x.
Cage octahedron() {
  std::vector<Face> faces;
  for (const auto& f :
       {std::array{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {5, 1, 2}, {5, 2, 3}, {5, 3, 4}, {5, 4, 1}})
    faces.push_back({{f[0], f[1], f[2], -1}});
  return Cage::make("octahedron", {{0, 0, 0}, {2, 0, 0}, {1, 1, 0.5}, {0.25, 0.5, 2}, {1, -1, 0.75}, {2, 0.5, 2}},
                    faces);
}

// Inside, outside and on a face, next to the edge and to the vertex.
std::vector<Place> beside() {
  std::vector<Place> points;
  for (const double d : {1e-150, 1e-156, 1e-200, 1e-240}) {
    points.emplace_back(0.75, 0, d);
    points.emplace_back(0.75, d, -d);
    points.emplace_back(d, d / 4, d / 2);
    points.emplace_back(-d, 0, 0);
    points.emplace_back(1, d, d / 2);
  }
  return points;
}

TEST(beyond_range, nothing_of_a_cage_in_space_is_no_number) {
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"})
    for (const char* evaluation : {"batched", "closed_form"}) {
      const CageCoordinates coordinates(octahedron(), coordinate_kind_named(kind), evaluation, Triangulation::Shortest);
      for (const Place& p : beside()) {
        if (!coordinates.elements().touching(p).empty()) continue;
        for (const Result<double>& block : coordinates.at(p, 2))
          for (int o = 0; o <= 2; ++o)
            for (const double x : block.of(o)) ASSERT_FALSE(std::isnan(x)) << kind << o << " at " << p.transpose();
      }
      for (const double d : {1e-310, 5e-324})
        for (const Result<double>& block : coordinates.at(Place(0.75, d, 2 * d), 1))
          for (const double x : block.gradient) ASSERT_FALSE(std::isnan(x)) << kind << " at " << d;
    }
}

// The coordinates' vertices, times the derivatives, are the derivatives of the point.
TEST(beyond_range, mean_values_next_to_a_vertex_reproduce_to_first_order) {
  const Cage cage = octahedron();
  const CageCoordinates coordinates(cage, coordinate_kind_named("mean_value"), "batched", Triangulation::Shortest);
  for (const double d : {1e-120, 1e-154, 1e-160, 1e-180}) {
    const auto lambda = coordinates.at(Place(d, d / 8, d / 2), 1)[0];
    for (int i = 0; i < 3; ++i) {
      Place sum = Place::Zero();
      for (std::size_t v = 0; v < 6; ++v) sum += lambda.gradient[3 * v + i] * cage.vertices()[v];
      EXPECT_LE((sum - Place::Unit(i)).norm(), 1e-13) << d;
    }
  }
}

// Next to a rectangle's corner, along its bisector: the truths of both neighbours' slopes and bends are mpmath's. The
// corner's own coordinate is one, less the others.
TEST(beyond_range, mean_values_next_to_a_corner_of_the_plane) {
  const Cage bar = Cage::make_polygon("bar", {{0, 0, 0}, {3, 0, 0}, {3, .5, 0}, {0, .5, 0}},
                                      {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 3, -1, -1}}, {{3, 0, -1, -1}}});
  for (const char* evaluation : {"batched", "closed_form"}) {
    const CageCoordinates coordinates(bar, coordinate_kind_named("mean_value"), evaluation, Triangulation::Shortest);
    for (const double d : {1e-16, 1e-30, 1e-65, 1e-80, 1e-104, 1e-120, 1e-170}) {
      const auto lambda = coordinates.at(Place(d, d, 0), 2)[0];
      const std::string where = fmt::format("{} at {}", evaluation, d);
      EXPECT_NEAR(lambda.gradient[2 * 1], 0.28855789418045645, 1e-15) << where;
      EXPECT_NEAR(lambda.gradient[0], -0.28855789418045645, 1e-14) << where;
      EXPECT_NEAR(lambda.hessian[4 * 1] * d, 0.05404873623204328, 1e-15) << where;
      EXPECT_NEAR(lambda.hessian[0] * d, -0.05404873623204328, 1e-14) << where;
    }
  }
}

// Beside entries that float cannot hold. Closed forms in 100 digits are the truth.
TEST(beyond_range, hybrids_in_float_keep_what_float_holds) {
  struct Input {
    const char* formula;
    std::vector<Place> corners;
    Place point;
  };
  const std::vector<Input> inputs{
      {"segment.winding_angle", {{0, 0, 0}, {-2, 2, 0}}, {0, -0x1.4p-124, 0}},
      {"segment.winding_angle", {{0, 0, 0}, {1, -1, 0}}, {0, 0x1.8p-90, 0}},
      {"segment.mean_value", {{0, 0, 0}, {4, 0, 0}}, {0x1.8p-25, -0x1p-95, 0}},
      {"segment.mean_value", {{0, 0, 0}, {0, 2, 0}}, {0x1p-100, 0, 0}},
      {"segment.double_layer", {{0, 0, 0}, {-1, 4, 0}}, {0x1.4p-110, 0x1.4p-110, 0}},
      {"segment.kelvin_traction", {{0, 0, 0}, {2, 1, 0}}, {0x1p-80, -0x1p-81, 0}},
      {"triangle.mean_value", {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}}, {.75, .25, 0x1.8p-82}},
      {"triangle.mean_value", {{0, 0, 0}, {-3, 0, 0}, {0, 2, 0}}, {0x1.8p-101, 0, -0x1.8p-101}},
      {"triangle.double_layer", {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {0.5, -0x1p-75, 0x1p-77}},
      {"triangle.solid_angle", {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {0x1p-70, -0x1p-72, 0x1p-71}}};
  constexpr float most = std::numeric_limits<float>::max();
  int beyond = 0;
  for (const Input& input : inputs) {
    const auto in = [&]<Scalar R>(const char* evaluation) {
      std::vector<Vec3<R>> corners;
      corners.reserve(input.corners.size());
      for (const Place& corner : input.corners) corners.push_back(convert<R>(corner));
      const std::vector<Parameter>& named = find_formula(input.formula)->parameters;
      std::vector<R> parameters;
      parameters.reserve(named.size());
      for (const Parameter& parameter : named) parameters.emplace_back(parameter.preset);
      Result<R> result;
      evaluation_named(input.formula, evaluation)(Query<R>{corners, convert<R>(input.point), 2, parameters}, result);
      return result;
    };
    const Result<float> found = in.operator()<float>("hybrid");
    const Result<Mp100> truth = in.operator()<Mp100>("closed_form");
    for (int o = 0; o <= 2; ++o) {
      double norm = 0;
      for (const Mp100& x : truth.of(o))
        if (abs(x) < most) norm = std::hypot(norm, static_cast<double>(x));
      for (std::size_t i = 0; i < found.of(o).size(); ++i) {
        const float expected = static_cast<float>(truth.of(o)[i]), x = found.of(o)[i];
        const std::string where = fmt::format("{} order {} entry {}", input.formula, o, i);
        if (std::isfinite(expected)) {
          EXPECT_NEAR(x, expected, 64 * 0x1p-24 * norm + 0x1p-148) << where;
        } else {
          EXPECT_EQ(x, expected) << where;
          ++beyond;
        }
      }
    }
  }
  EXPECT_GE(beyond, 10);
}

}  // namespace
}  // namespace cageproof
