// SPDX-License-Identifier: MIT
// Where points lie to a cage or to any mesh: inside, on it or outside.
#pragma once

#include "cageproof/core/cage/winding_numbers.h"

#include <memory>
#include <string_view>
#include <vector>

namespace cageproof {

enum class Place { Outside = -1, On = 0, Inside = 1 };

/// "outside", "on", "inside".
std::string_view name_of(Place place);

/// Where a point lies, and how often the surface winds around it.
struct PointPlace {
  Place place = Place::Outside;
  int face = -1;  ///< the first face that the point is on, counted from 0; -1 for none
  /// How often the surface winds around the point: its solid angle over 4 pi. NaN on the surface.
  double winding = 0;
  double bound = 0;  ///< largest error of `winding`; 0 where it is exact
};

/// Asks a cage or a mesh where points lie. Safe from any thread; copies share what was prepared.
class PointPlaces {
 public:
  /// A cage: places and winding numbers are exact, found by a tree. Inside is where the cage winds around the point.
  /// \param keep_quads quads are bilinear surfaces, or else split by `rule`
  PointPlaces(const Cage& cage, bool keep_quads, Triangulation rule);

  /// Any faces in space, closed or not: open meshes, soups, parts that overlap or are turned over. On a face is exact.
  /// Winding numbers are sums of solid angles over all faces, with a bound of the rounding. Where each edge is run
  /// along as often one way as the other, they are whole numbers, and exact. Inside is where they are beyond 1/2 of
  /// either sign, by more than the bound. \param vertices finite \param faces of three or more corners; those without
  /// area are left out \throws InputError for a number that is not finite, an index out of range, and a face that
  /// crosses itself
  PointPlaces(const std::vector<Vec3<double>>& vertices, const std::vector<std::vector<int>>& faces);

  /// Whether all winding numbers are whole: of a cage, or of faces whose edges are all met.
  bool is_closed() const;
  /// \param point in the plane with a third number of zero; of one that is not finite the winding number is NaN, and
  /// the place outside
  PointPlace at(const Vec3<double>& point) const;

  struct Asked;

 private:
  std::shared_ptr<const Asked> asked_;
};

}  // namespace cageproof
