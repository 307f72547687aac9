// SPDX-License-Identifier: MIT
// Scenes of errors show the errors of sums over the cage's triangles, which this file computes by itself.
#include "cageproof/validation/compared_fields.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

constexpr int kSide = 3;

Comparison comparison(std::vector<std::string> evaluations) {
  return {std::make_shared<const Cage>(embedded_cage("cube")), find_coordinate_kind("green"), std::move(evaluations)};
}

Vec3<double> point_of(const ImageField& field, std::size_t i) {
  const std::size_t nx = field.points[0], ny = field.points[1];
  const std::size_t x = i % nx, y = i / nx % ny, z = i / (nx * ny);
  const Vec3<double> step(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  return field.origin + field.spacing.cwiseProduct(step);
}

// Green coordinates of the cage by their definition: a single layer a triangle, and of each vertex the double layers of
// the corners that meet there.
template <Scalar R>
struct Layers {
  std::vector<R> psi, phi;
};

template <Scalar R>
Layers<R> layers(const Cage& cage, const std::string& evaluation, const Vec3<double>& point) {
  const Evaluation single = evaluation_named("triangle.single_layer", evaluation),
                   twice = evaluation_named("triangle.double_layer", evaluation);
  Layers<R> found;
  found.phi.assign(cage.vertices().size(), R(0));
  const auto split = cage.triangulate(Triangulation::Shortest);
  for (const auto& triangle : split.triangles) {
    Sample sample;
    for (const int v : triangle) sample.corners.push_back(cage.vertices()[v]);
    sample.point = point;
    found.psi.push_back(evaluate<R>(single, sample, 0).value[0]);
    const Result<R> corners = evaluate<R>(twice, sample, 0);
    for (int k = 0; k < 3; ++k) found.phi[triangle[k]] += corners.value[k];
  }
  return found;
}

Mp100 size_of(const std::vector<Mp100>& truth) {
  Mp100 squares = 0;
  for (const Mp100& x : truth) squares += x * x;
  return sqrt(squares);
}

double relative(const std::vector<double>& found, const std::vector<Mp100>& truth) {
  std::vector<Mp100> difference;
  for (std::size_t k = 0; k < truth.size(); ++k) difference.push_back(Mp100(found[k]) - truth[k]);
  return static_cast<double>(Mp100(size_of(difference) / size_of(truth)));
}

TEST(compared_field, shows_the_errors_that_sums_over_triangles_have) {
  const Comparison asked = comparison({"gauss-4", "closed_form"});
  const ImageField field = sampled(compared_field(asked, kSide), 0);
  ASSERT_EQ(field.arrays.size(), 5u);
  EXPECT_EQ(field.arrays[0].name, "gauss-4: relative error");
  EXPECT_EQ(field.arrays[1].name, "closed_form: relative error");
  EXPECT_EQ(field.arrays[4].name, "inside");
  for (int a = 0; a < 5; ++a) EXPECT_EQ(field.arrays[a].linear, a >= 2) << a;
  double largest = 0;
  for (std::size_t i = 0; i < kSide * kSide * kSide; ++i) {
    const Vec3<double> point = point_of(field, i);
    const Layers<Mp100> truth = layers<Mp100>(*asked.cage, "closed_form", point);
    const Layers<double> rule = layers<double>(*asked.cage, "gauss-4", point);
    const double expected = std::max(relative(rule.psi, truth.psi), relative(rule.phi, truth.phi));
    EXPECT_NEAR(field.arrays[0].values[i], expected, 1e-12 * expected + 1e-15) << i;
    EXPECT_LT(field.arrays[1].values[i], 1e-14) << i;
    largest = std::max(largest, expected);
    // Blocks by name, since their order is the kind's.
    for (const auto& [block, sizes] : {std::pair("psi", &truth.psi), std::pair("phi", &truth.phi)}) {
      const auto norm =
          std::ranges::find(field.arrays, fmt::format("truth: norm of {}", block), &ImageField::Array::name);
      ASSERT_NE(norm, field.arrays.end()) << block;
      EXPECT_DOUBLE_EQ(norm->values[i], static_cast<double>(size_of(*sizes))) << i;
    }
    // The cube is the box from -1/2 to 1/2, where the double layers of a point inside add up to one.
    const bool inside = point.cwiseAbs().maxCoeff() < 0.5;
    EXPECT_EQ(field.arrays[4].values[i], inside ? 1 : 0) << i;
    Mp100 sum = 0;
    for (const Mp100& phi : truth.phi) sum += phi;
    EXPECT_NEAR(static_cast<double>(sum), inside ? 1 : 0, 1e-30) << i;
  }
  EXPECT_GT(largest, 1e-3);
}

TEST(compared_field, says_what_it_is) {
  const FieldPlan plan = compared_field(comparison({"gauss-4", "closed_form"}), kSide);
  EXPECT_EQ(plan.field.name, "cube.green.side-by-side");
  const FieldFacts& facts = plan.field.facts;
  EXPECT_EQ(facts.at("cage"), "cube");
  EXPECT_EQ(facts.at("kind"), "green");
  EXPECT_EQ(facts.at("evaluations"), "gauss-4, closed_form");
  EXPECT_EQ(facts.at("triangulation"), "shortest");
  for (const char* fact : {"truth", "unit of length", "unit of errors"}) EXPECT_FALSE(facts.at(fact).empty()) << fact;
  EXPECT_THROW(sampled(compared_field(comparison({"nonsense"}), kSide), 1), InputError);
}

TEST(compared_field, is_one_layer_in_the_plane) {
  const Comparison asked{
      std::make_shared<const Cage>(embedded_cage("square")), find_coordinate_kind("green"), {"gauss-4"}};
  const ImageField field = sampled(compared_field(asked, 6), 0);
  EXPECT_EQ(field.points, (std::array{6, 6, 1}));
  EXPECT_EQ(std::ranges::count(field.arrays.back().values, 1.0), 16);
}

TEST(compared_mesh, measures_some_vertices_as_the_field_and_no_others) {
  const Comparison asked = comparison({"gauss-4"});
  const ImageField field = sampled(compared_field(asked, kSide), 0);
  Mesh mesh;
  for (std::size_t i = 0; i < 27; ++i) mesh.vertices.push_back(point_of(field, i));
  const MeshField found = compared_mesh(asked, mesh, 9, 2);
  EXPECT_EQ(found.name, "cube.green.side-by-side.mesh");
  EXPECT_EQ(found.facts, field.facts);
  ASSERT_EQ(found.arrays.size(), field.arrays.size());
  for (std::size_t a = 0; a < found.arrays.size(); ++a) {
    EXPECT_EQ(found.arrays[a].name, field.arrays[a].name);
    ASSERT_EQ(found.arrays[a].values.size(), 27u);
    for (std::size_t i = 0; i < 27; ++i) {
      if (i % 3 == 0) EXPECT_EQ(found.arrays[a].values[i], field.arrays[a].values[i]) << i;
      else EXPECT_TRUE(std::isnan(found.arrays[a].values[i])) << i;
    }
  }
}

TEST(scene_measurements, find_in_blocks_what_sampling_all_finds) {
  const Comparison asked = comparison({"gauss-4", "closed_form"});
  const ImageField field = sampled(compared_field(asked, kSide), 0);
  const auto mesh = std::make_shared<Mesh>();
  for (std::size_t i = 0; i < 27; ++i) mesh->vertices.push_back(point_of(field, i));
  const auto whole = whole_fields(measure_all(scene_measurements(asked, kSide, mesh, 9, 4), 2));
  ASSERT_EQ(whole.size(), 2u);
  const FieldPart &image = whole.at(4), &on_mesh = whole.at(5);
  const MeshField expected = compared_mesh(asked, *mesh, 9, 1);
  for (const FieldPart* part : {&image, &on_mesh}) {
    EXPECT_EQ(part->scene, "cube.green.side-by-side");
    EXPECT_EQ(part->cage, outline_name(*asked.cage));
    EXPECT_EQ(part->compared, (std::vector<std::string>{"gauss-4: relative error", "closed_form: relative error"}));
    EXPECT_EQ(part->shown, "gauss-4: relative error");
    EXPECT_EQ(part->image.facts, field.facts);
    const auto& arrays = part == &image ? field.arrays : expected.arrays;
    ASSERT_EQ(part->image.arrays.size(), arrays.size());
    for (std::size_t a = 0; a < arrays.size(); ++a) {
      EXPECT_EQ(part->image.arrays[a].linear, arrays[a].linear);
      ASSERT_EQ(part->image.arrays[a].values.size(), 27u);
      for (std::size_t i = 0; i < 27; ++i) {
        const double x = part->image.arrays[a].values[i], y = arrays[a].values[i];
        EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << a << ' ' << i;
      }
    }
  }
  EXPECT_EQ(image.mesh, "");
  EXPECT_NE(on_mesh.mesh, "");
}

TEST(telling_evaluations, are_those_that_all_formulas_have) {
  const Cage cube = embedded_cage("cube");
  const auto found = telling_evaluations(*find_coordinate_kind("green"), cube);
  EXPECT_GE(found.size(), 2u);
  for (const std::string& evaluation : found)
    for (const char* formula : {"triangle.single_layer", "triangle.double_layer"})
      EXPECT_NE(EvaluationRegister::instance().find(formula, evaluation), std::nullopt) << evaluation;
  EXPECT_TRUE(telling_evaluations(*find_coordinate_kind("harmonic"), cube).empty());
}

TEST(outline, is_the_cage_itself) {
  const Cage cube = embedded_cage("cube");
  const MeshField outline = outline_of(cube);
  EXPECT_EQ(outline.name, outline_name(cube));
  EXPECT_EQ(outline.vertices, cube.vertices());
  ASSERT_EQ(outline.faces.size(), 6u);
  for (const auto& face : outline.faces) EXPECT_EQ(face.size(), 4u);
  const auto found = outline_measurement(std::make_shared<const Cage>(cube))->measure(0);
  EXPECT_EQ(found.meshes.at(outline_name(cube)).faces, outline.faces);
}

}  // namespace
}  // namespace cageproof::validation
