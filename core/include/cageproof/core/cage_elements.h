// SPDX-License-Identifier: MIT
// What coordinates are summed over: a cage's boundary as elements.
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/element.h"

#include <vector>

namespace cageproof {

/// An element that a point lies on, exactly, and its corners' basis functions there: hat functions, or bilinear ones.
struct Touching {
  int element;
  std::array<double, 4> basis;
};

/// A cage's faces, quads kept as bilinear surfaces or split in triangles; in the plane its segments. Keeps copies; safe
/// from any thread.
class CageElements {
 public:
  CageElements(const Cage& cage, bool keep_quads, Triangulation rule);

  int dimension() const { return dimension_; }
  const std::vector<Vec3<double>>& vertices() const { return vertices_; }
  const std::vector<Face>& all() const { return elements_; }
  std::size_t count() const { return elements_.size(); }
  const ElementType& type(std::size_t element) const { return type_of(elements_[element].kind()); }
  /// The vertices of an element, as many as it has corners.
  std::span<const int> vertices_of(std::size_t element) const;
  std::vector<Vec3<double>> corners(std::size_t element) const;
  /// Outward unit normals of flat elements; of quads, of their area vectors.
  const std::vector<Vec3<double>>& normals() const { return normals_; }
  /// The outward unit normal where a point touches; of a bilinear quad, there.
  Vec3<double> normal_at(const Touching& touch) const;
  /// The elements that the point lies on, border included, decided exactly; the basis functions are rounded.
  std::vector<Touching> touching(const Vec3<double>& point) const;

 private:
  int dimension_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Face> elements_;
  std::vector<Vec3<double>> normals_;
};

}  // namespace cageproof
