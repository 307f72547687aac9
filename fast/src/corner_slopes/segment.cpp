// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/fast/layer_slopes.h"

#include <cmath>
#include <numbers>

namespace cageproof::fast {
namespace {

constexpr double kHalfPi = 1 / (2 * std::numbers::pi);

Vec3<double> quarter_turn(const Vec3<double>& v) { return {v[1], -v[0], 0}; }

// int -ln r/(2 pi) ds, and det/(2 pi) int Gamma_j/r^2 du, differentiated under the integral.
// \param side between the ends, which far from the point their difference has not to all digits
LayerSlopes segment_by_gauss(const Vec3<double>& first, const Vec3<double>& second, const Vec3<double>& side) {
  static const GaussLegendre<double>& rule = gauss_legendre<double>(12);
  const Vec3<double> along = side / side.norm();
  const double length = side.norm(), det = first.dot(quarter_turn(side));
  LayerSlopes found;
  found.single.fill(Vec3<double>::Zero());
  double logarithm = 0;
  std::array<double, 2> squares{};
  std::array<std::array<Vec3<double>, 2>, 2> fourths;
  for (auto& row : fourths) row.fill(Vec3<double>::Zero());
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const std::array<double, 2> hats{1 - rule.nodes[i], rule.nodes[i]};
    const Vec3<double> y = first + hats[1] * side;
    const double r2 = y.squaredNorm(), square = rule.weights[i] / r2;
    logarithm -= rule.weights[i] * std::log(r2) / 2;
    for (int m = 0; m < 2; ++m) {
      found.single[m] -= hats[m] * square * length * y;
      squares[m] += hats[m] * square;
      for (int j = 0; j < 2; ++j) fourths[j][m] -= (2 * hats[j] * hats[m] * square / r2) * y;
    }
  }
  for (int m = 0; m < 2; ++m) {
    const double sign = m == 0 ? -1 : 1;
    found.single[m] = kHalfPi * (found.single[m] + sign * logarithm * along);
    // det = first x second.
    const Vec3<double> by_det = m == 0 ? quarter_turn(second) : Vec3<double>(-quarter_turn(first));
    for (int j = 0; j < 2; ++j) found.doubled[j][m] = kHalfPi * (squares[j] * by_det + det * fourths[j][m]);
  }
  return found;
}

}  // namespace

LayerSlopes segment_layer_slopes(const std::array<Vec3<double>, 2>& corners, const Vec3<double>& point, double single,
                                 const std::array<double, 2>& doubled) {
  const Vec3<double> first = corners[0] - point, second = corners[1] - point, side = corners[1] - corners[0];
  const double length = side.norm();
  constexpr double far = 3;
  if (((first + second) / 2).norm() > far * length) return segment_by_gauss(first, second, side);
  const Vec3<double> along = side / length, n = quarter_turn(along);
  LayerSlopes found;
  for (int m = 0; m < 2; ++m) {
    const Vec3<double>& y = m == 0 ? first : second;
    const double sign = m == 0 ? -1 : 1, r2 = y.squaredNorm(), potential = -kHalfPi * std::log(r2) / 2;
    found.single[m] = sign * potential * along - doubled[m] * n;
    for (int j = 0; j < 2; ++j) {
      // The hat function's gradient is this times `along`.
      const double slope = (j == 0 ? -1 : 1) / length, slope_of_m = sign / length;
      found.doubled[j][m] = single * slope * slope_of_m * n - doubled[m] * slope * along - sign * potential * slope * n;
    }
    // Across the end moves what the kernel has there.
    found.doubled[m][m] += sign * kHalfPi / r2 * Vec3<double>(-quarter_turn(y));
  }
  return found;
}

}  // namespace cageproof::fast
