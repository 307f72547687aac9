// SPDX-License-Identifier: MIT
#include "plane_blocks.h"

#include "cageproof/core/geometry/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::closed_form::batch {
namespace {

// In the tables' unit: squares of squares of larger coordinates leave double's range.
constexpr double kLargest = 0x1p200;

int side_of(const double* from, const double* to, const double* point) {
  const auto at = [](const double* x) { return Vec3<double>(x[0], x[1], 0); };
  return side_of_line(Segment<double>{at(from), at(to)}, at(point));
}

}  // namespace

PlaneRunner::PlaneRunner(const Polygon& polygon, const CageElements&, const Request& request, const Kernels& with)
    : polygon_(polygon),
      kernels_(with),
      tables_(polygon.tables()),
      points_(aligned<double>(2 * kernels_.lanes)),
      columns_(aligned<double>(static_cast<std::size_t>(request.layout.count) * kernels_.lanes)),
      scratch_(aligned<std::byte>(kernels_.plane_scratch_bytes(tables_.vertices))) {
  block_.cage = &tables_;
  block_.layers = request.layers;
  block_.order = request.order;
  block_.beta = request.beta.high;
  block_.unit_log = polygon.exponent() * std::numbers::ln2;
  block_.layout = request.layout;
  block_.points = points_.get();
  block_.columns = columns_.get();
  block_.scratch = scratch_.get();
  block_.side_of = side_of;
}

unsigned PlaneRunner::run(std::span<const Vec3<double>> points) {
  const int lanes = kernels_.lanes;
  unsigned left = 0;
  for (int p = 0; p < lanes; ++p) {
    // A block that is not full goes on with its last point.
    const Vec3<double>& point = points[std::min<std::size_t>(p, points.size() - 1)];
    for (int i = 0; i < 2; ++i) {
      const double x = std::ldexp(point[i], -polygon_.exponent());
      const bool fits = std::abs(x) < kLargest && std::ldexp(x, polygon_.exponent()) == point[i];
      if (!fits) left |= 1u << p;
      points_[i * lanes + p] = fits ? x : 0;
    }
  }
  kernels_.sum_plane(block_);
  return (left | block_.left) & ((1u << points.size()) - 1);
}

}  // namespace cageproof::closed_form::batch
