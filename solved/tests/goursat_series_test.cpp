// SPDX-License-Identifier: MIT
// The coordinates of the unit square by another way: the plate's two Fourier series, superposed. And known figures of
// clamped plates.
#include "cageproof/core/coordinates/coordinates.h"
#include "goursat/dirichlet_solver.h"
#include "goursat_polygons.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace cageproof::solved::goursat::goursat_series_test {
namespace {

constexpr double kPi = std::numbers::pi, kHalf = 0.5;

// Biharmonic functions in [-1/2, 1/2]^2 that vanish on its border, even or odd in x and in y:
//   sum a_m T(k_m x) F_m(y) + sum b_n T(k_n y) F_n(x),
// where T, cosine or sine, vanishes at +-1/2 and F(y) = y sinh(k y)/sinh(k/2) - cosh(k y)/(2 cosh(k/2)), or with sinh
// and cosh exchanged. Coefficients are such that the derivatives at y = 1/2 and at x = 1/2 have the sine or cosine
// coefficients of given functions. Both converge like a power of the number of terms, which is extrapolated.
class PlateSeries {
 public:
  using Data = double (*)(double wave, bool odd);  // the integral over [-1/2, 1/2] of the data times T(wave x)

  PlateSeries(bool odd_x, bool odd_y, Data at_y, Data at_x, int terms) : odd_x_(odd_x), odd_y_(odd_y), n_(terms) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * n_, 2 * n_);
    Eigen::VectorXd right(2 * n_);
    for (int m = 0; m < n_; ++m) {
      const double k = wave(m, odd_x_), l = wave(m, odd_y_);
      system(m, m) = slope(k, odd_y_) * kHalf;
      system(n_ + m, n_ + m) = slope(l, odd_x_) * kHalf;
      right[m] = at_y(k, odd_x_);
      right[n_ + m] = at_x(l, odd_y_);
      for (int j = 0; j < n_; ++j) {
        system(m, n_ + j) = end_slope(wave(j, odd_y_), odd_y_) * moment(wave(j, odd_y_), k, odd_x_);
        system(n_ + m, j) = end_slope(wave(j, odd_x_), odd_x_) * moment(wave(j, odd_x_), l, odd_y_);
      }
    }
    coefficients_ = system.partialPivLu().solve(right);
  }

  double at(double x, double y) const {
    double sum = 0;
    for (int m = n_ - 1; m >= 0; --m) {
      const double k = wave(m, odd_x_), l = wave(m, odd_y_);
      sum += coefficients_[m] * trigonometric(k * x, odd_x_) * across(k, y, odd_y_);
      sum += coefficients_[n_ + m] * trigonometric(l * y, odd_y_) * across(l, x, odd_x_);
    }
    return sum;
  }

 private:
  static double wave(int m, bool odd) { return odd ? 2 * (m + 1) * kPi : (2 * m + 1) * kPi; }
  static double trigonometric(double x, bool odd) { return odd ? std::sin(x) : std::cos(x); }
  static double end_slope(double k, bool odd) { return k * (odd ? std::cos(k / 2) : -std::sin(k / 2)); }
  // sinh(k y)/sinh(k/2) and cosh(k y)/cosh(k/2), of which the first is odd, without overflow.
  static double sinh_ratio(double k, double y) {
    const double far = std::exp(k * (std::abs(y) - kHalf)) * -std::expm1(-2 * k * std::abs(y)) / -std::expm1(-k);
    return y < 0 ? -far : far;
  }
  static double cosh_ratio(double k, double y) {
    return std::exp(k * (std::abs(y) - kHalf)) * (1 + std::exp(-2 * k * std::abs(y))) / (1 + std::exp(-k));
  }
  static double across(double k, double y, bool odd) {
    return odd ? y * cosh_ratio(k, y) - kHalf * sinh_ratio(k, y) : y * sinh_ratio(k, y) - kHalf * cosh_ratio(k, y);
  }
  // Its derivative at 1/2.
  static double slope(double k, bool odd) {
    const double tanh = std::tanh(k / 2), s = k / 2 * (1 / tanh - tanh);
    return odd ? 1 - s : 1 + s;
  }
  // The integral of F_n T(k x), from (D^2 - n^2) F_n = 2 n cosh(n x)/sinh(n/2), or the other way round.
  static double moment(double n, double k, bool odd) {
    const double square = n * n + k * k;
    return odd ? 4 * n * k * std::tanh(n / 2) * std::cos(k / 2) / (square * square)
               : -4 * n * k / std::tanh(n / 2) * std::sin(k / 2) / (square * square);
  }

  bool odd_x_, odd_y_;
  int n_;
  Eigen::VectorXd coefficients_;
};

double zero(double, bool) { return 0; }
double one(double k, bool odd) { return odd ? 0 : 2 * std::sin(k / 2) / k; }
// The coefficient of x, for odd functions: k is a multiple of 2 pi.
double linear(double k, bool odd) { return odd ? -std::cos(k / 2) / k : 0; }

// The limit of an infinite number of terms, by Aitken's process.
class PlateLimit {
 public:
  PlateLimit(bool odd_x, bool odd_y, PlateSeries::Data at_y, PlateSeries::Data at_x) {
    for (const int n : {100, 200, 400}) series_.emplace_back(odd_x, odd_y, at_y, at_x, n);
  }
  double at(double x, double y) const {
    const double s = series_[2].at(x, y), b = s - series_[1].at(x, y), a = series_[1].at(x, y) - series_[0].at(x, y);
    return std::abs(b - a) < 1e-15 ? s : s - b * b / (b - a);
  }

 private:
  std::vector<PlateSeries> series_;
};

// The square's coordinates at a point from its centre. Edges are those of unit_square(): bottom, right, top, left.
struct SquareTruth {
  std::array<double, 4> alpha, beta;
};

SquareTruth square_truth(double x, double y) {
  // Derivatives that are one outward at top and bottom, with equal and with opposite signs; at left and right.
  static const PlateLimit even_y(false, false, one, zero), even_x(false, false, zero, one);
  static const PlateLimit odd_y(false, true, one, zero), odd_x(true, false, zero, one), odd(true, true, linear, linear);
  const double both_y = even_y.at(x, y), both_x = even_x.at(x, y);
  const double apart_y = odd_y.at(x, y), apart_x = odd_x.at(x, y);
  SquareTruth t;
  t.beta = {(both_y - apart_y) / 2, (both_x + apart_x) / 2, (both_y + apart_y) / 2, (both_x - apart_x) / 2};
  // The function that is x on the border, without normal derivative, is x less the function with x's normal derivative.
  const double of_x = x - apart_x, of_y = y - apart_y;
  const double of_xy = x * y - odd.at(x, y);
  const std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (int k = 0; k < 4; ++k)
    t.alpha[k] = 0.25 + signs[k][0] * of_x / 2 + signs[k][1] * of_y / 2 + signs[k][0] * signs[k][1] * of_xy;
  return t;
}

}  // namespace

TEST(goursat_series, square_agrees_with_superposed_fourier_series) {
  const Cage cage = unit_square();
  const CageCoordinates coordinates(cage, coordinate_kind_named("biharmonic_goursat"), CoordinateOptions{});
  for (const auto& [x, y] : {std::pair{0.5, 0.5}, {0.4, 0.2}, {0.25, 0.75}, {0.0625, 0.5}, {0.1, 0.1}, {0.75, 0.25}}) {
    const SquareTruth truth = square_truth(x - 0.5, y - 0.5);
    const auto found = coordinates.at<double>(Vec3<double>(x, y, 0), 0);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(found[0].value[k], truth.alpha[k], 1e-8) << x << ' ' << y << " alpha " << k;
      EXPECT_NEAR(found[1].value[k], truth.beta[k], 1e-8) << x << ' ' << y << " beta " << k;
    }
  }
}

// Largest deflection and clamping moment of a square plate under a load of one: w = 0.0012653191 (Taylor, Govindjee
// 2004: 0.12653191e-2), from r^4/64 and what its data on the border leave.
TEST(goursat_series, clamped_plate_bends_as_known) {
  const auto load = [](const Vec3<double>& p) { return std::pow(p.squaredNorm(), 2) / 64; };
  const Cage cage = polygon("plate", {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  const DirichletSolution u(cage, Equation::Biharmonic, 1, [&](const EdgePoint& at, const BoundaryData& data) {
    data.values[0] = -load(at.point);
    const Vec3<double> gradient = at.point * at.point.squaredNorm() / 16;
    data.normal_derivatives[0] = -gradient.dot(at.normal);
    data.derivatives_along[0] = -gradient.dot(at.along);
  });
  const double deflection = u.at(Vec3<double>(0, 0, 0), 0)[0][0];
  EXPECT_NEAR(deflection, 0.0012653191, 5e-11);
  // Curvature at the middle of an edge: the moment 0.051333765 (Taylor, Govindjee 2004: 0.051334).
  const Vec3<double> edge(0.5, 0, 0);
  const double curvature = u.at(edge, 2)[2][0] + (3 * 0.25 + 0) / 16;
  EXPECT_NEAR(curvature, 0.051334, 1e-6);
}

}  // namespace cageproof::solved::goursat::goursat_series_test
