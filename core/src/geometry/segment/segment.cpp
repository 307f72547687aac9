// SPDX-License-Identifier: MIT
#include "../types.h"

#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/geometry/orientation.h"

namespace cageproof::elements {
namespace {

// Along the larger of the two extents, where the quotient is well conditioned.
ContactPoint contact(Corners corners, const Vec3<double>& point) {
  const Segment<double> s{corners[0], corners[1]};
  const Vec3<double> low = s[0].cwiseMin(s[1]), high = s[0].cwiseMax(s[1]);
  if ((point - low).minCoeff() < 0 || (high - point).minCoeff() < 0) return {};
  if (side_of_line(s, point) != 0) return {};
  if (point == s[0]) return {Contact::Border, {1, 0}};
  if (point == s[1]) return {Contact::Border, {0, 1}};
  const int axis = std::abs(s[1][0] - s[0][0]) >= std::abs(s[1][1] - s[0][1]) ? 0 : 1;
  const Mp200 from = Mp200(s[0][axis]), length = Mp200(s[1][axis]) - from;
  const Mp200 share = (Mp200(point[axis]) - from) / length;
  return {Contact::Interior, {static_cast<double>(Mp200(1 - share)), static_cast<double>(share)}};
}

Vec3<double> outward(Corners corners) {
  const Vec3<double> along = corners[1] - corners[0];
  return {along[1], -along[0], 0};
}

constexpr std::array<double, 4> a{1, 0, 0, 0}, b{0, 1, 0, 0}, ab{.5, .5, 0, 0};
constexpr std::array<ElementPart, 2> parts{ElementPart{a, ab}, ElementPart{ab, b}};
// The last lies between the nodes of four pieces per edge, and their middles.
constexpr std::array<std::array<int, 4>, 3> interior_points{std::array{8, 8, 0, 0}, std::array{12, 4, 0, 0},
                                                            std::array{11, 5, 0, 0}};

}  // namespace

const ElementType& segment() {
  static const ElementType type{
      .kind = ElementKind::Segment,
      .name = "segment",
      .corners = 2,
      .dimension = 2,
      .flat = true,
      .degenerate_text = "the segment is degenerate: its length is zero",
      .parts = parts,
      .splits = {},
      .interior_points = interior_points,
      .contact = contact,
      .normal = [](Corners corners, const std::array<double, 4>&) { return outward(corners); },
      .extent = outward,
      .degenerate = [](std::span<const Vec3<Mp200>> corners) { return corners[0] == corners[1]; }};
  return type;
}

}  // namespace cageproof::elements
