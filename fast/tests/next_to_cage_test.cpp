// SPDX-License-Identifier: MIT
// Derivatives of mean value coordinates next to faces, edges and vertices, which are w/W of weights that grow like one
// over the distance, are right to double's digits of the largest of them.
#include "cageproof/core/coordinates/coordinates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cageproof {
namespace {

using Point = Vec3<double>;

constexpr double kPromised = 2e-13;

Cage box_with_lean_sides() {
  std::vector<Face> faces;
  for (const std::array<int, 4>& f : {std::array{0, 2, 1, -1},
                                      {0, 3, 2, -1},
                                      {4, 5, 6, -1},
                                      {4, 6, 7, -1},
                                      {0, 1, 5, -1},
                                      {0, 5, 4, -1},
                                      {1, 2, 6, -1},
                                      {1, 6, 5, -1},
                                      {2, 3, 7, -1},
                                      {2, 7, 6, -1},
                                      {3, 0, 4, -1},
                                      {3, 4, 7, -1}})
    faces.push_back({f});
  return Cage::make("box",
                    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1.25, 0, 1}, {1, 1.125, 1}, {0, 1, 0.875}},
                    faces, {});
}

Cage tetrahedron() {
  return Cage::make("tetrahedron", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                    {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{0, 3, 2, -1}}}, {});
}

Cage concave_polygon() {
  return Cage::make_polygon("concave polygon", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0.75, 0.5, 0}, {0, 2, 0}},
                            {{{0, 1, -1, -1}}, {{1, 2, -1, -1}}, {{2, 3, -1, -1}}, {{3, 4, -1, -1}}, {{4, 0, -1, -1}}});
}

Cage box_of_quads() {
  std::vector<Face> faces;
  for (const std::array<int, 4>& f :
       {std::array{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    faces.push_back({f});
  return Cage::make("box of quads",
                    {{0, 0, 0}, {1, 0, 0}, {1, 1.25, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0.125, 1}, {1, 1, 1}, {0.25, 1, 1}},
                    faces, {});
}

// So far from a face, an edge, a vertex, and from a face but not much further from its edge, on both sides.
std::vector<Point> points_at(double d, int dimension) {
  const double aside = std::sqrt(d);
  if (dimension == 2)
    return {{0.5, d, 0}, {0.5, -d, 0}, {d, 0.5 * d, 0}, {-d, 0.5 * d, 0}, {aside, d, 0}, {aside, -d, 0}};
  return {{0.25, 0.125, d}, {0.25, 0.125, -d}, {0.25, 0.75 * d, d},    {0.25, -0.75 * d, d},
          {0.25, aside, d}, {0.25, aside, -d}, {0.5 * d, 0.75 * d, d}, {0.5 * d, 0.75 * d, -d}};
}

// The largest error of an order's numbers over the largest of them.
template <Scalar R>
double error_of(const std::vector<double>& found, const std::vector<R>& reference) {
  R worst = 0, largest = 1;
  for (std::size_t i = 0; i < found.size(); ++i) {
    using std::abs;
    if (!std::isfinite(found[i])) return INFINITY;
    worst = std::max(worst, R(abs(R(R(found[i]) - reference[i]))));
    largest = std::max(largest, R(abs(reference[i])));
  }
  return static_cast<double>(R(worst / largest));
}

void expect_right(const Cage& cage, std::string_view kind, std::string_view evaluation, double d, const Point& p) {
  const CageCoordinates found(cage, coordinate_kind_named(kind), evaluation, Triangulation::Shortest),
      reference(cage, coordinate_kind_named(kind), kind == "mean_value" ? "closed_form" : "line_form",
                Triangulation::Shortest);
  const auto numbers = found.at<double>(p, 2);
  const auto wide = reference.at<Mp100>(convert<Mp100>(p), 2);
  for (const int order : {0, 1, 2})
    EXPECT_LE(error_of(numbers[0].of(order), wide[0].of(order)), kPromised)
        << cage.name() << ", " << evaluation << ", order " << order << " at " << d << ": " << p.transpose();
}

TEST(NextToCage, derivatives_have_doubles_digits) {
  for (const Cage& cage : {box_with_lean_sides(), concave_polygon()})
    for (const std::string_view evaluation : {"closed_form", "accurate", "hybrid", "batched"})
      for (const double d : {0x1p-4, 0x1p-6, 0x1p-9, 0x1p-13, 1e-6, 1e-8, 1e-12, 1e-16, 1e-20, 1e-30})
        for (const Point& p : points_at(d, cage.dimension())) expect_right(cage, "mean_value", evaluation, d, p);
}

TEST(NextToCage, so_have_those_of_quads) {
  for (const double d : {0x1p-6, 1e-4, 1e-12})
    for (const Point& p : {Point(0.25, 0.375, d), Point(0.25, 0.375, -d)})
      expect_right(box_of_quads(), "quad_mean_value", "line_form", d, p);
}

// A tetrahedron's coordinates are linear.
TEST(NextToCage, gradients_in_a_tetrahedron_are_constant) {
  const Cage cage = tetrahedron();
  const std::vector<double> gradients{-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (const std::string_view evaluation : {"closed_form", "accurate", "hybrid", "batched"}) {
    const CageCoordinates coordinates(cage, coordinate_kind_named("mean_value"), evaluation, Triangulation::Shortest);
    for (const double d : {0x1p-4, 1e-3, 1e-8, 1e-20, 1e-60, 1e-100, 1e-200, 1e-300})
      for (const Point& p : points_at(d, 3))
        EXPECT_LE(error_of(coordinates.at<double>(p, 1)[0].gradient, gradients), kPromised)
            << evaluation << " at " << d << ": " << p.transpose();
  }
}

// Where 200 digits are lost, points are seen from further off.
TEST(NextToCage, derivatives_go_on_to_the_end_of_doubles) {
  for (const Cage& cage : {box_with_lean_sides(), concave_polygon()}) {
    const CageCoordinates coordinates(cage, coordinate_kind_named("mean_value"), "closed_form",
                                      Triangulation::Shortest);
    const double apart = 1e-30, next = 1e-300;
    const auto before = points_at(apart, cage.dimension()), after = points_at(next, cage.dimension());
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto from = coordinates.at<double>(before[i], 2)[0], to = coordinates.at<double>(after[i], 2)[0];
      EXPECT_LE(error_of(to.gradient, from.gradient), kPromised) << cage.name() << " at " << after[i].transpose();
      // Hessians next to edges and vertices are over the distance, next to faces they stay. Not the same shape twice:
      // points whose other distance is the root of the first.
      const bool is_apart = std::abs(before[i][0]) == std::sqrt(apart) || std::abs(before[i][1]) == std::sqrt(apart);
      if (is_apart) continue;
      std::vector<double> hessian = from.hessian;
      const bool stays = std::abs(before[i][0]) > 1e-10 && (cage.dimension() == 2 || std::abs(before[i][1]) > 1e-10);
      for (double& x : hessian) x *= stays ? 1 : apart / next;
      EXPECT_LE(error_of(to.hessian, hessian), 1e-10) << cage.name() << " at " << after[i].transpose();
    }
  }
}

// In float too, which has as few digits to lose.
TEST(NextToCage, so_have_those_in_float) {
  const Cage cage = box_with_lean_sides();
  for (const std::string_view evaluation : {"closed_form", "hybrid", "batched"}) {
    const CageCoordinates coordinates(cage, coordinate_kind_named("mean_value"), evaluation, Triangulation::Shortest);
    for (const double d : {0x1p-10, 0x1p-14, 0x1p-40, 0x1p-90})
      for (const Point& p : points_at(d, 3)) {
        const auto found = coordinates.at<float>(convert<float>(p), 2)[0];
        const auto wide = coordinates.at<Mp100>(convert<Mp100>(p), 2)[0];
        for (const int order : {1, 2})
          EXPECT_LE(error_of(std::vector<double>(found.of(order).begin(), found.of(order).end()), wide.of(order)), 5e-7)
              << evaluation << ", order " << order << " at " << d << ": " << p.transpose();
      }
  }
}

TEST(NextToCage, there_are_none_on_it) {
  for (const std::string_view evaluation : {"closed_form", "batched"}) {
    const CageCoordinates in_space(box_with_lean_sides(), coordinate_kind_named("mean_value"), evaluation,
                                   Triangulation::Shortest),
        in_plane(concave_polygon(), coordinate_kind_named("mean_value"), evaluation, Triangulation::Shortest);
    for (const auto& [coordinates, p] : {std::pair(&in_space, Point(0.25, 0.125, 0)), {&in_plane, Point(0.5, 0, 0)}})
      for (const int order : {1, 2})
        EXPECT_TRUE(
            std::ranges::all_of(coordinates->at<double>(p, order)[0].of(order), [](double x) { return std::isnan(x); }))
            << evaluation << ", order " << order << " at " << p.transpose();
  }
}

}  // namespace
}  // namespace cageproof
