// SPDX-License-Identifier: MIT
// Mean value coordinates of whole cages where their integrals would cancel: next to planes of faces beside these, and
// to lines of edges beyond their ends. Truth in 100 digits, by the judge's own units.
#include "cages/block_error.h"

#include "cageproof/core/cage/embedded_cages.h"

#include "thinned.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace cageproof::validation {
namespace {

void expect_kept(const CageCoordinates& coordinates, const BlockTruths& truths, const Vec3<double>& point,
                 const std::array<double, 3>& bounds = {64, 16, 16}) {
  const auto truth = truths.at(point, 2);
  ASSERT_TRUE(truth);
  for (int order = 0; order <= 2; ++order) {
    // Values without derivatives are computed in another way.
    const auto errors = block_errors(coordinates.at<double>(point, order), {truth->blocks, truth->moved, order});
    for (int o = 0; o <= order; ++o)
      EXPECT_LE(errors[o].roundings, bounds[o]) << "order " << o << " of " << order << " at " << point.transpose();
  }
}

// (1 - a - b, a, b) of each face's corners, moved along its normal by some heights.
void expect_kept(double a, double b, std::size_t least) {
  const Cage cage = embedded_cage("l-block");
  const CoordinateKind& kind = coordinate_kind_named("mean_value");
  const CageCoordinates coordinates(cage, kind, CoordinateOptions{.evaluation = "batched"});
  const BlockTruths truths(cage, kind, Triangulation::Shortest);
  const CageElements& elements = coordinates.elements();
  std::size_t asked = 0;
  // Faces take turns with heights where not all are asked.
  for (std::size_t f = 0; f < elements.count(); ++f)
    for (const double height :
         thinned<double>({0., 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 2.1e-3, 4e-3, 0.01, 0.03, 0.1, 0.3}, f)) {
      const auto k = elements.corners(f);
      const Vec3<double> point = k[0] + a * (k[1] - k[0]) + b * (k[2] - k[0]) + height * elements.normals()[f];
      if (!elements.touching(point).empty()) continue;
      expect_kept(coordinates, truths, point);
      ++asked;
    }
  EXPECT_GE(asked, least / test_stride());
}

TEST(BatchedMeanValues, next_to_planes_of_faces) { expect_kept(1.375, 0.8125, 120); }
TEST(BatchedMeanValues, near_the_border_in_planes_of_faces) { expect_kept(1.015625, 0.25, 120); }
TEST(BatchedMeanValues, beyond_ends_of_edges) { expect_kept(1.375, 0, 120); }
// Points in and near the plane of slivers of 1e-5, in which a fan splits the faces around a bump: hat functions of 1e5
// share out F/d there.
TEST(BatchedMeanValues, beside_slivers) {
  const Cage cage = embedded_cage("bump-1e-5");
  const CoordinateKind& kind = coordinate_kind_named("mean_value");
  const CageCoordinates coordinates(cage, kind, "batched", Triangulation::Fan);
  const BlockTruths truths(cage, kind, Triangulation::Fan);
  for (const double height : {1e-4, 1.75e-3, 0.01})
    for (const auto& [x, y] : {std::pair{0.495, -0.16}, {0.2, 0.45}, {-0.4, 0.3}, {0.1, -0.3}}) {
      const Vec3<double> point(x, y, 0.5 - height);
      const auto truth = truths.at(point, 0);
      ASSERT_TRUE(truth);
      const auto errors = block_errors(coordinates.at<double>(point, 0), {truth->blocks, truth->moved, 0});
      EXPECT_LE(errors[0].roundings, 64) << point.transpose();
    }
}

// Points exactly in the plane of a face, across its border: projections to its neighbour's plane lie on the edge.
TEST(BatchedMeanValues, across_edges_in_planes_of_faces) {
  for (const char* name : {"cube", "l-block"}) {
    const Cage cage = embedded_cage(name);
    const CoordinateKind& kind = coordinate_kind_named("mean_value");
    const CageCoordinates coordinates(cage, kind, CoordinateOptions{.evaluation = "batched"});
    const BlockTruths truths(cage, kind, Triangulation::Shortest);
    const CageElements& elements = coordinates.elements();
    int asked = 0;
    for (std::size_t f = 0; f < elements.count(); f += 3)
      for (const double distance : {0x1p-29, 0x1p-20, 0x1p-14, 0x1p-11, 0x1p-8, 0x1p-4})
        for (int e = 0; e < 3; ++e) {
          const auto k = elements.corners(f);
          const Vec3<double> along = k[(e + 1) % 3] - k[e];
          const Vec3<double> point =
              k[e] + 0.25 * along + distance * along.cross(elements.normals()[f]) / along.squaredNorm();
          if (!elements.touching(point).empty()) continue;
          expect_kept(coordinates, truths, point);
          ++asked;
        }
    EXPECT_GE(asked, 24) << name;
  }
}

// Points low over the long faces of a bar, and next to them.
TEST(BatchedMeanValues, beside_a_bar) {
  std::vector<Vec3<double>> vertices = embedded_cage("cube").vertices();
  const Vec3<double> low = vertices.front();
  for (Vec3<double>& v : vertices) v = (v - low).cwiseProduct(Vec3<double>(1, 0.1, 0.1));
  const Cage bar = embedded_cage("cube").with(vertices, embedded_cage("cube").faces());
  const CoordinateKind& kind = coordinate_kind_named("mean_value");
  const CageCoordinates coordinates(bar, kind, CoordinateOptions{.evaluation = "batched"});
  const BlockTruths truths(bar, kind, Triangulation::Shortest);
  for (const double beside : {0.2, 0.545, 0.8})
    for (const double height : {1e-6, 1e-3, 0.003, 0.01, 0.03})
      for (const double along : {0.319, 0.5, 1.2}) {
        expect_kept(coordinates, truths, {along, beside, height});
        expect_kept(coordinates, truths, {along, beside, 0.1 + height});
        expect_kept(coordinates, truths, {along, -height, -beside});
      }
}

// Two faces that nearly lie on each other, in no coordinate plane: next to their edge, to its ends and to the faces,
// outside, and between them.
TEST(BatchedMeanValues, oblique_walls_and_flat_tetrahedra) {
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Vec3<double>(1, 2, 3).normalized())).toRotationMatrix();
  const std::vector<Face> tetrahedron{{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{0, 3, 2, -1}}};
  const CoordinateKind& kind = coordinate_kind_named("mean_value");
  for (const double thickness : {0.1, 1e-3, 1e-5, 1e-7}) {
    std::vector<Vec3<double>> wall = embedded_cage("cube").vertices();
    const Vec3<double> low = wall.front(), shift(0.3, -0.2, 0.1);
    for (Vec3<double>& v : wall) v = turn * (v - low).cwiseProduct(Vec3<double>(1, 1, thickness)) + shift;
    std::vector<Vec3<double>> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, thickness}};
    for (Vec3<double>& v : flat) v = turn * v + shift;
    for (const Cage& cage : {embedded_cage("cube").with(wall, embedded_cage("cube").faces()),
                             Cage::make("flat", flat, tetrahedron, {.flip_inward = true})}) {
      const CageCoordinates coordinates(cage, kind, CoordinateOptions{.evaluation = "batched"});
      const BlockTruths truths(cage, kind, Triangulation::Shortest);
      const CageElements& elements = coordinates.elements();
      for (std::size_t f = 0; f < elements.count(); f += 3)
        for (const double height : {0.25 * thickness, -0.3 * thickness, 3e-8, 1e-4, 0.2})
          for (const auto& [a, b] : {std::pair{0.3, 0.4}, {0.3, 0.002}, {0.3, -1e-5}, {0.002, 0.003}, {-1e-8, 2e-8}}) {
            const auto k = elements.corners(f);
            const Vec3<double> point = k[0] + a * (k[1] - k[0]) + b * (k[2] - k[0]) + height * elements.normals()[f];
            SCOPED_TRACE(testing::Message() << cage.name() << " of thickness " << thickness << ", " << height
                                            << " over (" << a << ", " << b << ") of face " << f);
            if (elements.touching(point).empty()) expect_kept(coordinates, truths, point, {64, 32, 32});
          }
    }
  }
}

// In the plane: next to sides and vertices, on lines of sides beyond their ends, on integers, and outside.
TEST(BatchedMeanValues, of_polygons) {
  const CoordinateKind& kind = coordinate_kind_named("mean_value");
  for (const char* name : {"square", "l-shape", "comb", "thin-bar"}) {
    const Cage cage = embedded_cage(name);
    const CageCoordinates coordinates(cage, kind, CoordinateOptions{.evaluation = "batched"});
    const BlockTruths truths(cage, kind, Triangulation::Shortest);
    const std::vector<Vec3<double>>& corner = cage.vertices();
    int asked = 0;
    for (const Face& side : cage.faces())
      for (const double along : {-1., 0., 0.375, 1., 1.5})
        for (const double across : {-0.5, -1e-2, -1e-6, -1e-12, 0., 1e-15, 1e-9, 1e-4, 0.1}) {
          const Vec3<double>&a = corner[side.vertices[0]], &b = corner[side.vertices[1]], e = b - a;
          const Vec3<double> point = a + along * e + across * Vec3<double>(e[1], -e[0], 0);
          if (!coordinates.elements().touching(point).empty()) continue;
          SCOPED_TRACE(testing::Message() << name << ", " << along << " along a side, " << across << " across");
          expect_kept(coordinates, truths, point, {64, 32, 32});
          ++asked;
        }
    EXPECT_GE(asked, 100) << name;
  }
}

TEST(BatchedMeanValues, within_faces_near_their_border) { expect_kept(0.5, 0.015625, 120); }

}  // namespace
}  // namespace cageproof::validation
