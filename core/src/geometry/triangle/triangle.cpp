// SPDX-License-Identifier: MIT
#include "../types.h"

#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/geometry/orientation.h"

#include <algorithm>

namespace cageproof::elements {
namespace {

ContactPoint contact(Corners c, const Vec3<double>& point) {
  const Triangle<double> corner{c[0], c[1], c[2]};
  const Vec3<double> low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]);
  const Vec3<double> high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]);
  if ((point - low).minCoeff() < 0 || (high - point).minCoeff() < 0) return {};
  if (side_of_plane(corner, point) != 0) return {};
  Contact found = Contact::Interior;
  for (int e = 0; e < 3; ++e) {
    const int side = side_of_edge(corner, e, point);
    if (side < 0) return {};
    if (side == 0) found = Contact::Border;
  }
  const ExactTriangle exact({convert<Mp200>(c[0]), convert<Mp200>(c[1]), convert<Mp200>(c[2])}, convert<Mp200>(point));
  ContactPoint at{found, {}};
  for (int k = 0; k < 3; ++k)
    at.basis[k] = static_cast<double>(Mp200(exact.beside[(k + 1) % 3] / exact.normal.dot(exact.normal)));
  return at;
}

Vec3<double> area(Corners c) { return (c[1] - c[0]).cross(c[2] - c[0]); }

bool degenerate(std::span<const Vec3<Mp200>> c) {
  return ExactTriangle({c[0], c[1], c[2]}, c[0]).normal == Vec3<Mp200>::Zero();
}

constexpr std::array<double, 4> a{1, 0, 0, 0}, b{0, 1, 0, 0}, c{0, 0, 1, 0}, ab{.5, .5, 0, 0}, bc{0, .5, .5, 0},
    ca{.5, 0, .5, 0};
constexpr std::array<ElementPart, 4> parts{ElementPart{a, ab, ca}, ElementPart{ab, b, bc}, ElementPart{ca, bc, c},
                                           ElementPart{ab, bc, ca}};
constexpr std::array<std::array<int, 4>, 1> interior_points{std::array{8, 4, 4, 0}};

}  // namespace

const ElementType& triangle() {
  static const ElementType type{.kind = ElementKind::Triangle,
                                .name = "triangle",
                                .corners = 3,
                                .dimension = 3,
                                .flat = true,
                                .degenerate_text = "the triangle is degenerate: its area is zero",
                                .parts = parts,
                                .splits = {},
                                .interior_points = interior_points,
                                .contact = contact,
                                .normal = [](Corners corners, const std::array<double, 4>&) { return area(corners); },
                                .extent = area,
                                .degenerate = degenerate};
  return type;
}

}  // namespace cageproof::elements
