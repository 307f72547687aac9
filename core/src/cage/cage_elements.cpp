// SPDX-License-Identifier: MIT
#include "cageproof/core/cage/cage_elements.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cageproof {
namespace {

// In a unit in which products neither overflow nor underflow.
std::vector<Vec3<double>> of_unit_size(std::vector<Vec3<double>> corners) {
  double largest = 0;
  for (const Vec3<double>& p : corners) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  for (Vec3<double>& p : corners)
    for (double& x : p) x = std::ldexp(x, -exponent);
  return corners;
}

// xi_u x xi_v at a corner of a bilinear quad.
Vec3<double> area_at_corner(const std::vector<Vec3<double>>& q, std::size_t k) {
  return (q[(k + 1) % 4] - q[k]).cross(q[(k + 3) % 4] - q[k]);
}

// Whether all corners lie on one side of the point along an axis, as those of nearly all elements do.
bool is_beside(const std::vector<Vec3<double>>& vertices, std::span<const int> of_element, const Vec3<double>& point) {
  for (int axis = 0; axis < 3; ++axis) {
    bool below = true, above = true;
    for (const int v : of_element) {
      below = below && vertices[v][axis] < point[axis];
      above = above && vertices[v][axis] > point[axis];
    }
    if (below || above) return true;
  }
  return false;
}

}  // namespace

std::string_view name_of(Owner owner) {
  constexpr std::array<std::string_view, 4> names{"vertex", "element", "corner", "normal"};
  return names[static_cast<std::size_t>(owner)];
}

CageElements::CageElements(const Cage& cage, bool keep_quads, Triangulation rule)
    : CageElements(cage.dimension(), cage.vertices(), cage.parts(keep_quads, rule).elements) {}

CageElements::CageElements(int dimension, std::vector<Vec3<double>> vertices, std::vector<Face> elements)
    : dimension_(dimension), vertices_(std::move(vertices)), elements_(std::move(elements)) {
  for (std::size_t e = 0; e < elements_.size(); ++e)
    normals_.push_back(type(e).extent(of_unit_size(corners(e))).normalized());
  first_corner_.push_back(0);
  for (std::size_t e = 0; e < elements_.size(); ++e) first_corner_.push_back(first_corner_[e] + type(e).corners);
  first_normal_.push_back(0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    if (type(e).flat) {
      corner_normals_.push_back(normals_[e]);
      area_elements_.push_back(1);
      area_exponents_.push_back(0);
    } else {
      // Products of lengths may leave the range that lengths do not.
      std::vector<Vec3<double>> at = corners(e);
      double largest = 0;
      for (const Vec3<double>& corner : at) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
      const int exponent = largest > 0 ? std::ilogb(largest) : 0;
      for (Vec3<double>& corner : at)
        for (double& x : corner) x = std::ldexp(x, -exponent);
      for (std::size_t k = 0; k < at.size(); ++k) {
        const Vec3<double> area = area_at_corner(at, k);
        corner_normals_.push_back(area_at_corner(of_unit_size(at), k).normalized());
        area_elements_.push_back(area.stableNorm());
        area_exponents_.push_back(exponent);
      }
    }
    first_normal_.push_back(static_cast<int>(corner_normals_.size()));
  }
  numbers_.resize(first_corner_.back());
  std::iota(numbers_.begin(), numbers_.end(), 0);
}

std::span<const int> CageElements::vertices_of(std::size_t element) const {
  return std::span(elements_[element].vertices).first(type(element).corners);
}

std::size_t CageElements::count(Owner owner) const {
  switch (owner) {
    case Owner::Vertex: return vertices_.size();
    case Owner::Element: return elements_.size();
    case Owner::Normal: return corner_normals_.size();
    case Owner::Corner: break;
  }
  return first_corner_.back();
}

std::span<const int> CageElements::shares_of(std::size_t element, Owner owner) const {
  switch (owner) {
    case Owner::Vertex: return vertices_of(element);
    case Owner::Element: return std::span(numbers_).subspan(element, 1);
    case Owner::Normal:
      return std::span(numbers_).subspan(first_normal_[element], first_normal_[element + 1] - first_normal_[element]);
    case Owner::Corner: break;
  }
  return std::span(numbers_).subspan(first_corner_[element], type(element).corners);
}

std::size_t CageElements::element_of(std::size_t coordinate, Owner owner) const {
  if (owner == Owner::Element) return coordinate;
  const std::vector<int>& first = owner == Owner::Normal ? first_normal_ : first_corner_;
  return std::ranges::upper_bound(first, static_cast<int>(coordinate)) - first.begin() - 1;
}

Vec3<double> CageElements::normal_of(std::size_t coordinate, Owner owner) const {
  return owner == Owner::Normal ? corner_normals_[coordinate] : normals_[element_of(coordinate, owner)];
}

double CageElements::area_element_in(int exponent, std::size_t coordinate, Owner owner) const {
  if (owner != Owner::Normal || type(element_of(coordinate, owner)).flat) return 1;
  return std::ldexp(area_elements_[coordinate], 2 * (exponent + area_exponents_[coordinate]));
}

std::vector<Vec3<double>> CageElements::corners(std::size_t element) const {
  std::vector<Vec3<double>> found;
  for (const int v : vertices_of(element)) found.push_back(vertices_[v]);
  return found;
}

Vec3<double> CageElements::normal_at(const Touching& touch) const {
  const ElementType& kind = type(touch.element);
  if (kind.flat) return normals_[touch.element];
  return kind.normal(corners(touch.element), touch.basis).normalized();
}

std::vector<Touching> CageElements::touching(const Vec3<double>& point) const {
  std::vector<Touching> found;
  std::array<Vec3<double>, 4> corners;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const auto of_element = vertices_of(e);
    if (is_beside(vertices_, of_element, point)) continue;
    for (std::size_t k = 0; k < of_element.size(); ++k) corners[k] = vertices_[of_element[k]];
    const ContactPoint at = type(e).contact(std::span(corners).first(of_element.size()), point);
    if (at.contact != Contact::Off) found.push_back({static_cast<int>(e), at.basis});
  }
  return found;
}

}  // namespace cageproof
