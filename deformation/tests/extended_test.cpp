// SPDX-License-Identifier: MIT
// Green coordinates continued through a face, against the polynomial through images inside, in 50 digits: a harmonic
// map is analytic, and a polynomial through its values on a line comes near to what it is beyond.
#include "support.h"

#include "cageproof/deformation/point_images.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cageproof::deformation::test {
namespace {

PointImages extended(const CageCoordinates& coordinates, std::span<const Vec> points, const Posed<double>& posed,
                     int order) {
  ImageRun run{order, 1};
  run.extend = true;
  const std::array maps{&posed};
  return images_of(coordinates, points, maps, run, region_of(coordinates));
}

// The value at -`beyond` of the polynomial through Chebyshev points of [0, length], component by component.
template <class F>
Vec extrapolated(F&& inside, double length, double beyond) {
  constexpr int n = 44;
  std::vector<Mp50> nodes;
  std::vector<Vec3<Mp50>> values;
  for (int k = 0; k < n; ++k) {
    nodes.emplace_back(length / 2 * (1 - std::cos((2 * k + 1) * std::numbers::pi / (2 * n))));
    values.push_back(inside(nodes.back()));
  }
  Vec3<Mp50> sum = Vec3<Mp50>::Zero();
  for (int k = 0; k < n; ++k) {
    Mp50 weight = 1;
    for (int j = 0; j < n; ++j)
      if (j != k) weight *= (Mp50(-beyond) - nodes[j]) / (nodes[k] - nodes[j]);
    sum += weight * values[k];
  }
  return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

TEST(Extended, is_what_is_inside_continued) {
  for (const Case& c : {cube(), square()}) {
    const int d = c.cage.dimension();
    const auto deformer = prepared(c.cage, "green");
    const auto wide = prepare_deformer<Mp50>(deform_method_named("green"), c.cage, {});
    Pose<Mp50> pose;
    for (const Vec& v : c.posed) pose.vertices.push_back(convert<Mp50>(v));
    const auto wide_posed = wide->pose(pose);
    const auto posed = deformer->pose({c.posed, {}});
    // Through a triangle of the cube's face, or the square's side, where its border is not near.
    const Vec place = d == 3 ? Vec(.1, -.17, .5) : Vec(.45, 1, 0), out = d == 3 ? Vec(0, 0, 1) : Vec(0, 1, 0);
    const double beyond = 0.05;
    const std::vector<Vec> points{place + beyond * out};
    const PointImages found = extended(deformer->coordinates(), points, *posed, 0);
    EXPECT_FALSE(found.missing[0]);
    const Vec expected = extrapolated(
        [&](const Mp50& depth) {
          const std::vector<Vec3<Mp50>> at{convert<Mp50>(place) - depth * convert<Mp50>(out)};
          const auto images = wide->images(*wide_posed, at, 0);
          Vec3<Mp50> image = Vec3<Mp50>::Zero();
          for (int i = 0; i < d; ++i) image[i] = images.tensors[0][i];
          return image;
        },
        0.12, beyond);
    const Vec image = vertices_of(found.maps[0], d)[0];
    EXPECT_NEAR((image - expected).norm(), 0, 1e-9) << c.name << ": " << image.transpose();
    // Without it the point has no image, and what the sum says there is far from it.
    const std::array maps{posed.get()};
    const PointImages without =
        images_of(deformer->coordinates(), points, maps, {0, 1}, region_of(deformer->coordinates()));
    EXPECT_TRUE(without.missing[0]);
    EXPECT_GT((vertices_of(without.maps[0], d)[0] - expected).norm(), 0.1);
  }
}

TEST(Extended, derivatives_are_those_of_images) {
  const Case c = cube();
  const auto deformer = prepared(c.cage, "green");
  const auto posed = deformer->pose({c.posed, {}});
  const Vec at(.2, .75, -.1);
  const double step = 1e-5;
  std::vector<Vec> points{at};
  for (int axis = 0; axis < 3; ++axis)
    for (const double by : {-step, step}) points.emplace_back(at + by * Vec::Unit(axis));
  const PointImages found = extended(deformer->coordinates(), points, *posed, 1);
  const std::vector<Vec> images = vertices_of(found.maps[0], 3);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(found.maps[0].tensors[1][static_cast<std::size_t>(i * 3 + axis)],
                  (images[2 + 2 * axis][i] - images[1 + 2 * axis][i]) / (2 * step), 1e-8);
}

TEST(Extended, keeps_similarities_everywhere) {
  const Case c = cube();
  const auto deformer = prepared(c.cage, "green");
  const Eigen::Matrix3d turn = 1.5 * Eigen::AngleAxisd(0.8, Vec(1, 2, -1).normalized()).toRotationMatrix();
  std::vector<Vec> pose;
  for (const Vec& v : c.cage.vertices()) pose.emplace_back(turn * v + Vec(3, 0, 1));
  const auto posed = deformer->pose({pose, {}});
  const std::vector<Vec> points{{.1, .2, .9}, {2, 3, -1}, {.7, .7, .7}, {-.51, 0, 0}, {40, 0, 1}, {.1, .1, .1}};
  const std::vector<Vec> images = vertices_of(extended(deformer->coordinates(), points, *posed, 0).maps[0], 3);
  for (std::size_t p = 0; p < points.size(); ++p)
    EXPECT_NEAR((images[p] - (turn * points[p] + Vec(3, 0, 1))).norm(), 0, 1e-13 * (1 + points[p].norm())) << p;
}

}  // namespace
}  // namespace cageproof::deformation::test
