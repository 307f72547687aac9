// SPDX-License-Identifier: MIT
// Regularised biharmonic coordinates as a kind of coordinates ([T24] Eq 27): Section 3's theorems, and their densities
// by another route.
#include "regularised_routes.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cageproof::deformation::test::regularised_coordinates_test {
namespace {

constexpr std::array kinds{"regularised_1_3", "regularised_1_2", "regularised_weber"};
constexpr std::array deformers{"biharmonic_1_3", "biharmonic_1_2", "biharmonic_weber"};

CageCoordinates coordinates_of(const Cage& cage, const char* kind, std::vector<double> parameters = {}) {
  return {cage, coordinate_kind_named(kind), CoordinateOptions{.parameters = std::move(parameters)}};
}

std::vector<Vec> unit_normals(const CageElements& elements, const std::vector<Vec>& posed) {
  return stretched_normals(Stretch::Unit, elements, posed);
}

template <Scalar R>
Matrix<R> as_rows(const std::vector<Vec>& points, int dimension) {
  Matrix<R> rows(points.size(), dimension);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int c = 0; c < dimension; ++c) rows(static_cast<int>(i), c) = R(points[i][c]);
  return rows;
}

// Derivatives of order o of sum_i coordinates_i data_i: [component][derivatives].
template <Scalar R>
Matrix<R> product(const Result<R>& block, int order, const Matrix<R>& data) {
  const auto width = static_cast<Eigen::Index>(block.of(order).size()) / data.rows();
  const Eigen::Map<const Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> rows(block.of(order).data(),
                                                                                                 data.rows(), width);
  return data.transpose() * rows;
}

template <Scalar R>
void expect_reproduction(const Case& c, const char* kind, double tolerance) {
  const CageCoordinates coordinates = coordinates_of(c.cage, kind);
  const int d = c.cage.dimension();
  const Matrix<R> ones = Matrix<R>::Ones(coordinates.blocks()[0].size, 1),
                  vertices = as_rows<R>(coordinates.elements().vertices(), d);
  Matrix<R> normals(coordinates.elements().count(), d);
  for (std::size_t e = 0; e < coordinates.elements().count(); ++e)
    for (int k = 0; k < d; ++k) normals(static_cast<int>(e), k) = R(coordinates.elements().normals()[e][k]);
  for (const Vec& point : c.points) {
    const auto at = coordinates.at<R>(convert<R>(point), 2);
    for (int o = 0; o <= 2; ++o) {
      const Matrix<R> sum = product<R>(at[0], o, ones);
      const Matrix<R> image = product<R>(at[0], o, vertices) + product<R>(at[1], o, normals);
      for (Eigen::Index i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(static_cast<double>(sum.reshaped()[i]), o == 0 ? 1 : 0, tolerance) << c.name << kind << o;
      for (int k = 0; k < d; ++k)
        for (Eigen::Index i = 0; i < image.cols(); ++i) {
          const double expected = o == 0 ? point[k] : o == 1 && i == k ? 1 : 0;
          EXPECT_NEAR(static_cast<double>(R(image(k, i) - R(expected))), 0, tolerance) << c.name << kind << o;
        }
    }
  }
}

TEST(regularised, alpha_sums_to_one_and_both_reproduce_points) {
  for (const Case& c : {cube(), bar(), square(), l_shape(), pentagon()})
    for (const char* kind : kinds) expect_reproduction<double>(c, kind, 1e-11);
  // With normals that are exact.
  for (const Case& c : {cube(), square(), l_shape()})
    for (const char* kind : kinds) expect_reproduction<Mp50>(c, kind, 1e-40);
}

TEST(regularised, times_vertices_and_normals_is_the_deformer) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()})
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const CageCoordinates coordinates = coordinates_of(c.cage, kinds[k]);
      const int d = c.cage.dimension();
      const auto deformer = prepared(c.cage, deformers[k]);
      const Images<double> images = deformed(*deformer, c.posed, c.points, 2);
      const Matrix<double> normals = as_rows<double>(unit_normals(coordinates.elements(), c.posed), d);
      for (std::size_t p = 0; p < c.points.size(); ++p) {
        const auto at = coordinates.at<double>(c.points[p], 2);
        for (int o = 0; o <= 2; ++o) {
          const Matrix<double> image =
              product<double>(at[0], o, as_rows<double>(c.posed, d)) + product<double>(at[1], o, normals);
          for (int i = 0; i < d; ++i)
            for (Eigen::Index j = 0; j < image.cols(); ++j)
              EXPECT_NEAR(image(i, j), images.tensors[o][(p * d + i) * image.cols() + j], 1e-11)
                  << c.name << ' ' << kinds[k] << ' ' << o;
        }
      }
    }
}

TEST(regularised, densities_are_those_of_the_constraints) {
  for (const Case& c : {cube(), l_shape(), pentagon()})
    for (const char* kind : kinds) {
      const CageCoordinates coordinates = coordinates_of(c.cage, kind);
      const CageCoordinates layers(c.cage, coordinate_kind_named("biharmonic"), CoordinateOptions{});
      const int d = c.cage.dimension();
      const Mp vertices = as_rows<Mp50>(c.posed, d),
               normals = as_rows<Mp50>(unit_normals(layers.elements(), c.posed), d);
      const Mp densities = densities_by_constraints(kind, layers, vertices, normals);
      for (const Vec& point : c.points) {
        const auto at = coordinates.at<Mp50>(convert<Mp50>(point), 0);
        const auto of_layers = layers.at<Mp50>(convert<Mp50>(point), 0);
        const Mp found = product<Mp50>(at[0], 0, vertices) + product<Mp50>(at[1], 0, normals);
        const Mp expected = product<Mp50>(of_layers[0], 0, vertices) + product<Mp50>(of_layers[1], 0, normals) +
                            product<Mp50>(of_layers[2], 0, densities.topRows(vertices.rows())) +
                            product<Mp50>(of_layers[3], 0, densities.bottomRows(normals.rows()));
        // Layers 1e-30 off the cage, times a condition of 1e4.
        for (int i = 0; i < d; ++i)
          EXPECT_NEAR(static_cast<double>(Mp50(found(i, 0) - expected(i, 0))), 0, 1e-24) << c.name << ' ' << kind;
      }
    }
}

// At the samples; |A X - b| is the misfit of the images there, and X is in the Laplacians inside.
TEST(regularised, misfits_are_monotone_in_gamma_d) {
  const Case c = cube();
  const CageCoordinates layers(c.cage, coordinate_kind_named("biharmonic"), CoordinateOptions{});
  const Mp vertices = as_rows<Mp50>(c.posed, 3), normals = as_rows<Mp50>(unit_normals(layers.elements(), c.posed), 3);
  const std::vector<SampleRows> samples = sample_rows(layers);
  Mp50 last_misfit("1e9"), last_laplacian(0);
  for (const double gamma : {1e-3, 1e-1, 1., 10., 1e3}) {
    const CageCoordinates coordinates = coordinates_of(c.cage, "regularised_1_3", {1, gamma, 0});
    Mp laplacians(samples.size(), 3), rows(samples.size(), layers.blocks()[0].size + layers.blocks()[1].size);
    Mp50 misfit = 0, laplacian = 0;
    std::vector<Touching> places;
    for (const SampleRows& s : samples) {
      Touching place{s.element, {}};
      const auto corners = layers.elements().vertices_of(s.element);
      for (int k = 0; k < 3; ++k) place.basis[k] = static_cast<double>(s.hats(0, corners[k]));
      places.push_back(place);
    }
    const auto limits = coordinates.limits_at<Mp50>(places, 2);
    for (int s = 0; s < static_cast<int>(samples.size()); ++s) {
      const auto part = [&](std::size_t b, const Mp& data, std::size_t order, int which) {
        const std::size_t width = derivative_count(3, static_cast<int>(order));
        Mp sum = Mp::Zero(1, 3);
        for (int i = 0; i < data.rows(); ++i)
          sum += limits[b].tensors[order][s * limits[b].stride[order] + i * width + which] * data.row(i);
        return sum;
      };
      misfit += (part(0, vertices, 0, 0) + part(1, normals, 0, 0) - samples[s].hats * vertices).squaredNorm();
      laplacians.row(s).setZero();
      for (const int trace : {0, 4, 8}) laplacians.row(s) += part(0, vertices, 2, trace) + part(1, normals, 2, trace);
      rows.row(s) = side_by_side(samples[s].of[0], samples[s].of[1]);
    }
    const Mp densities = LeastSquares<Mp50>(rows).solve(laplacians);
    for (int s = 0; s < static_cast<int>(samples.size()); ++s)
      laplacian += (laplacians.row(s) - samples[s].hats * densities.topRows(vertices.rows())).squaredNorm();
    EXPECT_LT(misfit, last_misfit) << gamma;
    EXPECT_GT(laplacian, last_laplacian) << gamma;
    last_misfit = misfit;
    last_laplacian = laplacian;
  }
}

// The largest difference of coordinates, those of elements over the unit.
double difference(const CageCoordinates& a, const CageCoordinates& b, const Vec& at_a, const Vec& at_b, double unit) {
  const auto of_a = a.at<double>(at_a, 0), of_b = b.at<double>(at_b, 0);
  double worst = 0;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < of_a[k].value.size(); ++i)
      worst = std::max(worst, std::abs(of_a[k].value[i] / (k == 1 ? unit : 1) - of_b[k].value[i]));
  return worst;
}

TEST(regularised, unit_of_length_is_a_fourth_power_of_gamma_d) {
  for (const Case& c : {cube(), bar()}) {
    const double s = 8;
    std::vector<Vec> scaled;
    for (const Vec& v : c.cage.vertices()) scaled.emplace_back(s * v);
    const Cage larger = Cage::make("larger", scaled, c.cage.faces(), {});
    const auto between = [&](const char* kind, const std::vector<double>& of_larger, const std::vector<double>& own) {
      return difference(coordinates_of(larger, kind, of_larger), coordinates_of(c.cage, kind, own), s * c.points[0],
                        c.points[0], s);
    };
    EXPECT_LT(between("regularised_1_3", {1, 0.5, 0}, {1, 0.5 * s * s * s * s, 0}), 1e-12);
    EXPECT_GT(between("regularised_1_3", {1, 0.5, 0}, {1, 0.5, 0}), 1e-4);
    EXPECT_LT(between("regularised_1_3", {1, 1, 2}, {1, 1, 2}), 1e-12);
    EXPECT_LT(between("regularised_weber", {}, {}), 1e-12);
    EXPECT_GT(between("regularised_1_2", {}, {}), 1e-4);
  }
}

TEST(regularised, order_of_corners_does_not_matter) {
  const Case c = bar();
  const std::vector<Face> triangles = coordinates_of(c.cage, kinds[0]).elements().all();
  std::vector<Face> turned = triangles;
  for (Face& face : turned) std::rotate(face.vertices.begin(), face.vertices.begin() + 1, face.vertices.begin() + 3);
  const Cage cage = Cage::make("bar", c.cage.vertices(), triangles, {});
  const Cage other = Cage::make("turned", c.cage.vertices(), turned, {});
  for (const char* kind : kinds)
    for (const Vec& point : c.points)
      EXPECT_LT(difference(coordinates_of(cage, kind), coordinates_of(other, kind), point, point, 1), 1e-12) << kind;
}

TEST(regularised, gamma_zero_is_green) {
  const Case c = cube();
  const CageCoordinates green(c.cage, coordinate_kind_named("green"), CoordinateOptions{});
  for (const Vec& point : c.points)
    EXPECT_EQ(difference(coordinates_of(c.cage, "regularised_1_3", {1, 0, 0}), green, point, point, 1), 0);
}

TEST(regularised, level_zero_of_the_cube_leaves_two_densities_open) {
  const auto solved = coordinates_of(cube().cage, "regularised_1_3", {0, 1, 0}).solved();
  ASSERT_EQ(solved.size(), 1u);
  EXPECT_EQ(solved[0].rank, 18);
  EXPECT_EQ(solved[0].columns, 20);
}

TEST(regularised, refuses_parameters_out_of_range_and_evaluations_without_limits) {
  const Case c = cube();
  EXPECT_THROW(coordinates_of(c.cage, "regularised_1_3", {1, -1, 0}), InputError);
  EXPECT_THROW(coordinates_of(c.cage, "regularised_weber", {7}), InputError);
  for (const char* kind : kinds)
    EXPECT_THROW(CageCoordinates(c.cage, coordinate_kind_named(kind), CoordinateOptions{.evaluation = "gauss-4"}),
                 InputError)
        << kind;
}

}  // namespace
}  // namespace cageproof::deformation::test::regularised_coordinates_test
