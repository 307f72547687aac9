// SPDX-License-Identifier: MIT
#include "boundary_points.h"

#include "cageproof/core/numbers/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::solved::goursat {

std::vector<FramePoint> boundary_points(const PolygonFrame& frame, int least, double phase) {
  constexpr int kFewest = 16;  // of an edge
  double perimeter = 0;
  for (int k = 0; k < frame.size(); ++k) perimeter += frame.length(k);
  std::vector<FramePoint> points;
  for (int k = 0; k < frame.size(); ++k) {
    // Half by number, since every corner needs its share, half by length.
    const double share = 0.5 / frame.size() + 0.5 * frame.length(k) / perimeter;
    const int n = std::max(kFewest, static_cast<int>(std::ceil(least * share)));
    for (int i = 0; i < n; ++i) {
      const double quarter = std::numbers::pi / 2 * (i + phase) / n;
      points.push_back({k, std::pow(std::sin(quarter), 2), std::pow(std::cos(quarter), 2)});
    }
  }
  return points;
}

EdgePoint edge_point(const PolygonFrame& frame, const FramePoint& p) {
  const Segment<double>& s = frame.segments()[p.edge];
  const Complex<double> e = frame.edge(p.edge);
  const double length = frame.length(p.edge);
  const Vec3<double> along(e.re / length, e.im / length, 0);
  const Vec3<double> point =
      p.from_start < p.from_end ? s[0] + p.from_start * (s[1] - s[0]) : s[1] + p.from_end * (s[0] - s[1]);
  return {frame.face_of_edge(p.edge), p.from_start, p.from_end, point, along, {along[1], -along[0], 0}};
}

}  // namespace cageproof::solved::goursat
