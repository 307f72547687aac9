// SPDX-License-Identifier: MIT
// Surfaces whose parts meet in edges and vertices.
#include "cageproof/core/cage/cage.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "support.h"

#include <algorithm>
#include <array>

namespace cageproof {
namespace {

using testing_support::expect_parts;
using testing_support::input_error_of;

// Boxes of quads by their low and high corners, with one vertex per place.
struct Boxes {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;

  void add(const std::array<double, 3>& low, const std::array<double, 3>& high, bool inward = false) {
    const auto vertex = [&](int x, int y, int z) {
      const Vec3<double> at(x ? high[0] : low[0], y ? high[1] : low[1], z ? high[2] : low[2]);
      const auto found = std::ranges::find(vertices, at);
      if (found != vertices.end()) return static_cast<int>(found - vertices.begin());
      vertices.push_back(at);
      return static_cast<int>(vertices.size()) - 1;
    };
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Face face;
        for (int k = 0; k < 4; ++k) {
          std::array<int, 3> corner{};
          corner[axis] = side;
          corner[(axis + 1) % 3] = k == 1 || k == 2;
          corner[(axis + 2) % 3] = k >= 2;
          face.vertices[k] = vertex(corner[0], corner[1], corner[2]);
        }
        if ((side == 0) != inward) std::ranges::reverse(face.vertices);
        faces.push_back(face);
      }
  }
  Cage cage(CageOptions options = {}) const { return Cage::make("boxes", vertices, faces, std::move(options)); }
};

TEST(CageMeeting, cubes_may_share_an_edge_or_a_vertex) {
  Boxes at_edge, at_vertex, apart;
  at_edge.add({0, 0, 0}, {1, 1, 1});
  at_edge.add({1, 1, 0}, {2, 2, 1});
  ASSERT_EQ(at_edge.vertices.size(), 14U);
  expect_parts(meeting_warning(at_edge.cage()).value(), {"boxes: ", "1 edge (the first between vertices", "manifold"});
  at_vertex.add({0, 0, 0}, {1, 1, 1});
  at_vertex.add({1, 1, 1}, {2, 2, 2});
  ASSERT_EQ(at_vertex.vertices.size(), 15U);
  expect_parts(meeting_warning(at_vertex.cage()).value(), {"1 vertex (the first is"});
  apart.add({0, 0, 0}, {1, 1, 1});
  apart.add({2, 2, 2}, {3, 3, 3});
  EXPECT_FALSE(meeting_warning(apart.cage()));
  EXPECT_FALSE(meeting_warning(embedded_cage("icosphere")));
}

TEST(CageMeeting, parts_that_share_an_edge_are_turned_by_themselves) {
  Boxes boxes;
  boxes.add({0, 0, 0}, {1, 1, 1});
  boxes.add({1, 1, 0}, {2, 2, 1}, true);
  expect_parts(input_error_of([&] { boxes.cage(); }), {"face 6", "inward", "--flip-inward"});
  Boxes right;
  right.add({0, 0, 0}, {1, 1, 1});
  right.add({1, 1, 0}, {2, 2, 1});
  EXPECT_DOUBLE_EQ(testing_support::volume(boxes.cage({.flip_inward = true})), 2);
  EXPECT_DOUBLE_EQ(testing_support::volume(right.cage()), 2);
}

TEST(CageMeeting, a_cavity_may_touch_its_shell_in_a_vertex) {
  // A tetrahedron whose apex is a corner of the box.
  Boxes boxes;
  boxes.add({0, 0, 0}, {4, 4, 4});
  const int base = static_cast<int>(boxes.vertices.size());
  const auto corner =
      static_cast<int>(std::ranges::find(boxes.vertices, Vec3<double>(0, 0, 0)) - boxes.vertices.begin());
  for (const Vec3<double>& v : {Vec3<double>(2, 1, 1), Vec3<double>(1, 2, 1), Vec3<double>(1, 1, 2)})
    boxes.vertices.push_back(v);
  boxes.faces.push_back({{base, base + 2, base + 1, -1}});
  boxes.faces.push_back({{corner, base, base + 1, -1}});
  boxes.faces.push_back({{corner, base + 1, base + 2, -1}});
  boxes.faces.push_back({{corner, base + 2, base, -1}});
  const Cage cage = boxes.cage();
  EXPECT_LT(testing_support::volume(cage), 64);
  expect_parts(meeting_warning(cage).value(), {"1 vertex"});
}

TEST(CageMeeting, boxes_may_share_walls_which_are_there_twice) {
  for (int inward = -1; inward < 4; ++inward) {
    Boxes boxes;
    int count = 0;
    for (const double x : {0., 1.})
      for (const double y : {0., 1.}) boxes.add({x, y, 0}, {x + 1, y + 1, 1}, count++ == inward);
    if (inward < 0) EXPECT_DOUBLE_EQ(testing_support::volume(boxes.cage()), 4);
    // Its walls are then those of its neighbours, turned the same way.
    else expect_parts(input_error_of([&] { boxes.cage(); }), {"has the vertices of face", "twice"});
  }
}

// Wedges of a right angle or less about the axis of z, apart from each other, as prisms of triangles.
TEST(CageMeeting, wedges_about_one_edge_are_parts_whatever_their_order) {
  constexpr std::array<std::array<int, 4>, 3> tips{{{{2, 0, 2, 1}}, {{0, 3, -1, 3}}, {{-1, -1, 1, -2}}}};
  std::array<int, 3> order{0, 1, 2};
  do {
    Boxes boxes;
    boxes.vertices = {{0, 0, 0}, {0, 0, 1}};
    for (const int wedge : order) {
      const int first = static_cast<int>(boxes.vertices.size());
      for (const int at : {0, 2})
        for (const double z : {0., 1.}) boxes.vertices.emplace_back(tips[wedge][at], tips[wedge][at + 1], z);
      const int a = first, b = first + 2;
      boxes.faces.push_back({{0, b, a, -1}});
      boxes.faces.push_back({{1, a + 1, b + 1, -1}});
      boxes.faces.push_back({{0, a, a + 1, 1}});
      boxes.faces.push_back({{a, b, b + 1, a + 1}});
      boxes.faces.push_back({{b, 0, 1, b + 1}});
    }
    EXPECT_NEAR(testing_support::volume(boxes.cage()), (2 + 3 + 3) / 2., 1e-14);
    // One is turned inside out.
    for (int f = 5; f < 10; ++f)
      std::reverse(boxes.faces[f].vertices.begin(), boxes.faces[f].vertices.begin() + boxes.faces[f].size());
    expect_parts(input_error_of([&] { boxes.cage(); }), {"face 5", "inward"});
  } while (std::ranges::next_permutation(order).found);
}

}  // namespace
}  // namespace cageproof
