// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/winding_number.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/numbers/random_stream.h"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace cageproof {
namespace {

// A ray's crossing of one triangle: +1, -1 or 0, or no answer where the ray meets the border.
using Crossing = std::optional<int>;

// Whether the corners lie on no one line, which they do where all their shadows along axes do.
bool has_area(const Triangle<double>& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto shadow = [&](const Vec3<double>& v) { return Vec3<double>(v[axis], v[(axis + 1) % 3], 0); };
    if (side_of_line({shadow(t[0]), shadow(t[1])}, shadow(t[2])) != 0) return true;
  }
  return false;
}

// Triangles without area have no plane, and edges that others have; no ray meets their inside.
bool lies_on(const Triangle<double>& t, const Vec3<double>& point) {
  if (side_of_plane(t, point) != 0 || !has_area(t)) return false;
  for (int edge = 0; edge < 3; ++edge)
    if (side_of_edge(t, edge, point) < 0) return false;
  return true;
}

// The ray runs from `point` through `through`. \pre the point does not lie on the triangle
Crossing crossing(const Triangle<double>& t, const Vec3<double>& point, const Vec3<double>& through) {
  std::array<int, 3> turns;  // of the edges, seen along the ray
  for (int k = 0; k < 3; ++k) turns[k] = side_of_plane({point, through, t[k]}, t[(k + 1) % 3]);
  if (std::ranges::find(turns, 1) != turns.end() && std::ranges::find(turns, -1) != turns.end()) return 0;
  if (std::ranges::find(turns, 0) != turns.end()) return std::nullopt;
  // The line goes through the triangle along its normal where edges turn to the left; the ray does if it begins before.
  return side_of_plane(t, point) == -turns[0] ? turns[0] : 0;
}

// A point that a ray from the origin of all goes through, somewhere about as far away as the surface is large.
Vec3<double> target(const Vec3<double>& low, const Vec3<double>& high, std::uint64_t attempt) {
  RandomStream random(0, "winding number", attempt);
  Vec3<double> at;
  for (int c = 0; c < 3; ++c) {
    const double share = random.uniform();
    at[c] = (1 - share) * low[c] + share * high[c];
  }
  return at;
}

}  // namespace

std::optional<int> winding_number(std::span<const Triangle<double>> triangles, const Vec3<double>& point) {
  if (triangles.empty()) return 0;
  const auto [low, high] = box_of(std::views::join(triangles));
  if ((point.array() < low.array()).any() || (point.array() > high.array()).any()) return 0;
  for (const Triangle<double>& t : triangles)
    if (lies_on(t, point)) return std::nullopt;
  for (std::uint64_t attempt = 0;; ++attempt) {
    const Vec3<double> through = target(low, high, attempt);
    if (through == point) continue;
    int winding = 0;
    bool clear = true;
    for (const Triangle<double>& t : triangles) {
      const Crossing found = crossing(t, point, through);
      if (!found && !has_area(t)) continue;
      clear = found.has_value();
      if (!clear) break;
      winding += *found;
    }
    if (clear) return winding;
  }
}

std::optional<int> winding_number(std::span<const Segment<double>> segments, const Vec3<double>& point) {
  // A ray along the first axis; an end on it counts as just above, so that no ray is refused.
  int winding = 0;
  for (const Segment<double>& s : segments) {
    const Vec3<double> low = s[0].cwiseMin(s[1]), high = s[0].cwiseMax(s[1]);
    const int side = side_of_line(s, point);
    if (side == 0 && low[0] <= point[0] && point[0] <= high[0] && low[1] <= point[1] && point[1] <= high[1])
      return std::nullopt;
    const bool from_below = s[0][1] < point[1], to_below = s[1][1] < point[1];
    if (from_below == to_below) continue;
    // An upward segment has what lies to its left before it.
    if (from_below && side < 0) ++winding;
    if (to_below && side > 0) --winding;
  }
  return winding;
}

}  // namespace cageproof
