// SPDX-License-Identifier: MIT
// Laws of deformers on quads that are kept: they keep similarities, linear maps by their own normal derivatives, and
// symmetries, and it does not matter at which corner a quad begins.
#include "quad_cases.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace cageproof::deformation::test::quad_laws_test {
namespace {

using Map = Eigen::Matrix3d;

Map rotation() {
  return (Eigen::AngleAxisd(0.7, Vec(1, 2, -1).normalized()) * Eigen::AngleAxisd(2.1, Vec::UnitX())).toRotationMatrix();
}

Map generic() {
  Map map;
  map << 1.3, .2, -.1, .05, .8, .3, -.2, .1, 1.1;
  return map;
}

// Next to a face, an edge and a corner, on a face and an edge and at a vertex, too.
std::vector<Vec> points_of(const Case& c) {
  const CageElements elements(c.cage, true, Triangulation::Shortest);
  const auto q = elements.corners(1);
  const Vec face = (q[0] + q[1] + q[2] + q[3]) / 4, edge = (q[0] + q[1]) / 2;
  std::vector<Vec> points = c.points;
  const auto towards = [&](const Vec& place, double by) { points.emplace_back(place + by * (c.points[0] - place)); };
  for (const double by : {1e-2, 1e-6, 1e-12}) {
    towards(face, by);
    towards(edge, by);
    towards(q[0], by);
  }
  for (const Vec& on : {face, edge, q[0]}) points.push_back(on);
  return points;
}

// The largest distance of images from where the map and a shift take the points, over the cage's size.
double error_of(const Case& c, const Deformer<double>& deformer, const Map& map) {
  const Vec shift(.3, -.2, .5);
  std::vector<Vec> posed;
  for (const Vec& v : c.cage.vertices()) posed.emplace_back(map * v + shift);
  const std::vector<Vec> points = points_of(c);
  const Images<double> images = deformed(deformer, posed, points);
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    keep_larger(worst, (image(images, p) - (map * points[p] + shift)).norm());
  return worst / c.size;
}

TEST(quad_laws, similarities_are_kept_and_what_is_not_is_not) {
  for (const Case& c : {integer_cube(), twisted_cube(), mixed_cage(), bar()})
    for (const auto& [method, parameters] : quad_deformers()) {
      const auto deformer = prepared(c.cage, method, parameters);
      const std::string text = c.name + ' ' + method + ' ' + std::to_string(parameters[1 % parameters.size()]);
      EXPECT_LT(error_of(c, *deformer, Map::Identity()), 1e-13) << text;
      EXPECT_LT(error_of(c, *deformer, rotation()), 1e-13) << text;
      const bool of_layers = std::string_view(method) == "quad_biharmonic_1_3",
                 loses_scale = (std::string_view(method) == "quad_green" && parameters[0] >= 3) ||
                               (of_layers && parameters[1] == 3);
      const double scale = error_of(c, *deformer, 1.5 * rotation());
      if (loses_scale) EXPECT_GT(scale, 1e-3) << text;
      else EXPECT_LT(scale, 1e-13) << text;
      EXPECT_GT(error_of(c, *deformer, Map(Vec(1, 1, -1).asDiagonal())), 1e-3) << text;
      EXPECT_GT(error_of(c, *deformer, generic()), 1e-3) << text;
    }
}

TEST(quad_laws, linear_maps_are_exact_with_their_own_normal_derivatives) {
  const Map map = generic();
  for (const Case& c : quad_cases())
    for (const char* method : {"quad_green", "quad_biharmonic_1_3"}) {
      const auto deformer = prepared(c.cage, method);
      const CageElements& elements = deformer->coordinates().elements();
      Pose<double> pose;
      for (const Vec& v : c.cage.vertices()) pose.vertices.emplace_back(map * v);
      for (std::size_t i = 0; i < elements.count(Owner::Normal); ++i)
        pose.normal_derivatives.emplace_back(map * elements.normal_of(i, Owner::Normal));
      const Images<double> images = deformer->images(*deformer->pose(pose), std::span<const Vec>(c.points), 1);
      for (std::size_t p = 0; p < c.points.size(); ++p) {
        EXPECT_LT((image(images, p) - map * c.points[p]).norm() / c.size, 1e-13) << c.name << method;
        for (int i = 0; i < 9; ++i) EXPECT_NEAR(images.tensors[1][9 * p + i], map(i / 3, i % 3), 1e-12) << method;
      }
      pose.normal_derivatives.pop_back();
      EXPECT_THROW(deformer->pose(pose), InputError) << method;
    }
}

// The largest difference between the image of a point's mirror image and the mirror image of its image.
double asymmetry(const Cage& cage, std::string_view method, const std::vector<Vec>& posed,
                 const std::vector<Vec>& points) {
  const Vec mirror(-1, 1, 1);
  std::vector<Vec> both = points;
  for (const Vec& p : points) both.emplace_back(mirror.cwiseProduct(p));
  const Images<double> images = deformed(*prepared(cage, method), posed, both);
  double worst = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    keep_larger(worst, (image(images, points.size() + p) - mirror.cwiseProduct(image(images, p))).norm());
  return worst / cage.size();
}

// The cube is symmetric in x, and so are its quads, but not the triangles that they are split in.
TEST(quad_laws, symmetric_poses_have_symmetric_images_of_quads_alone) {
  const Case c = cube();
  std::vector<Vec> posed = c.cage.vertices();
  for (Vec& v : posed)
    v = v[2] > 0 ? Vec(1.8 * v[0], .6 * v[1] + .1, v[2] - .1 * v[1]) : Vec(.7 * v[0], v[1], v[2] + .2 * v[1]);
  for (const char* method : {"green", "biharmonic_1_3", "somigliana"}) {
    EXPECT_LT(asymmetry(c.cage, std::string("quad_") + method, posed, c.points), 1e-14) << method;
    EXPECT_GT(asymmetry(c.cage, method, posed, c.points), 1e-3) << method;
  }
}

TEST(quad_laws, images_do_not_hang_on_a_quads_first_corner) {
  for (const Case& c : {twisted_cube(), mixed_cage()}) {
    std::vector<Face> faces = c.cage.faces();
    for (std::size_t f = 0; f < faces.size(); ++f)
      std::rotate(faces[f].vertices.begin(), faces[f].vertices.begin() + f % faces[f].size(),
                  faces[f].vertices.begin() + faces[f].size());
    const Cage other = Cage::make("turned", c.cage.vertices(), faces, {});
    for (const auto& [method, parameters] : quad_deformers()) {
      const auto here = deformed(*prepared(c.cage, method, parameters), c.posed, c.points),
                 there = deformed(*prepared(other, method, parameters), c.posed, c.points);
      for (std::size_t p = 0; p < c.points.size(); ++p)
        EXPECT_LT((image(here, p) - image(there, p)).norm() / c.size, 1e-14) << c.name << method;
    }
  }
}

// Cages of only triangles have no quad that could be kept, and the same images.
TEST(quad_laws, of_triangles_are_those_of_the_triangulated_deformers) {
  const Case c = cube();
  std::vector<Face> faces;
  for (const auto& t : c.cage.triangulate(Triangulation::Shortest).triangles) faces.push_back({{t[0], t[1], t[2], -1}});
  const Cage triangles = Cage::make("triangles", c.cage.vertices(), faces, {});
  for (const char* method : {"green", "biharmonic_1_3", "somigliana"}) {
    const auto plain = deformed(*prepared(triangles, method), c.posed, c.points),
               kept = deformed(*prepared(triangles, std::string("quad_") + method), c.posed, c.points);
    for (std::size_t p = 0; p < c.points.size(); ++p)
      EXPECT_LT((image(plain, p) - image(kept, p)).norm(), 1e-15) << method;
  }
}

TEST(quad_laws, methods_are_found_by_those_that_they_keep_the_quads_of) {
  for (const char* name : {"green", "biharmonic_1_3", "somigliana", "mean_value"})
    EXPECT_EQ(keeping_quads(deform_method_named(name)).name, std::string("quad_") + name);
  EXPECT_EQ(keeping_quads(deform_method_named("quad_green")).name, "quad_green");
  EXPECT_EQ(keeping_quads(deform_method_named("maximum_entropy")).name, "maximum_entropy");
  try {
    keeping_quads(deform_method_named("tp"));
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "tp: there is no such deformer of bilinear quads; there is of biharmonic_1_3, green, mean_value, "
              "somigliana");
  }
  EXPECT_EQ(why_refused(deform_method_named("quad_green"), square().cage), "polygons have no quads that could be kept");
}

}  // namespace
}  // namespace cageproof::deformation::test::quad_laws_test
