// SPDX-License-Identifier: MIT
// Cages whose faces cross: methods that solve for densities on the cage refuse those that overlap themselves, and name
// the faces.
#include "settings.h"

#include <set>

namespace cageproof::deformation::test {
namespace {

Cage two_cubes(const Vec& shift) {
  const Cage one = embedded_cage("cube");
  std::vector<Vec> vertices = one.vertices();
  std::vector<Face> faces = one.faces();
  for (const Vec& v : one.vertices()) vertices.push_back(v + shift);
  for (Face face : one.faces()) {
    for (int& v : face.vertices) v += static_cast<int>(one.vertices().size());
    faces.push_back(face);
  }
  return Cage::make("two cubes", vertices, faces);
}

// How long the cube's edges are.
double edge() { return embedded_cage("cube").size() / std::sqrt(3.); }

const std::set<std::string_view> solving{
    "aaap", "ahap", "tp", "biharmonic_1_2", "biharmonic_1_3", "biharmonic_weber", "quad_biharmonic_1_3"};

TEST(overlap, is_refused_by_what_solves_for_densities_and_by_nothing_else) {
  const Cage cage = two_cubes(edge() * Vec(.5, .25, .125));
  for (const DeformMethod& method : deform_methods()) {
    if (!exists_on(coordinate_kind_named(method.kind), cage)) continue;
    const std::string reason = why_refused(method, cage);
    EXPECT_EQ(reason.empty(), !solving.contains(method.name)) << method.name << reason;
    if (reason.empty()) continue;
    for (const char* part :
         {"the cage overlaps itself: faces ", " cross, and on face ", "sum to 2, not to 1", "a union"})
      EXPECT_NE(reason.find(part), std::string::npos) << reason;
  }
  for (const char* kind : {"regularised_1_2", "regularised_1_3", "regularised_weber"})
    EXPECT_FALSE(accepts(coordinate_kind_named(kind), cage)) << kind;
  EXPECT_TRUE(accepts(coordinate_kind_named("biharmonic"), cage));
}

TEST(overlap, of_a_corner_is_found_by_samples_that_reach_it) {
  const Cage cage = two_cubes(edge() * Vec(.95, .95, .95));
  ASSERT_TRUE(crossing_warning(cage));
  EXPECT_EQ(why_refused(deform_method_named("biharmonic_weber"), cage), "");
  EXPECT_EQ(refusal_of([&] { prepared(cage, "biharmonic_weber", {1, 0, 0}); }), "");
  const std::string finer = refusal_of([&] { prepared(cage, "biharmonic_weber", {4, 0, 0}); });
  EXPECT_NE(finer.find("the cage overlaps itself: on element "), std::string::npos) << finer;
}

TEST(overlap, is_none_where_faces_touch) {
  const Cage cage = two_cubes(edge() * Vec(1, 1, .5));
  ASSERT_TRUE(crossing_warning(cage));
  for (const std::string_view method : solving) EXPECT_EQ(why_refused(deform_method_named(method), cage), "") << method;
  EXPECT_EQ(refusal_of([&] { prepared(cage, "biharmonic_1_3"); }), "");
}

}  // namespace
}  // namespace cageproof::deformation::test
