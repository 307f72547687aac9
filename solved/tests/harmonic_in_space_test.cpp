// SPDX-License-Identifier: MIT
// Harmonic coordinates of cages in space: what holds for any scheme, and how far this one is from the truth.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "space_support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::harmonic_in_space_test {
namespace {

// Affine data have constant normal derivatives on each face, which the scheme contains: nothing but rounding is left.
TEST(harmonic_in_space, have_affine_precision_at_any_level) {
  for (const char* name : {"cube", "l-block", "twisted-bar", "spiky-box"})
    for (const int level : {0, 1}) {
      const CageCoordinates h = harmonic_at_level(embedded_cage(name), level);
      for (const Vec& p : inner_points(h.elements(), 4)) {
        const auto found = h.at<double>(p, 2)[0];
        Vec image = Vec::Zero();
        Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
        double one = 0, curvature = 0, terms = 1;
        for (int v = 0; v < h.blocks()[0].size; ++v) {
          const Vec& at = h.elements().vertices()[v];
          one += found.value[v];
          image += found.value[v] * at;
          for (int i = 0; i < 3; ++i) slope.col(i) += found.gradient[3 * v + i] * at;
          curvature += found.hessian[9 * v + 1];
          terms = std::max(terms, std::abs(found.hessian[9 * v + 1]));
        }
        EXPECT_NEAR(one, 1, 1e-13) << name;
        EXPECT_LT((image - p).norm(), 1e-13) << name;
        EXPECT_LT((slope - Eigen::Matrix3d::Identity()).norm(), 1e-10) << name;
        EXPECT_LT(std::abs(curvature), 1e-9 * terms) << name;
      }
    }
}

// By Fourier series: cube_series.py, which prints this table and shares nothing with the program.
struct Known {
  Vec point;
  std::vector<double> lambda;
};
const std::vector<Known>& of_the_cube() {
  static const std::vector<Known> all{{{0.1, 0.2, 0.3},
                                       {0.0392193496403, 0.0450744209502, 0.0770595777550, 0.0386466516546,
                                        0.1532763861510, 0.0624298432586, 0.1304446864538, 0.4538490841367}},
                                      {{0, 0, 0},
                                       {0.1902513782976, 0.1032495405675, 0.1032495405675, 0.1032495405675,
                                        0.1032495405675, 0.1032495405675, 0.1032495405675, 0.1902513782976}},
                                      {{-0.25, 0.125, 0.375},
                                       {0.0659934551945, 0.0090691218767, 0.0400558757664, 0.0098815471624,
                                        0.2802813180515, 0.0196561048773, 0.3636693509876, 0.2113932260836}},
                                      {{0.4, 0.4, -0.3},
                                       {0.0211707489560, 0.0746617619031, 0.0746617619031, 0.6295057272378,
                                        0.0016947646537, 0.0024727244872, 0.0024727244872, 0.1933597863719}},
                                      {{-0.4, 0.05, -0.35},
                                       {0.4239431582690, 0.0088727740710, 0.3479872839943, 0.0691967836657,
                                        0.0098320552836, 0.0073520123765, 0.1182375024531, 0.0145784298868}}};
  return all;
}

TEST(harmonic_in_space, converge_to_the_series_of_the_cube) {
  std::array<double, 3> errors{};
  double extrapolated = 0;
  std::array<CageCoordinates, 3> levels{harmonic_at_level(embedded_cage("cube"), 0),
                                        harmonic_at_level(embedded_cage("cube"), 1),
                                        harmonic_at_level(embedded_cage("cube"), 2)};
  for (const Known& known : of_the_cube()) {
    std::array<std::vector<double>, 3> found;
    for (int k = 0; k < 3; ++k) {
      found[k] = values_at(levels[k], known.point);
      errors[k] = std::max(errors[k], largest_difference(found[k], known.lambda));
    }
    if (&known != &of_the_cube().front()) continue;
    // The scheme is of second order: pieces of half the size have a quarter of the error.
    extrapolated = (4 * found[2][7] - found[1][7]) / 3 - known.lambda[7];
  }
  RecordProperty("errors", testing::PrintToString(errors) + testing::PrintToString(extrapolated));
  EXPECT_LT(errors[0], 2e-2);
  EXPECT_LT(errors[1], errors[0] / 3);
  EXPECT_LT(errors[2], errors[1] / 3);
  EXPECT_LT(std::abs(extrapolated), errors[2] / 3);
  EXPECT_GT(errors[2], 1e-7) << "a study of errors that has none";
}

// The polynomial's values at the vertices of finer and finer cages, which are affine between them.
TEST(harmonic_in_space, converge_to_harmonic_polynomials_on_finer_cages) {
  const std::vector<std::function<double(const Vec&)>> polynomials{
      [](const Vec& p) { return p[0] * p[1]; }, [](const Vec& p) { return p[0] * p[0] - p[2] * p[2]; },
      [](const Vec& p) { return p[0] * p[1] * p[2]; },
      [](const Vec& p) { return p[0] * p[0] * p[0] - 3 * p[0] * p[1] * p[1]; }};
  std::array<std::array<double, 3>, 4> errors{};
  for (int times = 0; times < 3; ++times) {
    const CageCoordinates h = harmonic_at_level(split_cage(embedded_cage("cube"), times), 0);
    for (const Known& known : of_the_cube()) {
      const std::vector<double> lambda = values_at(h, known.point);
      for (std::size_t k = 0; k < polynomials.size(); ++k) {
        double sum = -polynomials[k](known.point);
        for (std::size_t v = 0; v < lambda.size(); ++v) sum += lambda[v] * polynomials[k](h.elements().vertices()[v]);
        errors[k][times] = std::max(errors[k][times], std::abs(sum));
      }
    }
  }
  RecordProperty("errors", testing::PrintToString(errors));
  for (const std::array<double, 3>& error : errors) {
    EXPECT_GT(error[0], 1e-4);
    EXPECT_LT(error[1], error[0] / 2.5);
    EXPECT_LT(error[2], error[1] / 2.5);
  }
}

// A harmonic function is nowhere larger than its largest boundary value; the scheme's are to its error.
TEST(harmonic_in_space, are_between_zero_and_one_to_the_schemes_error) {
  std::array<double, 2> beyond{};
  for (const char* name : {"cube", "l-block", "spiky-box"})
    for (const int level : {0, 1}) {
      const CageCoordinates h = harmonic_at_level(embedded_cage(name), level);
      for (const Vec& p : inner_points(h.elements(), 6))
        for (const double x : values_at(h, p)) beyond[level] = std::max({beyond[level], -x, x - 1});
    }
  RecordProperty("beyond", testing::PrintToString(beyond));
  EXPECT_LT(beyond[0], 1e-2);
  EXPECT_LT(beyond[1], 5e-3);
}

TEST(harmonic_in_space, are_the_hat_functions_where_the_equation_is_asked_to_hold) {
  const Cage cage = embedded_cage("l-block");
  const CageCoordinates h = harmonic_at_level(cage, 1);
  double elsewhere = 0;
  for (const double third : {0.03125, 0.09375, 0.3125, 0.34375, 0.59375})
    for (int e = 0; e < static_cast<int>(h.elements().count()); ++e) {
      // 0.1875 and 0.625 of a piece of half the size; the others are between.
      const bool asked = third == 0.09375 || third == 0.3125;
      const Touching on{e, {1 - 0.09375 - third, 0.09375, third, 0}};
      const std::vector<double> found = h.limits_at<double>(std::span(&on, 1), 0)[0].tensors[0];
      std::vector<double> hats(found.size());
      for (int c = 0; c < 3; ++c) hats[h.elements().vertices_of(e)[c]] += on.basis[c];
      if (asked) EXPECT_LT(largest_difference(found, hats), 1e-13) << e << ' ' << third;
      elsewhere = std::max(elsewhere, largest_difference(found, hats));
    }
  RecordProperty("elsewhere", testing::PrintToString(elsewhere));
  EXPECT_LT(elsewhere, 3e-2);
  EXPECT_GT(elsewhere, 1e-6) << "a study of errors that has none";
}

TEST(harmonic_in_space, are_harmonic) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("spiky-box"), 0);
  for (const Vec& p : inner_points(h.elements(), 3)) {
    const auto found = h.at<double>(p, 2)[0];
    for (std::size_t i = 0; i < found.value.size(); ++i)
      EXPECT_NEAR(found.hessian[9 * i] + found.hessian[9 * i + 4] + found.hessian[9 * i + 8], 0, 1e-10);
  }
}

TEST(harmonic_in_space, say_what_was_solved) {
  const CageCoordinates h = harmonic_at_level(embedded_cage("cube"), 1);
  ASSERT_EQ(h.solved().size(), 1u);
  const SolvedSystem system = h.solved()[0];
  EXPECT_EQ(system.rows, 12 * 4 * 3);
  EXPECT_EQ(system.columns, system.rows);
  EXPECT_EQ(system.rank, system.rows);
  EXPECT_GT(system.condition, 20);
  EXPECT_LT(system.condition, 200);
  EXPECT_LT(system.residual, 1e-14);
}

std::string refusal(const Cage& cage, const std::vector<double>& parameters) {
  try {
    CageCoordinates(cage, coordinate_kind_named("harmonic"), CoordinateOptions{.parameters = parameters});
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(harmonic_in_space, refuse_what_they_cannot_do) {
  const Cage cube = embedded_cage("cube");
  EXPECT_NE(refusal(cube, {4, 1, 5}).find("36864 unknowns, more than 8192"), std::string::npos);
  EXPECT_NE(refusal(cube, {2, 1, 1}).find("pieces"), std::string::npos);
  EXPECT_NE(refusal(cube, {4, 0, 1}).find("collocation"), std::string::npos);
  EXPECT_NE(refusal(polygon(unit_square), {4, 1, 2}).find("level"), std::string::npos);
  EXPECT_EQ(refusal(cube, {4, 1, 0}), "");
  EXPECT_NE(refusal(embedded_cage("thin-box"), {4, 1, 0}).find("a wall is too thin"), std::string::npos);
  // Two cubes that share a corner's surroundings: Green coordinates sum to two on what lies within the other.
  std::vector<Vec> vertices = cube.vertices();
  std::vector<Face> faces = cube.faces();
  for (const Vec& v : cube.vertices()) vertices.push_back(v + Vec(0.5, 0.4375, 0.375));
  for (Face f : cube.faces()) {
    for (int k = 0; k < f.size(); ++k) f.vertices[k] += 8;
    faces.push_back(f);
  }
  EXPECT_NE(refusal(Cage::make("two", vertices, faces), {4, 1, 1}).find("overlaps itself"), std::string::npos);
  for (Vec& v : vertices) v *= 0x1p600;
  EXPECT_NE(refusal(Cage::make("vast", vertices, faces), {4, 1, 1}).find("range of double"), std::string::npos);
}

}  // namespace
}  // namespace cageproof::solved::test::harmonic_in_space_test
