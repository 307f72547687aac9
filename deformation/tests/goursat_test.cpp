// SPDX-License-Identifier: MIT
// Maps by true coordinates of polygons: what they are on the border, where it is known, and what they keep.
#include "settings.h"

#include <numbers>

namespace cageproof::deformation::test {
namespace {

// The tolerance of the least squares that solve for true coordinates.
constexpr double kSolved = 1e-8;

struct OnEdge {
  Vec point, posed, outward, unit_normal;  ///< at rest and posed; the edge's normal at rest, and posed
};

// Places off the corners.
std::vector<OnEdge> places_on_edges(const Case& c) {
  const auto outward = [](const Vec& along) { return Vec(Vec(along[1], -along[0], 0).normalized()); };
  std::vector<OnEdge> found;
  found.reserve(3 * c.cage.faces().size());
  for (const Face& face : c.cage.faces()) {
    const int from = face.vertices[0], to = face.vertices[1];
    const Vec &a = c.cage.vertices()[from], &b = c.cage.vertices()[to];
    for (const double t : {0.25, 0.5, 0.625})
      found.push_back({a + t * (b - a), c.posed[from] + t * (c.posed[to] - c.posed[from]), outward(b - a),
                       outward(c.posed[to] - c.posed[from])});
  }
  return found;
}

// How far a map is from posed edges, and from unit normals along normals, at most.
std::pair<double, double> misses_of(const Case& c, const char* method, std::vector<double> parameters) {
  const auto deformer = prepared(c.cage, method, std::move(parameters));
  double off = 0, slope_off = 0;
  for (const OnEdge& place : places_on_edges(c)) {
    // The border itself, which edges that are not along an axis miss by a rounding.
    const Vec inside = place.point - 1e-9 * place.outward;
    const Images<double> images = deformed<double>(*deformer, c.posed, {inside}, 1);
    const auto& j = images.tensors[1];
    const Vec slope(j[0] * place.outward[0] + j[1] * place.outward[1],
                    j[2] * place.outward[0] + j[3] * place.outward[1], 0);
    keep_larger(off, (image(images, 0, 2) - place.posed).norm());
    keep_larger(slope_off, (slope - place.unit_normal).norm());
  }
  return {off, slope_off};
}

TEST(goursat, biharmonic_maps_meet_posed_edges_and_normals_which_the_scheme_misses) {
  for (const Case& c : {square(), l_shape(), pentagon()}) {
    const auto [off, slope_off] = misses_of(c, "biharmonic_goursat", {0});
    EXPECT_LT(off, kSolved) << c.name;
    EXPECT_LT(slope_off, 1e-6) << c.name << ": 1e-9 inside, second derivatives next to corners are large";
    EXPECT_GT(misses_of(c, "biharmonic_boundary", {0, 4, 1, 0}).second, 0.05) << c.name;
  }
}

TEST(goursat, harmonic_maps_of_a_rectangle_are_bilinear) {
  const Case c = square();
  const Vec p = c.points[0];
  const Vec expected = (1 - p[0]) * (1 - p[1]) * c.posed[0] + p[0] * (1 - p[1]) * c.posed[1] +
                       p[0] * p[1] * c.posed[2] + (1 - p[0]) * p[1] * c.posed[3];
  EXPECT_LT((image(deformed(*prepared(c.cage, "harmonic_goursat"), c.posed, c.points), 0, 2) - expected).norm(), 1e-12);
}

TEST(goursat, keep_what_they_say) {
  Eigen::Matrix3d linear, similar;
  linear << 1.3, .2, 0, .05, .8, 0, 0, 0, 1;
  similar = 1.5 * Eigen::AngleAxisd(0.7, Vec::UnitZ()).toRotationMatrix();
  for (const Case& c : {square(), l_shape(), pentagon()}) {
    const auto error = [&](const Setting& setting, const Eigen::Matrix3d& map) {
      std::vector<Vec> posed;
      posed.reserve(c.cage.vertices().size());
      for (const Vec& v : c.cage.vertices()) posed.emplace_back(map * v);
      return (image(deformed(kept_with(c.cage, setting), posed, c.points), 0, 2) - map * c.points[0]).norm();
    };
    const Setting harmonic{"harmonic_goursat"}, unit{"biharmonic_goursat", {{"normals", 0}}},
        complex{"biharmonic_goursat", {{"normals", 1}}};
    EXPECT_LT(error(harmonic, linear), kSolved) << c.name;
    EXPECT_LT(error(complex, similar), kSolved) << c.name;
    EXPECT_LT(error(unit, similar / 1.5), kSolved) << c.name;
    EXPECT_GT(error(unit, similar), 1e-3) << c.name;
    EXPECT_GT(error(complex, linear), 1e-3) << c.name;
  }
}

TEST(goursat, cages_without_a_solution_are_refused_and_missed_data_told) {
  std::vector<Vec> points;
  std::vector<Face> segments;
  points.reserve(49);
  segments.reserve(49);
  for (int k = 0; k < 49; ++k) {
    points.emplace_back(std::cos(2 * std::numbers::pi * k / 49), std::sin(2 * std::numbers::pi * k / 49), 0);
    segments.push_back({{k, (k + 1) % 49, -1, -1}});
  }
  const Cage many = Cage::make_polygon("many", points, segments, {});
  for (const char* method : {"harmonic_goursat", "biharmonic_goursat"}) {
    EXPECT_TRUE(contains(refusal_of([&] { prepared(many, method); }), "49 edges")) << method;
    EXPECT_TRUE(prepared(l_shape().cage, method)->prepared().warnings.empty()) << method;
  }
  // A corner cut off at 1e-4.
  const Case cut = polygon("cut", {{0, 0}, {1, 0}, {1, 1 - 1e-4}, {1 - 1e-4, 1}, {0, 1}},
                           {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}}, {.3, .6, 0});
  EXPECT_TRUE(warns_of(prepared(cut.cage, "biharmonic_goursat")->prepared(), "data on the boundary are met to"));
}

}  // namespace
}  // namespace cageproof::deformation::test
