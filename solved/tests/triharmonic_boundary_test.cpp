// SPDX-License-Identifier: MIT
// Polyharmonic coordinates of order 3 of polygons, against functions that are known and the properties that define
// them.
#include "support.h"

#include <gtest/gtest.h>

namespace cageproof::solved::test::triharmonic_boundary_test {
namespace {

using C = std::complex<double>;

CageCoordinates prepared(const Cage& cage, double pieces, double collocation = 1) {
  return coordinates(cage, "triharmonic_boundary", {pieces, collocation});
}

// Re(conj(z)^2 f(z) + conj(z) g(z) + h(z)), which every triharmonic function is; its Laplacian, four times the mixed
// derivative, is Re(8 conj(z) f'(z) + 4 g'(z)).
struct Triharmonic {
  const char* name;
  C (*f)(C);
  C (*df)(C);
  C (*g)(C);
  C (*dg)(C);
  C (*h)(C);
  C (*dh)(C);

  double value(const Vec& p) const {
    const C z(p[0], p[1]), w = std::conj(z);
    return (w * w * f(z) + w * g(z) + h(z)).real();
  }
  double derivative(const Vec& p, const Vec& direction) const {
    const C z(p[0], p[1]), w = std::conj(z), n(direction[0], direction[1]);
    return (std::conj(n) * (2. * w * f(z) + g(z)) + n * (w * w * df(z) + w * dg(z) + dh(z))).real();
  }
  double laplacian(const Vec& p) const {
    const C z(p[0], p[1]);
    return (8. * std::conj(z) * df(z) + 4. * dg(z)).real();
  }
  std::vector<double> data(const CageElements& elements) const {
    std::vector<double> all = values_and_slopes(*this, elements);
    for (const Vec& v : elements.vertices()) all.push_back(laplacian(v));
    return all;
  }
};

C nothing(C) { return 0; }
C one(C) { return 1; }
C square(C z) { return z * z; }
C twice(C z) { return 2. * z; }
C itself(C z) { return z; }

const C pole(-1.5, -1);

const std::vector<Triharmonic>& known() {
  static const std::vector<Triharmonic> all{
      {"(x^2 + y^2)^2", square, twice, nothing, nothing, nothing, nothing},
      {"x^2 + y^2 + x (x^2 + y^2)^2", [](C z) { return z * z * z; }, [](C z) { return 3. * z * z; }, itself, one,
       nothing, nothing},
      {"a pole outside", [](C z) { return 1. / (z - pole); }, [](C z) { return -1. / ((z - pole) * (z - pole)); },
       [](C z) { return std::log(z - pole); }, [](C z) { return 1. / (z - pole); },
       [](C z) { return 1. / ((z - pole) * (z - pole)); },
       [](C z) { return -2. / ((z - pole) * (z - pole) * (z - pole)); }}};
  return all;
}

const std::vector<Vec> inside{{0.5, 0.5, 0}, {0.25, 0.375, 0}, {0.75, 0.8125, 0}};

std::vector<double> errors_of_all(const Corners& corners, int n, double pieces = 1) {
  return largest_errors(prepared(polygon(subdivided(corners, n)), pieces), known(), inside);
}

TEST(triharmonic_boundary, converges_to_known_triharmonic_functions) {
  for (const Corners* corners : {&unit_square, &convex_pentagon, &l_shape}) {
    const auto coarse = errors_of_all(*corners, 8), fine = errors_of_all(*corners, 32);
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      EXPECT_LT(fine[k], coarse[k] / 4) << known()[k].name;
      EXPECT_LT(fine[k], 0.05) << known()[k].name;
      EXPECT_GT(fine[k], 1e-6) << known()[k].name << ": a study of errors that has none";
    }
  }
}

// Without the third block's data of Laplacians, the function is missed.
TEST(triharmonic_boundary, needs_the_laplacians) {
  const CageCoordinates c = prepared(polygon(subdivided(unit_square, 16)), 1);
  const Triharmonic& f = known()[0];
  std::vector<double> data = f.data(c.elements());
  EXPECT_LT(std::abs(interpolated(c, data, inside[0]) - f.value(inside[0])), 0.01);
  std::fill(data.end() - 64, data.end(), 0.);
  EXPECT_GT(std::abs(interpolated(c, data, inside[0]) - f.value(inside[0])), 0.02);
}

TEST(triharmonic_boundary, reproduces_affine_maps_with_normals) {
  for (const Corners* corners : {&unit_square, &convex_pentagon, &l_shape, &triangle})
    for (const double pieces : {1, 2, 4})
      for (const Vec& point : {Vec(0.3, 0.2, 0), Vec(0.25, 0, 0), Vec(0, 0, 0)})
        EXPECT_LT(affine_errors(prepared(polygon(*corners), pieces), point, 0)[0], 1e-12) << pieces;
  for (const double error : affine_errors(prepared(polygon(l_shape), 4), Vec(0.3, 0.2, 0), 2)) EXPECT_LT(error, 1e-12);
  for (const double error : affine_errors(prepared(polygon(l_shape), 4), Vec(1.5, 1.75, 0), 2, 0))
    EXPECT_LT(error, 1e-12);
}

// Means over circles of a biharmonic function are its value and a multiple of the radius squared.
TEST(triharmonic_boundary, has_biharmonic_laplacians) {
  const CageCoordinates c = prepared(polygon(l_shape), 3);
  ASSERT_EQ(c.blocks().size(), 3u);
  const Vec centre(0.6, 0.55, 0);
  const auto mean = [&](double radius) {
    std::vector<double> sums;
    constexpr int points = 64;
    for (int k = 0; k < points; ++k) {
      const double angle = 2 * 3.14159265358979 * k / points;
      std::size_t i = 0;
      for (const auto& block : c.at<double>(Vec(centre + radius * Vec(std::cos(angle), std::sin(angle), 0)), 2))
        for (std::size_t j = 0; j < block.value.size(); ++j, ++i) {
          if (sums.size() <= i) sums.push_back(0);
          sums[i] += (block.hessian[4 * j] + block.hessian[4 * j + 3]) / points;
        }
    }
    return sums;
  };
  const auto middle = mean(0), near = mean(0.1), far = mean(0.2);
  double curved = 0;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    EXPECT_NEAR(far[i] - middle[i], 4 * (near[i] - middle[i]), 1e-9 * (1 + std::abs(middle[i])));
    curved = std::max(curved, std::abs(far[i] - middle[i]));
  }
  EXPECT_GT(curved, 0.05);
}

// Values and Laplacians on the boundary are the data, in the limit of many pieces.
struct OnBoundary {
  double values = 0, laplacians = 0;
};

OnBoundary on_boundary(const Corners& corners, double pieces) {
  const CageCoordinates c = prepared(polygon(corners), pieces);
  OnBoundary worst;
  const auto differ = [](double found, double expected, double& largest) {
    largest = std::max(largest, std::abs(found - expected));
  };
  const int m = static_cast<int>(corners.size());
  for (int e = 0; e < m; ++e)
    for (const double t : {0.25, 0.5, 0.75}) {
      const auto ends = c.elements().corners(e);
      const auto at = c.at<double>(Vec(ends[0] + t * (ends[1] - ends[0])), 0);
      const auto next = c.at<double>(Vec(ends[0] + t * (ends[1] - ends[0]) - 1e-9 * c.elements().normals()[e]), 2);
      for (int j = 0; j < m; ++j) {
        const double hat = j == e ? 1 - t : j == (e + 1) % m ? t : 0;
        differ(at[0].value[j], hat, worst.values);
        differ(at[1].value[j], 0, worst.values);
        differ(at[2].value[j], 0, worst.values);
        for (int b = 0; b < 3; ++b)
          differ(next[b].hessian[4 * j] + next[b].hessian[4 * j + 3], b == 2 ? hat : 0, worst.laplacians);
      }
    }
  return worst;
}

// Values with corners are met roughly, by as much whatever the pieces; Laplacians the better the more.
TEST(triharmonic_boundary, meets_laplacians_and_comes_near_hat_functions) {
  for (const Corners* corners : {&unit_square, &convex_pentagon}) {
    const OnBoundary coarse = on_boundary(*corners, 4), fine = on_boundary(*corners, 16);
    EXPECT_LT(fine.values, 0.12);
    EXPECT_GT(fine.values, 0.03);
    EXPECT_LT(fine.laplacians, coarse.laplacians / 2);
    EXPECT_LT(fine.laplacians, 0.01);
  }
}

// Vertices make it converge; pieces must not undo it.
TEST(triharmonic_boundary, is_as_near_to_known_functions_with_any_number_of_pieces) {
  for (const Corners* corners : {&unit_square, &convex_pentagon, &l_shape}) {
    const auto one = errors_of_all(*corners, 8), many = errors_of_all(*corners, 8, 12);
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_LT(many[k], 2 * one[k]) << known()[k].name;
  }
}

// Coordinates of Laplacians have the unit of an area.
TEST(triharmonic_boundary, scales_with_the_unit) {
  const CageCoordinates small = prepared(polygon(convex_pentagon), 3),
                        large = prepared(polygon(convex_pentagon, 64), 3);
  const auto a = small.at<double>(Vec(0.5, 0.5, 0), 2), b = large.at<double>(Vec(32, 32, 0), 2);
  for (int block = 0; block < 3; ++block)
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < a[block].of(o).size(); ++i)
        EXPECT_NEAR(b[block].of(o)[i], a[block].of(o)[i] * std::pow(64, block - o), 1e-11 * std::pow(64, block - o));
}

TEST(triharmonic_boundary, says_what_it_solved) {
  for (const SolvedSystem& s : prepared(polygon(l_shape), 4).solved()) {
    EXPECT_FALSE(s.is_singular()) << s.name;
    EXPECT_EQ(s.rows, 2 * s.columns) << s.name;
    EXPECT_LT(s.condition, 1e5) << s.name;
  }
  const auto systems = prepared(polygon(unit_square), 2, 0).solved();
  ASSERT_EQ(systems.size(), 2u);
  EXPECT_TRUE(systems[0].is_singular());
}

TEST(triharmonic_boundary, in_double_is_that_in_fifty_digits) {
  const CageCoordinates c = prepared(polygon(l_shape), 2);
  const auto found = c.at<double>(Vec(0.3, 0.2, 0), 2);
  const auto expected = c.at<Mp50>(Vec3<Mp50>(convert<Mp50>(Vec(0.3, 0.2, 0))), 2);
  for (std::size_t b = 0; b < 3; ++b)
    for (int o = 0; o <= 2; ++o)
      for (std::size_t i = 0; i < found[b].of(o).size(); ++i)
        EXPECT_NEAR(found[b].of(o)[i], static_cast<double>(expected[b].of(o)[i]), 1e-12);
}

}  // namespace
}  // namespace cageproof::solved::test::triharmonic_boundary_test
