// SPDX-License-Identifier: MIT
// How elements are sampled, searched and located: one table of all that validation knows of an element's kind.
#pragma once

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/sample.h"

#include <limits>

namespace cageproof::validation {

/// How a regime fills a sample of one kind of element: corners and point of an element of size one (longest edge),
/// before any change of unit.
struct SampleMaker {
  std::string_view regime;
  void (*make)(double parameter, RandomStream& random, Sample& sample);
};

template <Scalar R>
using CornersIn = std::span<const Vec3<R>>;

/// The element itself, without rounding that matters.
struct ExactShape {
  /// How far a point lies outside, times a length that the element gives: zero on the surface (the segment's line, the
  /// triangle's plane, the bilinear surface), negative on its inner side.
  Mp100 (*height)(CornersIn<Mp100> corners, const Vec3<Mp100>& point);
  /// The distance from that surface, with the height's sign.
  Mp200 (*off_surface)(CornersIn<Mp200> corners, const Vec3<Mp200>& point);
  /// The corners' basis functions at a point of the element. \pre the point lies on it
  std::array<Mp100, 4> (*basis)(Corners corners, const Vec3<double>& point);
  /// Outward normal, of no particular length, where the basis functions take these values.
  Vec3<Mp100> (*normal)(CornersIn<Mp100> corners, const std::array<Mp100, 4>& basis);
};

/// Properties of the element that a search for worst inputs uses.
struct SearchShape {
  /// Whether promises hold for such corners at all; corners without length or area are left to `aspect`.
  bool (*valid)(Corners corners);
  /// How thin it is: twice the smallest area of a triangle of successive corners over the longest edge squared; 1 in
  /// the plane, where nothing is thin.
  Mp200 (*aspect)(CornersIn<Mp200> corners);
  /// The point with these parameters, each in [0, 1] on the element (of triangles: and their sum), beyond it elsewhere.
  Vec3<double> (*at)(Corners corners, double s, double r);
  /// The nearest point of the element's line, plane or bilinear surface.
  Vec3<double> (*foot)(Corners corners, const Vec3<double>& point);
  /// Within the element's space, at right angles to one of its edges and as long; on the surface where it has one.
  Vec3<double> (*across)(Corners corners, const Vec3<double>& edge);
};

/// The element as a part of a cage's boundary.
struct LocatorShape {
  /// A lower bound of the distance to a point, at most 0.1 % below it (or 1e-15 of the element's size, next to it).
  /// \param enough the answer may be any bound above this
  double (*distance)(Corners corners, const Vec3<double>& point, double enough);
  /// \param s, r in [0, 1], spread over the whole element
  SurfacePoint (*surface_point)(Corners corners, double s, double r);
};

/// The element that error fields show where no cage is given, and the slice that cuts it and its surroundings.
struct FieldShape {
  std::array<std::array<double, 3>, 4> corners;
  std::array<double, 3> origin;
  std::array<double, 2> extent;  ///< along x and y
};

/// A row of the table.
struct ElementSampling {
  ElementKind kind;
  /// The regimes that exist for the kind.
  std::span<const SampleMaker> regimes;
  /// Starting at the next corner gives the same element.
  bool cyclic;
  /// Edges between successive corners that belong to the element's border, and are shared with neighbours.
  int border_edges;
  ExactShape exact;
  SearchShape search;
  LocatorShape locator;
  FieldShape field;
};

/// The table's row of a kind.
const ElementSampling& sampling_of(ElementKind kind);

/// The longest distance between successive corners.
template <Scalar R>
R longest_edge(CornersIn<R> corners) {
  using std::sqrt;
  R longest = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3<R> edge = corners[(k + 1) % corners.size()] - corners[k];
    longest = std::max(longest, R(edge.dot(edge)));
  }
  return sqrt(longest);
}

// The rows, one folder each.
const ElementSampling& segment_sampling();
const ElementSampling& triangle_sampling();
const ElementSampling& quad_sampling();

}  // namespace cageproof::validation
