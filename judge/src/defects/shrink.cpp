// SPDX-License-Identifier: MIT
#include "defects/shrink.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace cageproof::judge {
namespace {

using validation::Sample;

constexpr int kMostQuestions = 100;

double rounded(double x, int digits) { return std::stod(fmt::format("{:.{}e}", x, digits - 1)); }

template <class F>
void for_each_coordinate(Sample& sample, int dim, F&& f) {
  for (int i = 0; i < dim; ++i) {
    for (auto& corner : sample.corners) f(corner[i]);
    f(sample.point[i]);
  }
}

Sample at_origin(Sample sample) {
  const Vec3<double> origin = sample.corners[0];
  for (auto& corner : sample.corners) corner -= origin;
  sample.point -= origin;
  return sample;
}

// The point in the frame of two sides and the normal, whose length is that of the first side.
Sample on_unit_triangle(const Sample& sample) {
  const auto& c = sample.corners;
  Eigen::Matrix3d frame;
  const Vec3<double> u = c[1] - c[0], v = c[2] - c[0];
  frame << u, v, u.cross(v).normalized() * u.norm();
  Sample simple = sample;
  simple.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  simple.point = frame.inverse() * (sample.point - c[0]);
  return simple;
}

Sample on_unit_segment(const Sample& sample) {
  const Vec3<double> u = sample.corners[1] - sample.corners[0], p = sample.point - sample.corners[0];
  Sample simple = sample;
  simple.corners = {{0, 0, 0}, {1, 0, 0}};
  simple.point = Vec3<double>(u.dot(p), u[0] * p[1] - u[1] * p[0], 0) / u.squaredNorm();
  return simple;
}

// Coordinates that are roundings of zero.
Sample snapped(Sample sample, int dim) {
  double largest = 0;
  for_each_coordinate(sample, dim, [&](double& x) { largest = std::max(largest, std::abs(x)); });
  for_each_coordinate(sample, dim, [&](double& x) { x = std::abs(x) < 1e-15 * largest ? 0 : x; });
  return sample;
}

Sample in_quarters(Sample sample, int dim) {
  for_each_coordinate(sample, dim, [](double& x) { x = std::abs(x) > 0.1 ? std::round(4 * x) / 4 : x; });
  return sample;
}

// The element with corner `first` first.
Sample begun_at(const Sample& sample, std::size_t first) {
  Sample turned = sample;
  for (std::size_t k = 0; k < sample.corners.size(); ++k)
    turned.corners[k] = sample.corners[(first + k) % sample.corners.size()];
  return turned;
}

// Corners that fall together make another element, even where it has an area.
bool is_degenerate(const Sample& sample, ElementKind element) {
  for (std::size_t k = 1; k < sample.corners.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (sample.corners[j] == sample.corners[k]) return true;
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(sample.corners.size());
  for (const auto& corner : sample.corners) corners.push_back(convert<Mp200>(corner));
  return type_of(element).degenerate(corners);
}

Sample all_rounded(Sample sample, int dim, int digits) {
  for_each_coordinate(sample, dim, [digits](double& x) { x = rounded(x, digits); });
  return sample;
}

}  // namespace

std::size_t length_of(const Sample& sample, int dim) {
  std::size_t length = 0;
  Sample copy = sample;
  for_each_coordinate(
      copy, dim, [&](double& x) { length += fmt::format("{}", x).size() + (x != 0) + (std::abs(x) != 1 && x != 0); });
  return length;
}

Sample shrunk(Sample sample, ElementKind element, const std::function<bool(const Sample&)>& shows) {
  const int dim = dimension(element);
  int questions = 0;
  const auto take = [&](const Sample& simpler) {
    if (!is_finite(simpler) || length_of(simpler, dim) >= length_of(sample, dim) || is_degenerate(simpler, element))
      return false;
    if (++questions > kMostQuestions || !shows(simpler)) return false;
    sample = simpler;
    return true;
  };
  const auto round_all = [&] {
    for (int digits = 1; digits <= 4; ++digits)
      if (take(all_rounded(sample, dim, digits))) return;
  };
  const auto take_unit = [&](const Sample& unit) {
    const Sample simple = snapped(unit, dim);
    if (take(in_quarters(simple, dim))) return true;
    for (const int digits : {1, 2, 17})
      if (take(all_rounded(simple, dim, digits))) return true;
    return false;
  };
  if (element == ElementKind::Segment) take_unit(on_unit_segment(sample));
  if (element == ElementKind::Triangle)
    for (std::size_t first = 0; first < 3; ++first)
      if (take_unit(on_unit_triangle(begun_at(sample, first)))) break;
  take(at_origin(sample));
  round_all();
  for (std::size_t before = 0; before != length_of(sample, dim);) {
    before = length_of(sample, dim);
    for (int i = 0; i < dim; ++i)
      for (std::size_t v = 0; v <= sample.corners.size(); ++v) {
        const auto at = [&](Sample& s) -> double& { return v < s.corners.size() ? s.corners[v][i] : s.point[i]; };
        const double x = at(sample);
        for (const double y : {0.0, x < 0 ? -1.0 : 1.0, rounded(x, 1), rounded(x, 2), rounded(x, 3)}) {
          if (x == 0 || y == x) continue;
          Sample simpler = sample;
          at(simpler) = y;
          if (take(simpler)) break;
        }
      }
  }
  return sample;
}

}  // namespace cageproof::judge
