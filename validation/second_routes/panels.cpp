// SPDX-License-Identifier: MIT
#include "panels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::second_routes {

GaussRule::GaussRule(int count) {
  for (int i = 0; i < count; ++i) {
    // Newton's method for the zeros of the Legendre polynomial, which doubles its digits each time.
    constexpr int steps = 8;
    Mp100 x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope;
    for (int step = 0; step < steps; ++step) {
      Mp100 before = 1, here = x;
      for (int k = 2; k <= count; ++k) {
        const Mp100 next = ((2 * k - 1) * x * here - (k - 1) * before) / k;
        before = here;
        here = next;
      }
      slope = count * (x * here - before) / (x * x - 1);
      x -= here / slope;
    }
    nodes.push_back((1 + x) / 2);
    weights.push_back(1 / ((1 - x * x) * slope * slope));
  }
}

const GaussRule& gauss_rule() {
  constexpr int count = 52;
  static const GaussRule rule(count);
  return rule;
}

std::vector<double> panel_ends(const std::vector<std::complex<double>>& poles) {
  constexpr double shortest = 0x1p-60;  // a pole on [0, 1] itself has no integral
  std::vector<double> ends{0}, open{1};
  while (!open.empty()) {
    const double from = ends.back(), to = open.back(), middle = (from + to) / 2;
    const bool is_near = std::ranges::any_of(
        poles, [&](const std::complex<double>& pole) { return std::abs(pole - middle) < to - from; });
    if (is_near && to - from > shortest) {
      open.push_back(middle);
    } else {
      ends.push_back(to);
      open.pop_back();
    }
  }
  return ends;
}

std::vector<std::complex<double>> zeros_of_length(const Vec3<double>& a, const Vec3<double>& b) {
  const Vec3<double> along = b - a;
  const double square = along.squaredNorm();
  if (!(square > 0)) return {};
  // The foot of the origin on the line, and the origin's distance from it.
  const double foot = -a.dot(along) / square, height = a.cross(b).norm() / square;
  return {{foot, height}, {foot, -height}};
}

}  // namespace cageproof::second_routes
