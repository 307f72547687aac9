// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_terms.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/cage_campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using Vec = Vec3<double>;

CageTerms terms_of(std::string_view cage, const char* kind) {
  return {embedded_cage(cage), coordinate_kind_named(kind), Triangulation::Shortest};
}

// At the middle of a cube all that the double layer's terms are is positive: they sum to one.
TEST(cage_terms, are_the_coordinates_where_nothing_cancels) {
  const TermSizes green = terms_of("cube", "green").at(Vec(0, 0, 0), 0),
                  mean = terms_of("cube", "mean_value").at(Vec(0, 0, 0), 0);
  EXPECT_NEAR(green.ones[0], 1, 1e-14);
  EXPECT_NEAR(mean.ones[0], 1, 1e-14);
  // Each vertex is sqrt(3)/2 away; the single layer's six sides, two triangles each, come with normals of length one.
  EXPECT_NEAR(mean.positions[0], std::sqrt(0.75), 1e-14);
  const CageCoordinates coordinates(embedded_cage("cube"), coordinate_kind_named("green"), {});
  const auto at = coordinates.at<double>(Vec(0, 0, 0), 0);
  double psi = 0;
  for (const double x : at[1].value) psi += x;
  EXPECT_NEAR(green.positions[0], std::sqrt(0.75) + psi, 1e-14);
  EXPECT_NEAR(green.blocks[0][0], length_of(at[0].value), 1e-14);
  // Normalised: divided by a sum that is off by as much.
  const CageCoordinates lambda(embedded_cage("cube"), coordinate_kind_named("mean_value"), {});
  EXPECT_NEAR(mean.blocks[0][0], 2 * length_of(lambda.at<double>(Vec(0, 0, 0), 0)[0].value), 1e-14);
}

// The two sides of a wall are seen from opposite sides, and what is left of the sum is as thin as the wall.
TEST(cage_terms, grow_as_walls_get_thin) {
  const Vec point(0.25, 0.125, 2);
  for (int order = 0; order <= 2; ++order) {
    const double thin = terms_of("thin-wall-1e-6", "mean_value").at(point, 2).ones[order],
                 thinner = terms_of("thin-wall-1e-9", "mean_value").at(point, 2).ones[order];
    EXPECT_NEAR(thinner / thin, 1e3, 10) << order;
  }
  EXPECT_LT(terms_of("thin-wall-1e-9", "green").at(point, 0).ones[0], 4);
}

// The closed form, and one that loses ten bits in every term: the promise must see the one in the other, thin wall or
// not, though it allows both to lose digits there.
const RegisterEvaluation lossy{
    single_family("triangle.mean_value", "lossy", {.description = "loses ten bits", .role = Role::Foreign}, false,
                  [](Evaluation& bad) {
                    const Evaluation good = evaluation_named("triangle.mean_value", "closed_form");
                    for (const ScalarKind kind : scalar_kinds)
                      with_scalar(kind, [&]<Scalar R>() {
                        bad.set_point<R>([good](const Query<R>& query, Result<R>& result) {
                          good(query, result);
                          int i = 0;
                          for (R& x : result.value) x *= R(1) + R((i++ % 3 - 1) * 0x1p-43);
                        });
                      });
                  })};

TEST(cage_terms, show_lost_bits_in_thin_walls_too) {
  for (const char* name : {"cube", "thin-wall-1e-3", "thin-wall-1e-9"}) {
    const Cage cage = embedded_cage(name);
    const CoordinateKind& kind = coordinate_kind_named("mean_value");
    const CageTerms terms(cage, kind, Triangulation::Shortest);
    const CageLocator locator(cage, Triangulation::Shortest);
    std::array<CageError, 2> worst{CageError{0, 0}, CageError{0, 0}};
    for (const CagePoint& p : points_off(cage, locator, 1, 60)) {
      if (p.place == Place::TooClose) continue;
      for (int i = 0; i < 2; ++i) {
        const CageCoordinates coordinates(cage, kind, i == 0 ? "closed_form" : "lossy", Triangulation::Shortest);
        const CageError error = errors_at(coordinates, cage, p.point, 1, 0, &terms).reproduction[0];
        worst[i].roundings = std::max(worst[i].roundings, error.roundings);
        worst[i].relative = std::max(worst[i].relative, error.relative);
      }
    }
    EXPECT_LT(worst[0].roundings, 16) << name;
    EXPECT_GT(worst[1].roundings, 64) << name;
    // The error that the wall itself causes.
    EXPECT_EQ(worst[0].relative > 1e-12, std::string_view(name) == "thin-wall-1e-9") << name;
  }
}

// A cube whose middle part overlaps itself: two cubes that cross are one surface with number 2 where they overlap.
Cage two_cubes() {
  const Cage cube = embedded_cage("cube");
  std::vector<Vec> vertices = cube.vertices();
  std::vector<Face> faces = cube.faces();
  for (const auto& v : cube.vertices()) vertices.push_back(v + Vec(0.5, 0.25, 0.125));
  for (Face face : cube.faces()) {
    for (int& v : face.vertices) v += 8;
    faces.push_back(face);
  }
  return Cage::make("two cubes", vertices, faces);
}

// A corner of the second cube is pulled into the first: its quads are twisted, and wind twice where their triangles
// wind once.
TEST(cage_errors, expect_the_winding_number_of_quads_where_twisted_ones_overlap) {
  std::vector<Vec> vertices;
  for (const double first : {-1.0, 0.0})
    for (const double z : {0.0, 2.0})
      for (const double y : {0.0, 2.0})
        for (const double x : {0.0, 2.0}) vertices.emplace_back(Vec(x, y, z) + Vec::Constant(first));
  vertices[8] = Vec(-0.5, 0, 0);
  std::vector<Face> faces;
  for (const int k : {0, 8})
    for (const std::array<int, 4>& f :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
      faces.push_back({{f[0] + k, f[1] + k, f[2] + k, f[3] + k}});
  const Cage cage = Cage::make("twisted", vertices, faces);
  const Vec point(-0.1, 0.8, 0.85);
  EXPECT_EQ(CageLocator(cage, Triangulation::Shortest).winding(point), 1);
  EXPECT_EQ(CageLocator(cage, Triangulation::Shortest, true).winding(point), 2);
}

TEST(cage_errors, expect_the_winding_number_where_parts_overlap) {
  const Cage both = two_cubes();
  EXPECT_TRUE(crossing_warning(both));
  const CageLocator locator(both, Triangulation::Shortest);
  EXPECT_EQ(locator.winding(Vec(0.25, 0.125, 0.0625)), 2);
  EXPECT_EQ(locator.winding(Vec(-0.25, 0.125, 0.0625)), 1);
  EXPECT_EQ(locator.place(Vec(0.25, 0.125, 0.0625)), Place::Inside);
  CageCampaignOptions options;
  options.points = 40;
  options.truth_points = 2;
  for (const ResultRow& row : run_cage_campaign(both, options))
    EXPECT_NE(row.verdict, Verdict::Broken) << row.subject << ' ' << row.check << ' ' << row.place << ' ' << row.max;
}

// A corner of one cube amid a face of the other: there is no inside that both have.
TEST(cage_errors, ask_for_no_limits_where_a_corner_touches_a_face) {
  const Cage cube = embedded_cage("cube");
  std::vector<Vec> vertices = cube.vertices();
  std::vector<Face> faces = cube.faces();
  // Its lowest corner is amid the upper side, the others above it.
  const double top = vertices[0].cwiseAbs()[2];
  for (const Vec& v : cube.vertices()) {
    const Vec turned = Vec(1, 2, 4).cwiseProduct(v + Vec::Constant(top));
    vertices.emplace_back(turned[0] - turned[1] / 4, turned[1] - turned[2] / 4, top + turned.sum());
  }
  for (Face face : cube.faces()) {
    for (int& v : face.vertices) v += 8;
    faces.push_back(face);
  }
  const Cage both = Cage::make("touching", vertices, faces);
  ASSERT_TRUE(crossing_warning(both));
  CageCampaignOptions options;
  options.kinds = "green,mean_value";
  options.points = 12;
  options.differences = false;
  for (const ResultRow& row : run_cage_campaign(both, options)) {
    if (row.place != "on-vertex" && row.place != "on-face") continue;
    EXPECT_NE(row.verdict, Verdict::Broken) << row.subject << ' ' << row.check << ' ' << row.place << ' ' << row.max;
  }
}

// On faces within the cage sums are twice what they are on others, of evaluations that take limits from inside.
TEST(cage_errors, ask_for_no_limits_on_faces_that_overlap) {
  const Cage both = two_cubes();
  for (const char* kind : {"green", "biharmonic"}) {
    CageCampaignOptions options;
    options.kinds = kind;
    options.evaluation = "batched";
    options.points = 12;
    options.differences = false;
    std::size_t on = 0;
    for (const ResultRow& row : run_cage_campaign(both, options)) {
      EXPECT_NE(row.verdict, Verdict::Broken) << row.subject << ' ' << row.check << ' ' << row.place << ' ' << row.max;
      on += row.place == "on-face" && row.check == "linear_reproduction" ? row.samples : 0;
    }
    EXPECT_GT(on, 10u) << kind;
  }
}

}  // namespace
}  // namespace cageproof::validation
