// SPDX-License-Identifier: MIT
// A cage's boundary as elements, over which coordinates are summed.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/geometry/element.h"

#include <string_view>
#include <vector>

namespace cageproof {

/// An element that a point lies on, exactly, and its corners' basis functions there: hat functions, or bilinear ones.
struct Touching {
  int element;
  std::array<double, 4> basis;
};

/// The owner of one coordinate: a vertex, an element, a corner of an element (numbered element by element), or a
/// normal. A flat element has one normal. A quad, on which the normal turns, has one per corner.
enum class Owner { Vertex, Element, Corner, Normal };

/// "vertex", "element", "corner", "normal".
std::string_view name_of(Owner owner);

/// A cage's faces, quads kept as bilinear surfaces or split in triangles; in the plane its segments. Keeps copies; safe
/// from any thread.
class CageElements {
 public:
  CageElements(const Cage& cage, bool keep_quads, Triangulation rule);
  /// Elements that need not make up a cage. \pre they have lengths or areas, and all vertices are theirs
  CageElements(int dimension, std::vector<Vec3<double>> vertices, std::vector<Face> elements);

  int dimension() const { return dimension_; }
  const std::vector<Vec3<double>>& vertices() const { return vertices_; }
  const std::vector<Face>& all() const { return elements_; }
  std::size_t count() const { return elements_.size(); }
  const ElementType& type(std::size_t element) const { return type_of(elements_[element].kind()); }
  /// The vertices of an element, one per corner.
  std::span<const int> vertices_of(std::size_t element) const;
  std::vector<Vec3<double>> corners(std::size_t element) const;
  /// How many vertices, elements, corners of elements, or normals.
  std::size_t count(Owner owner) const;
  /// The coordinates that an element has a share in, one or one per corner, where each belongs to such an owner.
  std::span<const int> shares_of(std::size_t element, Owner owner) const;
  /// The element that a coordinate belongs to. \pre it is of an element, a corner or a normal
  std::size_t element_of(std::size_t coordinate, Owner owner) const;
  /// Outward unit normals of flat elements; of quads, of their area vectors.
  const std::vector<Vec3<double>>& normals() const { return normals_; }
  /// The outward unit normal that a coordinate multiplies: of its element, or, where quads have one per corner, of the
  /// bilinear surface there. \pre the coordinate is not of a vertex
  Vec3<double> normal_of(std::size_t coordinate, Owner owner) const;
  /// xi_u x xi_v at a quad's corners: the area element there, whose unit vector normal_of() is. One for flat elements.
  double area_element_of(std::size_t coordinate, Owner owner) const { return area_element_in(0, coordinate, owner); }
  /// area_element_of() in the unit of length 2^-exponent.
  double area_element_in(int exponent, std::size_t coordinate, Owner owner) const;
  /// The outward unit normal where a point touches; of a bilinear quad, there.
  Vec3<double> normal_at(const Touching& touch) const;
  /// The elements that the point lies on, border included, decided exactly; the basis functions are rounded.
  std::vector<Touching> touching(const Vec3<double>& point) const;

 private:
  int dimension_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Face> elements_;
  std::vector<Vec3<double>> normals_;
  std::vector<int> first_corner_;             // of each element, and how many there are
  std::vector<int> first_normal_;             // of each element, and how many there are
  std::vector<int> numbers_;                  // 0, 1, 2 ..., as many as corners
  std::vector<Vec3<double>> corner_normals_;  // unit, by Owner::Normal
  std::vector<double> area_elements_;         // likewise, in units of 4^area_exponents_
  std::vector<int> area_exponents_;           // likewise
};

}  // namespace cageproof
