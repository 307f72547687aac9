// SPDX-License-Identifier: MIT
// Points to try a cage at, and where they lie, found without any coordinate formula.
#pragma once

#include "cageproof/core/cage.h"

#include <cstdint>
#include <string_view>

namespace cageproof::validation {

/// Where a point lies; `TooClose`: off the cage, but nearer than 1e-6 of its size.
enum class Place { Inside, Outside, OnFace, OnEdge, OnVertex, TooClose };

std::string_view name_of(Place place);

/// A triangulated cage that answers where points lie.
class CageLocator {
 public:
  CageLocator(const Cage& cage, Triangulation rule);

  /// Distance to the cage.
  double distance(const Vec3<double>& point) const;
  /// Whether a point off the cage lies inside, by the parity of the crossings of a ray.
  bool inside(const Vec3<double>& point) const;
  /// Inside, Outside or TooClose. \pre the point does not lie on the cage
  Place place(const Vec3<double>& point) const;

  /// Distance, in cage sizes, from which bounds are promised.
  static constexpr double promised_distance = 1e-6;

 private:
  std::vector<std::array<Vec3<double>, 3>> triangles_;
  double size_;
};

struct CagePoint {
  Vec3<double> point;
  Place place;
  std::uint64_t index;
};

/// `count` points off the cage: in the box half as large again, and next to faces at 1e-1 ... 1e-6 sizes on both sides; point i is a
/// function of (seed, cage name, i).
std::vector<CagePoint> points_off(const Cage& cage, const CageLocator& locator, Triangulation rule, std::uint64_t seed, int count);

/// All vertices, and of edge midpoints and points of triangles those that doubles represent exactly on the cage.
std::vector<CagePoint> points_on(const Cage& cage, Triangulation rule);

}  // namespace cageproof::validation
