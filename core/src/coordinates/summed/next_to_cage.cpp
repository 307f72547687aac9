// SPDX-License-Identifier: MIT
#include "next_to_cage.h"

#include "cageproof/core/geometry/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {
namespace {

// Distances from an element, over its longest edge, below which derivatives of that order take more digits: about 2^10
// roundings are lost there.
constexpr std::array<double, 3> kNextTo{0, 0x1p-9, 0x1p-5};
// Distances below which elements have more digits where any element is next to the point: neighbours are parts of the
// same quotient.
constexpr double kBesideIt = 0x1p-3;

}  // namespace

NextToCage::NextToCage(const CageElements& elements, int exponent)
    : exponent_(exponent), is_simplex_(static_cast<int>(elements.count()) == elements.dimension() + 1) {
  for (std::size_t e = 0; e < elements.count(); ++e) {
    Element& to = elements_.emplace_back();
    const auto vertices = elements.vertices_of(e);
    to.count = static_cast<int>(vertices.size());
    for (int k = 0; k < to.count; ++k) {
      to.corners[k] = elements.vertices()[vertices[k]];
      for (double& x : to.corners[k]) x = std::ldexp(x, -exponent_);
      to.centre += to.corners[k] / to.count;
    }
    for (int k = 0; k < to.count; ++k) {
      to.radius = std::max(to.radius, (to.corners[k] - to.centre).norm());
      to.length = std::max(to.length, (to.corners[(k + 1) % to.count] - to.corners[k]).norm());
    }
  }
}

double NextToCage::Element::distance(const Vec3<double>& point) const {
  const double beyond = (point - centre).norm() - radius;
  if (!(beyond < kBesideIt * length)) return std::numeric_limits<double>::infinity();
  return (nearest_place(std::span(corners).first(count), point).place - point).norm();
}

NextToCage::Found NextToCage::at(const Vec3<double>& point, int order) const {
  Vec3<double> seen = point;
  for (double& x : seen) x = std::ldexp(x, -exponent_);
  Found found;
  std::vector<char> beside(elements_.size(), 0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const double distance = elements_[e].distance(seen), length = elements_[e].length;
    beside[e] = distance < kBesideIt * length;
    for (int o = order; o >= 1; --o)
      if (distance < kNextTo[o] * length) found.order = std::min(found.order, o);
  }
  // A simplex's coordinates are linear: of their Hessians there is nothing but what elements leave.
  if (is_simplex_) std::ranges::fill(beside, 1);
  if (found.order <= order) found.elements = std::move(beside);
  return found;
}

}  // namespace cageproof
