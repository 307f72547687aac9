// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/merged_vertices.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "support.h"

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;

// The embedded cube with one vertex per corner of each face, each moved by so much.
Mesh corners_apart(double by) {
  const Cage cage = embedded_cage("cube");
  Mesh mesh;
  for (const Face& face : cage.faces()) {
    std::vector<int>& polygon = mesh.faces.emplace_back();
    for (int k = 0; k < face.size(); ++k) {
      polygon.push_back(static_cast<int>(mesh.vertices.size()));
      const double step = mesh.vertices.size() % 2 == 0 ? by : -by;
      mesh.vertices.emplace_back(cage.vertices()[face.vertices[k]] + Vec3<double>::Constant(step));
    }
  }
  return mesh;
}

TEST(MergedVertices, are_one_a_place) {
  for (const double by : {0.0, 1e-3}) {
    const Mesh apart = corners_apart(by);
    const Merging merging = merging_of(apart.vertices, 4 * by);
    EXPECT_EQ(merging.first.size(), 8U);
    const Mesh one = merged(apart, merging, "apart.obj");
    ASSERT_EQ(one.warnings.size(), 1U);
    expect_parts(one.warnings[0], {"apart.obj: ", std::to_string(apart.vertices.size()), " vertices are merged to 8"});
    const Cage cage = cage_from(one, "apart.obj");
    EXPECT_NEAR(testing_support::volume(cage), 1, 10 * by + 1e-15);
    EXPECT_EQ(cage.faces().size(), embedded_cage("cube").faces().size());
  }
  // Nothing is near enough.
  const Mesh apart = corners_apart(1e-3);
  EXPECT_GT(merging_of(apart.vertices, 1e-4).first.size(), 8U);
}

TEST(MergedVertices, connect_in_chains_at_any_unit) {
  for (const double unit : {1e-200, 1.0, 1e200}) {
    std::vector<Vec3<double>> vertices;
    vertices.reserve(6);
    for (int k = 0; k < 5; ++k) vertices.emplace_back(unit * Vec3<double>(k, 0, 0));
    vertices.emplace_back(unit * Vec3<double>(5.5, 0, 0));
    const Merging merging = merging_of(vertices, unit);
    EXPECT_EQ(merging.number, (std::vector<int>{0, 0, 0, 0, 0, 1})) << unit;
    EXPECT_EQ(merging.first, (std::vector<int>{0, 5})) << unit;
  }
  // Zeros of either sign are one place.
  EXPECT_EQ(merging_of({{0.0, 0, 0}, {-0.0, 0, 0}}, 0).first.size(), 1U);
}

TEST(MergedVertices, leave_out_what_has_no_size) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {0, 1, 2}}, {11, 12}};
  const Mesh found = merged(mesh, merging_of(mesh.vertices, 1e-6), "m.obj");
  EXPECT_EQ(found.faces, (std::vector<std::vector<int>>{{0, 1, 2}}));
  EXPECT_EQ(found.face_lines, std::vector<std::size_t>{11});
  expect_parts(found.warnings[0], {"4 vertices are merged to 3", "1 element without size is left out"});
}

TEST(MergedVertices, of_a_pose_must_stay_together) {
  Mesh apart = corners_apart(0);
  const Merging merging = merging_of(apart.vertices, 0);
  std::vector<Vec3<double>> posed = apart.vertices;
  for (Vec3<double>& v : posed) v = 2 * v + Vec3<double>(1, 2, 3);
  EXPECT_EQ(merged_pose(posed, merging, 0, "posed.obj").size(), 8U);
  const int last = static_cast<int>(posed.size()) - 1;
  posed[last][0] += 0.25;
  expect_parts(input_error_of([&] { merged_pose(posed, merging, 0, "posed.obj"); }),
               {"posed.obj: vertices ", " and " + std::to_string(last), "0.25 apart", "--merge"});
  posed.pop_back();
  expect_parts(input_error_of([&] { merged_pose(posed, merging, 0, "posed.obj"); }),
               {"posed.obj", std::to_string(last) + " vertices", "before --merge"});
}

}  // namespace
}  // namespace cageproof
