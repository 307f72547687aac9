// SPDX-License-Identifier: MIT
// Whole coordinates of cages whose faces are small for their distance, as fine cages' and single small faces are,
// against sums of closed forms in 50 digits; and the rules that they take.
#include "../src/batch/far_rules.h"
#include "block_errors.h"
#include "fine_sphere.h"
#include "small_face.h"
#include "thinned.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>
#include <vector>

namespace cageproof::far_faces_test {
namespace {

using namespace block_errors;
using closed_form::batch::far_rules;
using closed_form::batch::FarRule;
using closed_form::batch::kFarRules;
using closed_form::batch::line_rule;
using closed_form::batch::LineRule;

// Within, next to the surface, and outside.
std::vector<Point> points_about(const Cage& cage, int count) {
  std::vector<Point> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) {
    RandomStream random(11, cage.name(), i);
    constexpr std::array distances{0.3, 0.9, 0.6, 1.15, 0.02, 0.98, 1.6, 4.};
    points.push_back(distances[i % distances.size()] * direction(random));
  }
  return points;
}

// Each order up to the highest is computed in its own way.
double worst_error(const Cage& cage, std::string_view kind, int highest, int count) {
  const CageCoordinates found = coordinates_of(cage, kind, "batched"), reference = coordinates_of(cage, kind, "");
  EXPECT_EQ(found.evaluation(), "batched");
  double worst = 0;
  // Kinds take turns where not all points are asked.
  for (const Point& p : thinned(points_about(cage, count), kind.size())) {
    const auto truth = block_truth(reference, p, highest, OfHessians::WithSlope);
    for (int order = 0; order <= highest; ++order) {
      const double error = block_error(found, truth, cage.size(), p, order);
      EXPECT_TRUE(std::isfinite(error)) << kind << ", order " << order << " at " << p.transpose();
      worst = std::max(worst, error);
    }
  }
  return worst;
}

TEST(FarFaces, fine_cages_keep_the_promise) {
  const Cage cage = sphere(320);
  for (const char* kind : {"green", "biharmonic", "somigliana"}) EXPECT_LE(worst_error(cage, kind, 2, 8), 64) << kind;
  const Cage fine = sphere(1280);
  for (const char* kind : {"green", "biharmonic", "somigliana"}) EXPECT_LE(worst_error(fine, kind, 1, 4), 64) << kind;
}

TEST(FarFaces, a_sphere_of_5120_triangles_keeps_the_promise) {
  const Cage cage = sphere(5120);
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"})
    EXPECT_LE(worst_error(cage, kind, 1, 2), 64) << kind;
}

// Faces about one corner of an icosahedron are cut again and again, halfway to that corner.
Cage graded(int times) {
  const Cage cage = embedded_cage("icosphere");
  std::vector<Point> vertices = cage.vertices();
  std::vector<Face> faces = cage.faces();
  for (; times > 0; --times) {
    std::map<int, int> middles;
    const auto middle = [&](int v) {
      const auto [place, added] = middles.try_emplace(v, static_cast<int>(vertices.size()));
      if (added) vertices.emplace_back((vertices[0] + vertices[v]) / 2);
      return place->second;
    };
    std::vector<Face> cut;
    for (const Face& face : faces) {
      std::array<int, 3> v{face.vertices[0], face.vertices[1], face.vertices[2]};
      const auto corner = std::ranges::find(v, 0);
      if (corner == v.end()) {
        cut.push_back(face);
        continue;
      }
      std::ranges::rotate(v, corner);
      const int b = middle(v[1]), c = middle(v[2]);
      for (const auto& [i, j, k] : {std::array{0, b, c}, {b, v[1], v[2]}, {b, v[2], c}}) cut.push_back({{i, j, k, -1}});
    }
    faces = std::move(cut);
  }
  return cage.with(std::move(vertices), std::move(faces));
}

TEST(FarFaces, graded_cages_keep_the_promise) {
  for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"})
    EXPECT_LE(worst_error(graded(14), kind, 2, 4), 64) << kind;
}

TEST(FarFaces, one_small_face_breaks_nothing) {
  for (const double size : {0.1, 5e-3, 1e-4, 1e-7})
    for (const char* kind : {"green", "biharmonic", "somigliana"})
      EXPECT_LE(worst_error(with_small_face(size), kind, 2, 8), 64) << kind << ' ' << size;
}

// Whatever points it is computed with, which may be nearer, further, or see faces as thin.
TEST(FarFaces, a_point_does_not_depend_on_its_neighbours) {
  for (const Cage& cage : {sphere(320), sphere(1280)}) {
    const std::vector<Point> points = points_about(cage, 24);
    for (const char* kind : {"green", "biharmonic", "somigliana", "mean_value"})
      for (int order = 0; order <= 2; ++order) {
        const CageCoordinates coordinates = coordinates_of(cage, kind, "batched");
        std::vector<CoordinateTable<double>> together, alone;
        coordinates.at(points, order, together);
        for (std::size_t p = order; p < points.size(); p += test_stride()) {
          coordinates.at(std::span(points).subspan(p, 1), order, alone);
          for (std::size_t b = 0; b < alone.size(); ++b)
            for (int o = 0; o <= order; ++o) {
              const auto first =
                  together[b].tensors[o].begin() + static_cast<std::ptrdiff_t>(p * together[b].stride[o]);
              ASSERT_TRUE(std::equal(alone[b].tensors[o].begin(), alone[b].tensors[o].end(), first))
                  << kind << ' ' << order << ", at " << points[p].transpose();
            }
        }
      }
  }
}

// Mean of a monomial of barycentric coordinates over a triangle: 2 i! j!/(i + j + 2)!.
long double mean_of(int i, int j) {
  long double mean = 2;
  for (int k = 1; k <= i; ++k) mean *= k;
  for (int k = 1; k <= j; ++k) mean *= k;
  for (int k = 1; k <= i + j + 2; ++k) mean /= k;
  return mean;
}

TEST(FarRules, integrate_polynomials_up_to_their_degree) {
  int last = 0;
  for (int r = 0; r < kFarRules; ++r) {
    const FarRule& rule = far_rules()[r];
    ASSERT_LE(rule.nodes, closed_form::batch::kMostNodes);
    EXPECT_GT(rule.nodes, last);
    last = rule.nodes;
    for (int i = 0; i <= rule.degree; ++i)
      for (int j = 0; i + j <= rule.degree; ++j) {
        long double sum = 0;
        for (int q = 0; q < rule.nodes; ++q)
          sum += rule.weight[q][3] * std::pow(static_cast<long double>(rule.along[0][q]), i) *
                 std::pow(static_cast<long double>(rule.along[1][q]), j);
        EXPECT_NEAR(static_cast<double>(sum / mean_of(i, j)), 1, 4e-15) << rule.nodes << ' ' << i << ' ' << j;
      }
    for (int q = 0; q < rule.nodes; ++q) {
      double hats = 0;
      for (int k = 0; k < 3; ++k) {
        EXPECT_GT(rule.weight[q][k], 0);
        hats += rule.weight[q][k];
      }
      EXPECT_NEAR(hats / rule.weight[q][3], 1, 4e-16);
    }
  }
}

TEST(FarRules, of_a_line_integrates_polynomials) {
  for (int i = 0; i < 2 * LineRule::nodes; ++i) {
    long double sum = 0;
    for (int q = 0; q < LineRule::nodes; ++q)
      sum += line_rule()->weight[q] * std::pow(static_cast<long double>(line_rule()->along[q]), i);
    EXPECT_NEAR(static_cast<double>(sum * (i + 1)), 1, 4e-15) << i;
  }
}

}  // namespace
}  // namespace cageproof::far_faces_test
