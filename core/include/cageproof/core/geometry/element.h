// SPDX-License-Identifier: MIT
// The elements that formulas live on, and one table of all that depends on an element's kind.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cageproof {

/// 2D segment from v0 to v1 (outward normal to the right of v0 -> v1, so a counter-clockwise polygon's points outward);
/// 3D triangle, counter-clockwise seen from outside; 3D bilinear quad, counter-clockwise, corners q0..q3 at
/// (u,v) = (0,0), (1,0), (1,1), (0,1) ([T18] Eq 2-3).
enum class ElementKind { Segment, Triangle, Quad };

inline constexpr std::array element_kinds{ElementKind::Segment, ElementKind::Triangle, ElementKind::Quad};

/// Where a point lies on an element, decided exactly.
enum class Contact { Off, Interior, Border };

/// A point against an element: where it lies and, where it touches, the corners' basis functions there (hat functions,
/// or bilinear ones), rounded. Entries beyond the element's corners are zero.
struct ContactPoint {
  Contact contact = Contact::Off;
  std::array<double, 4> basis{};
};

/// One part of a subdivided element: each of its corners in basis functions of the whole's corners.
using ElementPart = std::array<std::array<double, 4>, 4>;

/// A way to cut an element into two triangles: the corners that the cut joins, and those of the triangles, in the
/// element's orientation.
struct ElementSplit {
  std::array<int, 2> diagonal;
  std::array<std::array<int, 3>, 2> triangles;
};

/// Corners of an element, as many as its kind has.
using Corners = std::span<const Vec3<double>>;

/// The facts that depend on an element's kind. Other rooms keep their own tables for facts that only they know, such as
/// rules and sampling.
struct ElementType {
  ElementKind kind;
  std::string_view name;  ///< "segment", "triangle", "quad": the first half of formulas' names
  int corners;
  int dimension;                     ///< of the space it lies in: 2 or 3. Points in the plane carry z = 0.
  bool flat;                         ///< one normal everywhere
  std::string_view degenerate_text;  ///< a message's words for an element without length or area
  /// The parts at the edges' midpoints (of quads at u = 1/2 and v = 1/2), each of the same kind.
  std::span<const ElementPart> parts;
  /// The ways to cut it into triangles, that of the fan about the first corner first. Empty: a triangulated cage keeps
  /// it.
  std::span<const ElementSplit> splits;
  /// Basis functions, in 16ths, of points of the interior that doubles hold where the corners have few bits: where
  /// limits are tried.
  std::span<const std::array<int, 4>> interior_points;
  /// Where a point lies on the element, exactly for any finite doubles.
  ContactPoint (*contact)(Corners corners, const Vec3<double>& point);
  /// Normal direction, outward, of no particular length, where the basis functions take these values. Of flat elements
  /// the same everywhere.
  Vec3<double> (*normal)(Corners corners, const std::array<double, 4>& basis);
  /// Length, or twice the area, as a vector: the integral of the normal, up to a factor that is the same for all
  /// elements of the kind.
  Vec3<double> (*extent)(Corners corners);
  /// Whether the element has no length or area. In 200 digits: doubles' products underflow where there is an area.
  bool (*degenerate)(std::span<const Vec3<Mp200>> corners);
};

/// The table's row of a kind.
const ElementType& type_of(ElementKind kind);

/// The kind that has so many corners. \pre there is one
ElementKind kind_with_corners(int corners);

inline int corner_count(ElementKind kind) { return type_of(kind).corners; }
/// Dimension of the space the element lies in: 2 or 3.
inline int dimension(ElementKind kind) { return type_of(kind).dimension; }
inline std::string_view name_of(ElementKind kind) { return type_of(kind).name; }

}  // namespace cageproof
