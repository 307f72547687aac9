// SPDX-License-Identifier: MIT
// Similarities, mirror images and linear maps that each deformer keeps or does not keep.
#include "support.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cageproof::deformation::test::laws_test {
namespace {

using Map = Eigen::Matrix3d;

constexpr double kUnit = 3, kHard = 0, kFree = 2, kNonNegative = 3;

// Columns (1.3, .05, -.2), (.2, .8, .1), (-.1, .3, 1.1).
Map generic() {
  Map map;
  map << 1.3, .2, -.1, .05, .8, .3, -.2, .1, 1.1;
  return map;
}

Map rotation() {
  return (Eigen::AngleAxisd(0.7, Vec(1, 2, -1).normalized()) * Eigen::AngleAxisd(2.1, Vec::UnitX())).toRotationMatrix();
}

// The largest distance of images from where the map and a shift take the points, over the cage's size.
double error_of(const Case& c, const Deformer<double>& deformer, const Map& map) {
  const Vec shift = c.cage.dimension() == 2 ? Vec(.3, -.2, 0) : Vec(.3, -.2, .5);
  std::vector<Vec> posed;
  for (const Vec& v : c.cage.vertices()) posed.emplace_back(map * v + shift);
  const Images<double> images = deformed(deformer, posed, c.points);
  double worst = 0;
  for (std::size_t p = 0; p < c.points.size(); ++p)
    keep_larger(worst, (image(images, p, c.cage.dimension()) - (map * c.points[p] + shift)).norm());
  return worst / c.size;
}

struct Law {
  const char* method;
  std::vector<double> parameters;
  bool scale, mirror, linear;
};

void expect_laws(const Case& c, const std::vector<Law>& laws) {
  const Map turn = c.cage.dimension() == 2 ? Map(Eigen::AngleAxisd(0.7, Vec::UnitZ())) : rotation();
  const Map mirror = Vec(1, c.cage.dimension() == 2 ? -1 : 1, c.cage.dimension() == 2 ? 1 : -1).asDiagonal();
  Map linear = generic();
  if (c.cage.dimension() == 2) linear.row(2) = linear.col(2).transpose() = Vec(0, 0, 1).transpose();
  for (const Law& law : laws) {
    const auto deformer = prepared(c.cage, law.method, law.parameters);
    const auto expect = [&](const char* what, const Map& map, bool kept) {
      const double error = error_of(c, *deformer, map);
      // A deformer that keeps what it does not keep is another one.
      if (kept) {
        EXPECT_LT(error, 1e-13) << c.name << ' ' << law.method << ": " << what;
      } else {
        EXPECT_GT(error, 1e-3) << c.name << ' ' << law.method << ": " << what;
        EXPECT_LT(error, 1.2) << c.name << ' ' << law.method << ": " << what;
      }
    };
    expect("rigid", turn, true);
    expect("scale", 1.5 * Map::Identity(), law.scale);
    expect("mirror", mirror, law.mirror);
    expect("linear", linear, law.linear);
  }
}

TEST(laws, of_space_are_as_specified) {
  for (const Case& c : {cube(), bar()})
    expect_laws(c, {{"mean_value", {}, true, true, true},
                    {"quad_mean_value", {}, true, true, true},
                    {"green", {0}, true, false, false},
                    {"green", {1}, true, false, false},
                    {"green", {2}, true, false, false},
                    {"green", {kUnit}, false, false, false},
                    {"biharmonic_1_3", {}, false, false, false},
                    {"biharmonic_1_3", {1, 0, 1, 0}, true, false, false},
                    {"biharmonic_1_2", {}, false, false, false},
                    {"biharmonic_1_2", {1, 0}, true, false, false},
                    {"biharmonic_weber", {}, false, false, false},
                    {"biharmonic_weber", {1, 0}, true, false, false},
                    {"aaap", {1, 1, kHard, 1, 1}, true, true, false},
                    {"tp", {1, 1, kHard, 1, 1}, true, true, false},
                    {"ahap", {1, 1, kNonNegative, 1, 1}, true, false, false},
                    {"aaap", {1, 1, kNonNegative, 1, 1}, true, false, false},
                    {"tp", {1, 1, kNonNegative, 1, 1}, true, false, false},
                    {"aaap", {1, 1, kFree, 1, 1}, true, true, true},
                    {"tp", {1, 1, kFree, 1, 1}, true, true, true},
                    {"somigliana", {0, 0.3, 0, 0, 0.5}, true, false, false},
                    {"somigliana", {1, 0.3, 1, 0, 0.5}, true, false, false},
                    {"elastic", {4, 1, -0.5, 0}, true, true, true},
                    {"elastic", {4, 1, 0.45, 1}, true, true, true}});
}

TEST(laws, of_the_plane_are_as_specified) {
  for (const Case& c : {square(), l_shape(), pentagon()})
    expect_laws(c, {{"mean_value", {}, true, true, true},
                    {"green", {0}, true, false, false},
                    {"somigliana", {0, 0.3, 0, 0, 0.5}, true, false, false},
                    {"somigliana", {1, 0.3, 2, 0, 0.5}, true, false, false},
                    {"cauchy", {}, true, false, false},
                    {"elastic", {4, 1, -0.5, 1}, true, true, true},
                    {"elastic", {2, 3, 0.45, 1}, true, true, true},
                    {"biharmonic_boundary", {0, 1, 1, 1}, false, false, false},
                    {"biharmonic_boundary", {1, 1, 1, 1}, true, false, false},
                    {"biharmonic_boundary", {2, 1, 1, 1}, true, false, false},
                    {"biharmonic_boundary", {0, 4, 1, 0}, false, false, false},
                    {"biharmonic_boundary", {1, 4, 1, 0}, true, false, false},
                    {"biharmonic_boundary", {2, 4, 1, 0}, true, false, false},
                    {"biharmonic_1_3", {}, false, false, false},
                    {"biharmonic_1_3", {1, 0, 1, 0}, true, false, false},
                    {"biharmonic_weber", {1, 0}, true, false, false},
                    {"tp", {1, 1, kFree, 1, 1}, true, true, true}});
}

// Normal derivatives that are those of the map itself leave nothing to lose.
TEST(laws, linear_maps_are_exact_with_their_own_normal_derivatives) {
  const Case c = cube();
  const Map map = generic();
  for (const char* method : {"green", "biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber"}) {
    const auto deformer = prepared(c.cage, method);
    Pose<double> pose;
    for (const Vec& v : c.cage.vertices()) pose.vertices.emplace_back(map * v);
    for (const Vec& n : deformer->coordinates().elements().normals()) pose.normal_derivatives.emplace_back(map * n);
    const auto posed = deformer->pose(pose);
    const Images<double> images = deformer->images(*posed, std::span<const Vec>(c.points), 1);
    for (std::size_t p = 0; p < c.points.size(); ++p) {
      EXPECT_LT((image(images, p) - map * c.points[p]).norm(), 1e-13) << method;
      for (int i = 0; i < 9; ++i) EXPECT_NEAR(images.tensors[1][9 * p + i], map(i / 3, i % 3), 1e-12) << method;
    }
  }
}

// All coordinates by s acts as gamma_d by s^4; the unit-free weight does not see the unit, nor does Weber's.
TEST(laws, of_the_unit_of_length) {
  const Case c = cube();
  const double s = 4;
  const auto scaled = [&] {
    std::vector<Vec> vertices;
    for (const Vec& v : c.cage.vertices()) vertices.emplace_back(s * v);
    return Cage::make("large", vertices, c.cage.faces(), {});
  }();
  const auto difference = [&](const char* method, std::vector<double> small, std::vector<double> large) {
    const auto times = [&](std::vector<Vec> points) {
      for (Vec& p : points) p *= s;
      return points;
    };
    const Images<double> a = deformed(*prepared(c.cage, method, std::move(small)), c.posed, c.points),
                         b = deformed(*prepared(scaled, method, std::move(large)), times(c.posed), times(c.points));
    double worst = 0;
    for (std::size_t i = 0; i < a.tensors[0].size(); ++i)
      keep_larger(worst, std::abs(b.tensors[0][i] / s - a.tensors[0][i]));
    return worst / c.size;
  };
  EXPECT_LT(difference("biharmonic_1_3", {1, 3, std::pow(s, 4), 0}, {1, 3, 1, 0}), 1e-12);
  EXPECT_GT(difference("biharmonic_1_3", {1, 3, 1, 0}, {1, 3, 1, 0}), 1e-3);
  EXPECT_LT(difference("biharmonic_1_3", {1, 3, 1, 2}, {1, 3, 1, 2}), 1e-12);
  EXPECT_LT(difference("biharmonic_weber", {}, {}), 1e-12);
  EXPECT_GT(difference("biharmonic_1_2", {}, {}), 1e-3);
}

// Infinite nu: Green in the plane, not in space ([C23] Section 5).
TEST(laws, somigliana_of_infinite_nu_is_green_in_the_plane_alone) {
  for (const Case& c : {square(), l_shape(), pentagon(), cube()}) {
    const Images<double> green = deformed(*prepared(c.cage, "green", {1}), c.posed, c.points);
    for (const double variant : {0., 1.}) {
      const auto other = deformed(*prepared(c.cage, "somigliana", {variant, INFINITY, 0, 0, 0.5}), c.posed, c.points);
      double worst = 0;
      for (std::size_t i = 0; i < green.tensors[0].size(); ++i)
        keep_larger(worst, std::abs(other.tensors[0][i] - green.tensors[0][i]));
      if (c.cage.dimension() == 2) {
        EXPECT_LT(worst, 1e-12) << c.name << variant;
      } else {
        EXPECT_GT(worst / c.size, 5e-3) << variant;
      }
    }
  }
}

TEST(laws, gamma_zero_is_green_by_definition) {
  const Case c = cube();
  const auto green = deformed(*prepared(c.cage, "green", {kUnit}), c.posed, c.points),
             none = deformed(*prepared(c.cage, "biharmonic_1_3", {1, kUnit, 0, 0}), c.posed, c.points);
  for (std::size_t i = 0; i < green.tensors[0].size(); ++i) EXPECT_NEAR(green.tensors[0][i], none.tensors[0][i], 1e-15);
}

// Derivatives against differences of images.
TEST(laws, jacobians_and_hessians_are_those_of_the_images) {
  for (const Case& c : {cube(), l_shape()}) {
    const int d = c.cage.dimension();
    for (const char* method : {"mean_value", "green", "somigliana", "biharmonic_1_3"}) {
      const auto deformer = prepared(c.cage, method);
      const auto at = [&](const Vec& p, int order) { return deformed(*deformer, c.posed, {p}, order); };
      const Vec& p = c.points[0];
      const Images<double> here = at(p, 2);
      for (int i = 0; i < d; ++i) {
        const double h = 1e-5;
        const Images<double> after = at(p + h * Vec::Unit(i), 1), before = at(p - h * Vec::Unit(i), 1);
        for (int k = 0; k < d; ++k) {
          EXPECT_NEAR(here.tensors[1][k * d + i], (after.tensors[0][k] - before.tensors[0][k]) / (2 * h), 1e-8)
              << method;
          for (int j = 0; j < d; ++j)
            EXPECT_NEAR(here.tensors[2][(k * d + j) * d + i],
                        (after.tensors[1][k * d + j] - before.tensors[1][k * d + j]) / (2 * h), 1e-7)
                << method;
        }
      }
    }
  }
}

std::string refusal(const Case& c, const char* method, const std::vector<Vec>& posed,
                    std::vector<double> parameters = {}) {
  try {
    deformed(*prepared(c.cage, method, std::move(parameters)), posed, c.points);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(rejected, poses_and_parameters_by_name) {
  const Case c = cube();
  std::vector<Vec> few = c.posed, lost = c.posed, flat = c.posed;
  few.pop_back();
  lost[3][1] = NAN;
  EXPECT_NE(refusal(c, "green", few).find("7 vertices, the rest cage 8"), std::string::npos);
  EXPECT_NE(refusal(c, "mean_value", lost).find("vertex 3 is not finite"), std::string::npos);
  // Two corners of a face in one place.
  flat[1] = flat[0];
  for (const char* method : {"green", "biharmonic_1_3", "tp"})
    EXPECT_NE(refusal(c, method, flat).find("has no area"), std::string::npos) << method;
  EXPECT_EQ(refusal(c, "green", flat, {2}), "");
  EXPECT_EQ(refusal(c, "somigliana", flat), "");
  EXPECT_NE(refusal(c, "somigliana", flat, {1, 0.3, 0, 0, 0.5}).find("has no area"), std::string::npos);
  for (const double nu : {0.5, 1., -1., static_cast<double>(NAN)})
    EXPECT_NE(refusal(c, "somigliana", c.posed, {0, nu, 0, 0, 0.5}).find("nu"), std::string::npos) << nu;
  EXPECT_NE(refusal(c, "biharmonic_1_3", c.posed, {1, 3, -1, 0}).find("gamma_d"), std::string::npos);
  EXPECT_NE(refusal(square(), "maximum_entropy", square().posed).find("dimension"), std::string::npos);
}

// Rules know limits of values on the cage, and none of derivatives.
TEST(rejected, evaluations_without_limits) {
  const Case c = cube();
  const auto with = [&](const char* method, const char* evaluation) {
    return prepare_deformer<double>(deform_method_named(method), c.cage, {.evaluation = evaluation});
  };
  for (const char* method : {"biharmonic_1_2", "aaap", "tp"})
    EXPECT_THROW(with(method, "adaptive"), InputError) << method;
  EXPECT_THROW(with("biharmonic_1_3", "gauss-4"), InputError);
  EXPECT_NO_THROW(with("tp", "hybrid"));
  // Laplacians of layers are values of others.
  EXPECT_NO_THROW(with("ahap", "adaptive"));
}

// The cube's level 0 leaves two densities open.
TEST(reported, rank_condition_and_orientation) {
  const Case c = cube();
  const auto deficient = prepared(c.cage, "biharmonic_1_3", {0, 3, 1, 0})->prepared();
  ASSERT_EQ(deficient.systems.size(), 1u);
  EXPECT_EQ(deficient.systems[0].rank, 18);
  EXPECT_EQ(deficient.systems[0].columns, 20);
  EXPECT_FALSE(deficient.warnings.empty());
  const auto full = prepared(c.cage, "biharmonic_1_3")->prepared();
  EXPECT_FALSE(full.systems[0].is_singular());
  EXPECT_GT(full.systems[0].condition, 10);
  EXPECT_LT(full.systems[0].condition, 1e4);
  std::vector<Vec> mirrored = c.cage.vertices();
  for (Vec& v : mirrored) v[2] = -v[2];
  EXPECT_FALSE(prepared(c.cage, "tp")->pose({mirrored, {}})->report().warnings.empty());
}

}  // namespace
}  // namespace cageproof::deformation::test::laws_test
