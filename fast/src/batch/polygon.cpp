// SPDX-License-Identifier: MIT
#include "polygon.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/numbers/mp.h"

#include <cmath>

namespace cageproof::closed_form::batch {
namespace {

SideTable side_between(int from, int to, const std::vector<double>& vertex) {
  std::array<Mp50, 2> e;
  for (int i = 0; i < 2; ++i) e[i] = Mp50(vertex[2 * to + i]) - vertex[2 * from + i];
  const Mp50 square = e[0] * e[0] + e[1] * e[1], length = sqrt(square);
  SideTable side{};
  side.from = from;
  side.to = to;
  side.length = static_cast<double>(length);
  side.square = static_cast<double>(square);
  for (int i = 0; i < 2; ++i) {
    side.e[i] = static_cast<double>(e[i]);
    side.u[i] = static_cast<double>(Mp50(e[i] / length));
    side.over[i] = static_cast<double>(Mp50((i == 0 ? e[i] : Mp50(-e[i])) / square));
  }
  return side;
}

}  // namespace

Polygon::Polygon(const CageElements& elements) {
  const auto [low, high] = box_of(elements.vertices());
  const double size = (high / 2 - low / 2).cwiseAbs().maxCoeff();
  sound_ = size > 0 && std::isfinite(size);
  if (!sound_) return;
  exponent_ = std::ilogb(size) + 1;
  for (const Vec3<double>& v : elements.vertices())
    for (int i = 0; i < 2; ++i) {
      vertex_.push_back(std::ldexp(v[i], -exponent_));
      sound_ = sound_ && std::ldexp(vertex_.back(), exponent_) == v[i];
    }
  for (std::size_t s = 0; s < elements.count(); ++s) {
    const auto ends = elements.vertices_of(s);
    side_.push_back(side_between(ends[0], ends[1], vertex_));
    sound_ =
        sound_ && side_.back().square > 0 && std::isfinite(side_.back().over[0]) && std::isfinite(side_.back().over[1]);
  }
}

PolygonTables Polygon::tables() const {
  return {static_cast<int>(vertex_.size() / 2), static_cast<int>(side_.size()), vertex_.data(), side_.data()};
}

}  // namespace cageproof::closed_form::batch
