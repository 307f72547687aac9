// SPDX-License-Identifier: MIT
// Derivatives of spherical and maximum entropy coordinates: against differences of their values in multiprecision, and
// what they must add up to.
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;

CoordinateOptions recommended() { return {}; }

CageCoordinates prepared(const Cage& cage, const char* kind) {
  return {cage, coordinate_kind_named(kind), recommended()};
}

template <Scalar R>
Result<R> at(const CageCoordinates& kind, const Vec3<R>& point, int order) {
  return kind.at<R>(point, order).front();
}

// |a - b| over max(|b|, least), norm-wise.
template <Scalar A, Scalar B>
double relative(const std::vector<A>& a, const std::vector<B>& b, double least = 0) {
  Mp100 difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Mp100 d = Mp100(a[i]) - Mp100(b[i]);
    difference += d * d;
    size += Mp100(b[i]) * Mp100(b[i]);
  }
  const double r =
      static_cast<double>(Mp100(sqrt(difference))) / std::max(least, static_cast<double>(Mp100(sqrt(size))));
  return std::isnan(r) || a.size() != b.size() ? HUGE_VAL : r;
}

// Gradients and Hessians by central differences of values.
Result<Mp100> differences(const CageCoordinates& kind, const Vec3<Mp100>& point, const Mp100& step) {
  const std::size_t n = kind.blocks().front().size;
  Result<Mp100> found;
  found.reset(static_cast<int>(n), 3, 2);
  const auto moved = [&](int i, int si, int j, int sj) {
    Vec3<Mp100> x = point;
    x[i] += si * step;
    x[j] += sj * step;
    return at(kind, x, 0).value;
  };
  found.value = at(kind, point, 0).value;
  for (int i = 0; i < 3; ++i) {
    const auto up = moved(i, 1, i, 0), down = moved(i, -1, i, 0);
    for (std::size_t k = 0; k < n; ++k) {
      found.gradient[3 * k + i] = (up[k] - down[k]) / (2 * step);
      found.hessian[9 * k + 4 * i] = (up[k] - 2 * found.value[k] + down[k]) / (step * step);
    }
    for (int j = i + 1; j < 3; ++j) {
      const auto pp = moved(i, 1, j, 1), pm = moved(i, 1, j, -1), mp = moved(i, -1, j, 1), mm = moved(i, -1, j, -1);
      for (std::size_t k = 0; k < n; ++k)
        found.hessian[9 * k + 3 * i + j] = found.hessian[9 * k + 3 * j + i] =
            (pp[k] - pm[k] - mp[k] + mm[k]) / (4 * step * step);
    }
  }
  return found;
}

// How far sum lambda_k and sum lambda_k v_k are from one and the point, with derivatives, worst over all of them.
template <Scalar R>
double reproduction_error(const Cage& cage, const Result<R>& found, const Vec3<R>& point, int order) {
  R worst = 0;
  for (int o = 0; o <= order; ++o) {
    const std::size_t entries = derivative_count(3, o);
    for (std::size_t e = 0; e < entries; ++e)
      for (int c = 0; c < 4; ++c) {  // partition of unity, then the three coordinates
        R sum = c == 0   ? R(o == 0 ? -1 : 0)
                : o == 0 ? R(-point[c - 1])
                         : R(o == 1 && e == static_cast<std::size_t>(c - 1) ? -1 : 0);
        for (std::size_t k = 0; k < cage.vertices().size(); ++k)
          sum += found.of(o)[k * entries + e] * (c == 0 ? R(1) : R(cage.vertices()[k][c - 1]));
        if (!(sum * sum <= worst * worst)) worst = sum;
      }
  }
  return std::abs(static_cast<double>(worst));
}

struct Case {
  const char* cage;
  Vec point;
  bool in_hull = true;  ///< where maximum entropy coordinates exist
};

// Inside, outside, next to a face, far from the quads' planes and not.
const std::vector<Case> kCases{
    {"cube", {0.125, -0.25, 0.3125}},  {"cube", {0.1, 0.2, 0.499}},      {"cube", {1.5, -0.75, 0.3}, false},
    {"twisted-bar", {0.1, 0.05, 0.2}}, {"l-block", {-0.4, -0.45, 0.03}}, {"l-block", {-0.9, 0.95, 0.4}},
    {"spiky-box", {0.03, 0.1, 0.02}},  {"torus", {0.7, 0.1, 0.05}},      {"thin-box", {0.1, 0.05, -0.4925}}};

void expect_differences_of_values(const char* kind, double step, double tolerance) {
  for (const Case& c : kCases) {
    if (kind == std::string("maximum_entropy") && !c.in_hull) continue;
    SCOPED_TRACE(testing::Message() << c.cage << ' ' << c.point.transpose());
    const Cage cage = embedded_cage(c.cage);
    const CageCoordinates coordinates = prepared(cage, kind);
    ASSERT_EQ(coordinates.max_order(), 2);
    const Vec3<Mp100> point = convert<Mp100>(c.point);
    const Result<Mp100> found = at(coordinates, point, 2), by_values = differences(coordinates, point, Mp100(step));
    EXPECT_LT(relative(found.gradient, by_values.gradient), tolerance);
    EXPECT_LT(relative(found.hessian, by_values.hessian), tolerance);
    EXPECT_LT(relative(found.value, by_values.value), 1e-48);
  }
}

TEST(coordinate_derivatives, of_spherical_are_differences_of_values) {
  expect_differences_of_values("spherical_mean_value", 1e-26, 1e-40);
}
// The line form gives its weights, and so the prior, 48 digits.
TEST(coordinate_derivatives, of_maximum_entropy_are_differences_of_values) {
  expect_differences_of_values("maximum_entropy", 1e-13, 1e-17);
}

void expect_digits_of_each_scalar(const char* kind, double fifty, double own) {
  for (const Case& c : kCases) {
    if (kind == std::string("maximum_entropy") && !c.in_hull) continue;
    const Cage cage = embedded_cage(c.cage);
    const CageCoordinates coordinates = prepared(cage, kind);
    EXPECT_TRUE(coordinates.is_exact_in(ScalarKind::Digits50) && coordinates.is_exact_in(ScalarKind::Digits100));
    const auto most = at(coordinates, convert<Mp100>(c.point), 2);
    const auto more = at(coordinates, convert<Mp50>(c.point), 2);
    const auto plain = at(coordinates, c.point, 2);
    const Vec3<float> rounded = convert<float>(c.point);
    const auto single = at(coordinates, rounded, 2);
    const auto wide = at(coordinates, convert<double>(rounded), 2);
    for (int o = 0; o <= 2; ++o) {
      SCOPED_TRACE(testing::Message() << kind << ' ' << c.cage << ' ' << c.point.transpose() << " order " << o);
      EXPECT_LT(relative(more.of(o), most.of(o)), fifty);
      EXPECT_LT(relative(plain.of(o), most.of(o)), own);
      for (std::size_t i = 0; i < wide.of(o).size(); ++i) EXPECT_EQ(single.of(o)[i], static_cast<float>(wide.of(o)[i]));
    }
    EXPECT_LT(relative(at(coordinates, c.point, 0).value, plain.value), 1e-12) << kind << ' ' << c.cage;
    EXPECT_LT(relative(at(coordinates, c.point, 1).gradient, plain.gradient), 1e-11) << kind << ' ' << c.cage;
    EXPECT_LT(reproduction_error(cage, plain, c.point, 2), 1e4 * own) << kind << ' ' << c.cage;
    EXPECT_LT(reproduction_error(cage, most, convert<Mp100>(c.point), 2), 1e-80) << kind << ' ' << c.cage;
  }
}

TEST(coordinate_derivatives, of_spherical_have_the_digits_of_their_scalar) {
  expect_digits_of_each_scalar("spherical_mean_value", 1e-44, 1e-10);
}
TEST(coordinate_derivatives, of_maximum_entropy_have_the_digits_of_their_scalar) {
  expect_digits_of_each_scalar("maximum_entropy", 1e-32, 1e-10);
}

// In and next to a face's plane that face's weights all but vanish, their derivatives do not.
TEST(coordinate_derivatives, of_spherical_keep_their_digits_in_and_next_to_planes_of_faces) {
  const Cage cage = embedded_cage("l-block");
  const CageCoordinates coordinates = prepared(cage, "spherical_mean_value");
  const Vec in_plane(-0.5, 0.0, 0.25);  // of the notch's faces
  for (const double height : {0.0, 1e-18, 1e-9, 1e-5}) {
    const Vec point = in_plane + height * Vec(0, 1, 0);
    SCOPED_TRACE(height);
    const auto plain = at(coordinates, point, 2);
    const auto most = at(coordinates, convert<Mp100>(point), 2);
    for (int o = 0; o <= 2; ++o) EXPECT_LT(relative(plain.of(o), most.of(o)), 1e-10) << o;
    // Values lose digits there, and with a longer step their differences less.
    const auto by_values = differences(coordinates, convert<Mp100>(point), Mp100(1e-20));
    EXPECT_LT(relative(most.gradient, by_values.gradient), 1e-36);
    EXPECT_LT(relative(most.hessian, by_values.hessian), 1e-36);
  }
}

// The arc of an edge has no plane where the point is on its line.
TEST(coordinate_derivatives, of_spherical_exist_on_the_lines_of_edges) {
  const Cage cage = embedded_cage("twisted-bar");
  const CageCoordinates coordinates = prepared(cage, "spherical_mean_value");
  const auto& v = cage.vertices();
  for (const Face& face : cage.faces()) {
    if (face.kind() != ElementKind::Quad) continue;
    const Vec point = 2 * v[face.vertices[1]] - v[face.vertices[0]];
    const Vec3<Mp100> exact = 2 * convert<Mp100>(v[face.vertices[1]]) - convert<Mp100>(v[face.vertices[0]]);
    const auto most = at(coordinates, exact, 2);
    const auto by_values = differences(coordinates, exact, Mp100(1e-20));
    EXPECT_LT(relative(most.gradient, by_values.gradient), 1e-36);
    EXPECT_LT(relative(most.hessian, by_values.hessian), 1e-36);
    EXPECT_LT(relative(at(coordinates, point, 2).hessian, at(coordinates, convert<Mp100>(point), 2).hessian), 1e-10);
  }
}

TEST(coordinate_derivatives, are_nan_on_the_cage_and_where_there_are_no_coordinates) {
  const Cage cube = embedded_cage("cube");
  for (const char* kind : {"spherical_mean_value", "maximum_entropy"})
    for (const Vec& point : {Vec(0.5, 0.25, 0.125), Vec(0.5, 0.5, 0), Vec(0.5, 0.5, 0.5)}) {
      const auto found = at(prepared(cube, kind), point, 2);
      for (const double x : found.value) EXPECT_TRUE(std::isfinite(x)) << kind;
      for (int o = 1; o <= 2; ++o)
        for (const double x : found.of(o)) EXPECT_TRUE(std::isnan(x)) << kind;
    }
  const auto outside = at(prepared(cube, "maximum_entropy"), Vec(3, 4, 5), 2);
  for (int o = 0; o <= 2; ++o)
    for (const double x : outside.of(o)) EXPECT_TRUE(std::isnan(x));
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc
