// SPDX-License-Identifier: MIT
#include "../types.h"

#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>

namespace cageproof::elements {
namespace {

Quad<double> quad_of(Corners c) { return {c[0], c[1], c[2], c[3]}; }

ContactPoint contact(Corners corners, const Vec3<double>& point) {
  const auto on = on_quad(quad_of(corners), point);
  if (!on) return {};
  // On a side two of the bilinear basis functions vanish exactly.
  const bool border = std::ranges::any_of(on->basis, [](double x) { return x == 0; });
  return {border ? Contact::Border : Contact::Interior, on->basis};
}

Vec3<double> normal(Corners q, const std::array<double, 4>& basis) {
  const double u = basis[1] + basis[2], v = basis[2] + basis[3];
  const Vec3<double> along_u = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]),
                     along_v = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
  return along_u.cross(along_v);
}

Vec3<double> area(Corners q) { return (q[2] - q[0]).cross(q[3] - q[1]); }

// A bilinear quad has no area where all its corners lie on one line.
bool degenerate(std::span<const Vec3<Mp200>> q) {
  const auto has_area = [&](int i, int k) {
    return ExactTriangle({q[0], q[i], q[k]}, q[0]).normal != Vec3<Mp200>::Zero();
  };
  return !has_area(1, 2) && !has_area(1, 3) && !has_area(2, 3);
}

constexpr std::array<double, 4> a{1, 0, 0, 0}, b{0, 1, 0, 0}, c{0, 0, 1, 0}, d{0, 0, 0, 1}, ab{.5, .5, 0, 0},
    bc{0, .5, .5, 0}, cd{0, 0, .5, .5}, da{.5, 0, 0, .5}, middle{.25, .25, .25, .25};
constexpr std::array<ElementPart, 4> parts{ElementPart{a, ab, middle, da}, ElementPart{ab, b, bc, middle},
                                           ElementPart{middle, bc, c, cd}, ElementPart{da, middle, cd, d}};
constexpr std::array<ElementSplit, 2> splits{ElementSplit{{0, 2}, {std::array{0, 1, 2}, std::array{0, 2, 3}}},
                                             ElementSplit{{1, 3}, {std::array{1, 2, 3}, std::array{1, 3, 0}}}};
// u = v = 1/2 and u = v = 1/4.
constexpr std::array<std::array<int, 4>, 2> interior_points{std::array{4, 4, 4, 4}, std::array{9, 3, 1, 3}};

}  // namespace

const ElementType& quad() {
  static const ElementType type{.kind = ElementKind::Quad,
                                .name = "quad",
                                .corners = 4,
                                .dimension = 3,
                                .flat = false,
                                .degenerate_text = "the quad is degenerate: all its corners lie on one line",
                                .parts = parts,
                                .splits = splits,
                                .interior_points = interior_points,
                                .contact = contact,
                                .normal = normal,
                                .extent = area,
                                .degenerate = degenerate};
  return type;
}

}  // namespace cageproof::elements
