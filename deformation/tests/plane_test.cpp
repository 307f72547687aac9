// SPDX-License-Identifier: MIT
// The plane's solved deformers ([W12] Section 5.1 to 5.3): reference numbers of the specification, which were computed
// elsewhere by other means, what is kept and what is not, and what is refused.
#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include <algorithm>

namespace cageproof::deformation::test::plane_test {
namespace {

constexpr double kUnit = 0, kComplex = 1, kAhap = 2;
constexpr double kVertices = 0, kMidpoints = 1;
constexpr double kDiameter = 0, kOwn = 1;

// In the paper's own setting, without new nodes.
std::vector<double> as_printed(double normals) { return {normals, 1, kMidpoints, kOwn}; }

struct Printed {
  Case of;
  Vec unit, complex, ahap;
  double laplacians;
};

std::vector<Printed> printed() {
  return {{square(),
           {0.260494204762, 0.704560751099, 0},
           {0.2696582354, 0.695539605809, 0},
           {0.281018809757, 0.656937801314, 0},
           52.42318579},
          {l_shape(),
           {0.512604897431, 0.48467868987, 0},
           {0.528262571361, 0.513209691952, 0},
           {0.553980327966, 0.49496586769, 0},
           2.66203534},
          {pentagon(),
           {1.04316822725, 0.996924215334, 0},
           {1.06923096948, 0.986440128432, 0},
           {1.00879324472, 1.00002422512, 0},
           3.280655012}};
}

TEST(plane, has_the_reference_numbers) {
  for (const Printed& p : printed())
    for (const auto& [normals, expected] :
         {std::pair{kUnit, p.unit}, std::pair{kComplex, p.complex}, std::pair{kAhap, p.ahap}}) {
      const auto deformer = prepared(p.of.cage, "biharmonic_boundary", as_printed(normals));
      const Vec found = image(deformed(*deformer, p.of.posed, p.of.points), 0, 2);
      EXPECT_LT((found - expected).norm(), 1e-11 * p.of.size) << p.of.name << ' ' << normals << found.transpose();
      const auto posed = deformer->pose({p.of.posed, {}});
      const double sum = figure(posed->report(), "sum of squared Laplacians");
      if (normals == kAhap) {
        EXPECT_NEAR(sum, p.laplacians, 5e-10 * p.laplacians) << p.of.name;
        EXPECT_GE(figure(posed->report(), "least sigma"), 0);
        EXPECT_EQ(figure(posed->report(), "zero sigma") > 0, figure(posed->report(), "least sigma") == 0);
      } else {
        EXPECT_GT(sum, p.laplacians * 1.01) << p.of.name;
      }
    }
}

TEST(plane, coordinates_of_the_pentagon_are_those_of_the_specification) {
  const std::vector<double> alpha{0.250679622655, 0.200771597024, 0.0882480669928, 0.332627186858, 0.12767352647},
      beta{-0.236693588072, 0.00418279148956, -0.157406939168, -0.16070564, -0.0202141272743};
  const Case c = pentagon();
  const auto deformer = prepared(c.cage, "biharmonic_boundary", as_printed(kUnit));
  const auto found = deformer->coordinates().at<double>(c.points[0], 0);
  for (std::size_t k = 0; k < alpha.size(); ++k) {
    EXPECT_NEAR(found[0].value[k], alpha[k], 1e-12);
    EXPECT_NEAR(found[1].value[k], beta[k], 1e-12);
  }
}

TEST(plane, cauchy_is_green_with_stretched_normals) {
  for (const Case& c : {square(), l_shape(), pentagon()}) {
    const auto green = deformed(*prepared(c.cage, "green", {0}), c.posed, c.points, 2),
               cauchy = deformed(*prepared(c.cage, "cauchy"), c.posed, c.points, 2);
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < green.tensors[o].size(); ++i)
        EXPECT_NEAR(green.tensors[o][i], cauchy.tensors[o][i], 1e-13) << c.name << " order " << o;
    // Conformal.
    const std::vector<double>& j = cauchy.tensors[1];
    EXPECT_NEAR(j[0], j[3], 1e-14);
    EXPECT_NEAR(j[1], -j[2], 1e-14);
  }
}

double error_of(const Case& c, const Deformer<double>& deformer, const Eigen::Matrix3d& map, bool with_normals) {
  Pose<double> pose;
  for (const Vec& v : c.cage.vertices()) pose.vertices.emplace_back(map * v);
  if (with_normals)
    for (const Vec& n : deformer.coordinates().elements().normals()) pose.normal_derivatives.emplace_back(map * n);
  const auto posed = deformer.pose(pose);
  return (image(deformer.images(*posed, std::span<const Vec>(c.points), 0), 0, 2) - map * c.points[0]).norm() / c.size;
}

TEST(plane, least_laplacians_keep_a_stretch_along_the_axes_of_cages_along_the_axes) {
  const Eigen::Matrix3d stretch = Vec(1.4, 0.6, 1).asDiagonal();
  for (const Case& c : {square(), l_shape(), pentagon()}) {
    const double error =
        error_of(c, *prepared(c.cage, "biharmonic_boundary", {kAhap, 4, kMidpoints, kDiameter}), stretch, false);
    if (c.name == "pentagon") EXPECT_GT(error, 1e-3);
    else EXPECT_LT(error, 1e-13) << c.name;
    for (const double normals : {kUnit, kComplex})
      EXPECT_GT(
          error_of(c, *prepared(c.cage, "biharmonic_boundary", {normals, 4, kMidpoints, kDiameter}), stretch, false),
          1e-3)
          << c.name;
  }
}

TEST(plane, linear_maps_are_exact_with_their_own_normal_derivatives) {
  Eigen::Matrix3d map;
  map << 1.3, .2, 0, .05, .8, 0, 0, 0, 1;
  for (const Case& c : {square(), l_shape(), pentagon()})
    for (const double normals : {kUnit, kComplex, kAhap})
      EXPECT_LT(error_of(c, *prepared(c.cage, "biharmonic_boundary", {normals, 4, kMidpoints, kDiameter}), map, true),
                1e-13)
          << c.name;
}

// The least sum of squared Laplacians over all sets of stretches that may be zero, from explicit sums.
double least_over_all_sets(const CageCoordinates& coordinates, const std::vector<Vec>& posed) {
  const auto laplacians = coordinates.boundary_laplacians<double>();
  const auto edges = static_cast<unsigned>(coordinates.elements().count());
  const auto nodes = static_cast<Eigen::Index>(laplacians[0].tensors[0].size() / laplacians[0].stride[0]);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * nodes, edges);
  Eigen::VectorXd fixed = Eigen::VectorXd::Zero(2 * nodes);
  for (Eigen::Index n = 0; n < nodes; ++n)
    for (unsigned e = 0; e < edges; ++e) {
      const Vec edge = posed[(e + 1) % edges] - posed[e], normal = Vec(edge[1], -edge[0], 0).normalized();
      for (int c = 0; c < 2; ++c) {
        fixed[2 * n + c] += laplacians[0].tensors[0][n * edges + e] * posed[e][c];
        matrix(2 * n + c, e) = laplacians[1].tensors[0][n * edges + e] * normal[c];
      }
    }
  double least = fixed.squaredNorm();
  for (unsigned set = 1; set < 1U << edges; ++set) {
    std::vector<int> columns;
    columns.reserve(edges);
    for (unsigned e = 0; e < edges; ++e)
      if ((set >> e & 1U) != 0) columns.push_back(static_cast<int>(e));
    const Eigen::MatrixXd part = matrix(Eigen::all, columns);
    const Eigen::VectorXd stretches = part.colPivHouseholderQr().solve(-fixed);
    if (stretches.minCoeff() >= 0) least = std::min(least, (fixed + part * stretches).squaredNorm());
  }
  return least;
}

// Poses that are bent so much, or mirrored, that stretches without constraints are negative.
TEST(plane, least_laplacians_have_no_negative_stretch) {
  int with_zeros = 0;
  for (const Case& c : {square(), l_shape(), pentagon()})
    for (const double much : {-2., 2., 4.}) {
      std::vector<Vec> posed;
      for (std::size_t v = 0; v < c.posed.size(); ++v)
        posed.emplace_back(c.cage.vertices()[v] + much * (c.posed[v] - c.cage.vertices()[v]));
      if (much < 0)
        for (Vec& v : posed) v[0] = -v[0];
      const auto deformer = prepared(c.cage, "biharmonic_boundary", {kAhap, 2, kMidpoints, kDiameter});
      const auto found = deformer->pose({posed, {}});
      const double truth = least_over_all_sets(deformer->coordinates(), posed);
      EXPECT_NEAR(figure(found->report(), "sum of squared Laplacians"), truth, 1e-11 * truth) << c.name << much;
      EXPECT_GE(figure(found->report(), "least sigma"), 0) << c.name << much;
      with_zeros += figure(found->report(), "zero sigma") > 0 ? 1 : 0;
    }
  EXPECT_GE(with_zeros, 3);
}

// In units that are ten times smaller, over these.
double change_with_the_unit(const Case& c, const std::vector<double>& parameters) {
  const double s = 10;
  std::vector<Vec> vertices, posed;
  vertices.reserve(c.posed.size());
  posed.reserve(c.posed.size());
  for (const Vec& v : c.cage.vertices()) vertices.emplace_back(s * v);
  for (const Vec& v : c.posed) posed.emplace_back(s * v);
  const Cage large = Cage::make_polygon("large", vertices, c.cage.faces(), {});
  const auto a = deformed(*prepared(c.cage, "biharmonic_boundary", parameters), c.posed, c.points),
             b = deformed(*prepared(large, "biharmonic_boundary", parameters), posed, {Vec(s * c.points[0])});
  return (image(a, 0, 2) - image(b, 0, 2) / s).norm() / c.size;
}

TEST(plane, unit_of_length_matters_where_it_is_the_cages_own) {
  for (const Case& c : {l_shape(), pentagon()})
    for (const double normals : {kUnit, kComplex, kAhap}) {
      EXPECT_LT(change_with_the_unit(c, {normals, 2, kMidpoints, kDiameter}), 1e-12) << c.name;
      EXPECT_GT(change_with_the_unit(c, as_printed(normals)), 1e-5) << c.name;
    }
}

TEST(plane, singular_square_systems_are_said_to_be) {
  const auto report = prepared(square().cage, "biharmonic_boundary", {kUnit, 1, kVertices, kOwn})->prepared();
  ASSERT_EQ(report.systems.size(), 2U);
  EXPECT_EQ(report.systems[0].rank, 3);
  EXPECT_EQ(report.systems[0].columns, 4);
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_NE(report.warnings[0].find("rank 3 of 4"), std::string::npos) << report.warnings[0];
  EXPECT_NE(report.warnings[0].find("collocation=vertices-and-midpoints"), std::string::npos) << report.warnings[0];
  EXPECT_TRUE(prepared(square().cage, "biharmonic_boundary", as_printed(kUnit))->prepared().warnings.empty());
}

TEST(plane, edges_without_length_are_refused_where_their_normals_are_used) {
  const Case c = square();
  std::vector<Vec> posed = c.posed;
  posed[2] = posed[1];
  for (const double normals : {kUnit, kAhap}) {
    const auto deformer = prepared(c.cage, "biharmonic_boundary", as_printed(normals));
    try {
      deformer->pose({posed, {}});
      ADD_FAILURE() << "taken";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("1 (vertices 1, 2) has no length"), std::string::npos) << e.what();
    }
  }
  EXPECT_NO_THROW(prepared(c.cage, "biharmonic_boundary", as_printed(kComplex))->pose({posed, {}}));
  EXPECT_NO_THROW(prepared(c.cage, "cauchy")->pose({posed, {}}));
}

TEST(plane, poses_inside_out_are_warned_of) {
  const Case c = pentagon();
  std::vector<Vec> mirrored;
  for (const Vec& v : c.cage.vertices()) mirrored.emplace_back(-v[0], v[1], 0);
  const auto posed = prepared(c.cage, "biharmonic_boundary", as_printed(kUnit))->pose({mirrored, {}});
  ASSERT_EQ(posed->report().warnings.size(), 1U);
  EXPECT_NE(posed->report().warnings[0].find("inside out"), std::string::npos);
}

TEST(plane, fifty_digits_agree_with_double) {
  const Case c = pentagon();
  for (const double normals : {kUnit, kComplex, kAhap}) {
    const auto exact = prepare_deformer<Mp50>(deform_method_named("biharmonic_boundary"), c.cage,
                                              {.parameters = {normals, 1, kMidpoints, kOwn}});
    std::vector<Vec3<Mp50>> posed, points{convert<Mp50>(c.points[0])};
    for (const Vec& v : c.posed) posed.push_back(convert<Mp50>(v));
    const Images<Mp50> truth = deformed<Mp50>(*exact, posed, points, 2);
    const Images<double> found =
        deformed(*prepared(c.cage, "biharmonic_boundary", as_printed(normals)), c.posed, c.points, 2);
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < found.tensors[o].size(); ++i)
        EXPECT_NEAR(found.tensors[o][i], static_cast<double>(truth.tensors[o][i]), 1e-13) << normals << " order " << o;
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::plane_test
