// SPDX-License-Identifier: MIT
// The elements that formulas live on.
#pragma once

#include "cageproof/core/linear.h"

#include <array>
#include <string_view>

namespace cageproof {

/// 2D segment from v0 to v1 (outward normal to the right of v0 -> v1, so a counter-clockwise polygon's points outward);
/// 3D triangle, counter-clockwise seen from outside; 3D bilinear quad, counter-clockwise, corners q0..q3 at
/// (u,v) = (0,0), (1,0), (1,1), (0,1) ([T18] Eq 2-3).
enum class ElementKind { Segment, Triangle, Quad };

constexpr int corner_count(ElementKind kind) {
  return kind == ElementKind::Segment ? 2 : kind == ElementKind::Triangle ? 3 : 4;
}

/// Dimension of the space the element lies in: 2 or 3. Points of a 2D element carry z = 0.
constexpr int dimension(ElementKind kind) { return kind == ElementKind::Segment ? 2 : 3; }

constexpr std::string_view name_of(ElementKind kind) {
  return kind == ElementKind::Segment ? "segment" : kind == ElementKind::Triangle ? "triangle" : "quad";
}

template <class R>
using Segment = std::array<Vec3<R>, 2>;
template <class R>
using Triangle = std::array<Vec3<R>, 3>;
template <class R>
using Quad = std::array<Vec3<R>, 4>;

}  // namespace cageproof
