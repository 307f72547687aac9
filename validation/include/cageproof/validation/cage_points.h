// SPDX-License-Identifier: MIT
// Points to try a cage at, and where they lie, found without any coordinate formula.
#pragma once

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/coordinates/coordinates.h"

#include <cstdint>
#include <string_view>

namespace cageproof::validation {

/// Where a point lies; `TooClose`: off the cage, but nearer than 1e-6 of its size.
enum class Place { Inside, Outside, OnFace, OnEdge, OnVertex, TooClose };

std::string_view name_of(Place place);

/// A point of the surface and the outward unit normal there.
struct SurfacePoint {
  Vec3<double> point, normal;
};

/// A cage's boundary that answers where points lie: its segments, or its surface, triangulated or with its quads kept
/// as bilinear surfaces.
class CageLocator {
 public:
  CageLocator(const Cage& cage, Triangulation rule, bool keep_quads = false);

  int patches() const { return static_cast<int>(patches_.size()); }
  /// A point of one boundary element. \param s, r in [0, 1]; a segment uses only s
  SurfacePoint surface_point(int patch, double s, double r) const;
  /// Distance to the cage; a lower bound at most 0.1 % below it where bilinear quads are near.
  double distance(const Vec3<double>& point) const;
  /// The distance to those elements that are not named.
  double distance_but_to(std::span<const Touching> named, const Vec3<double>& point) const;
  /// How often the cage winds around a point off it, exactly: 1 inside, 0 outside, other numbers where faces cross.
  int winding(const Vec3<double>& point) const { return windings_.around(point).value_or(0); }
  /// Whether the cage winds around a point off it.
  bool inside(const Vec3<double>& point) const { return winding(point) > 0; }
  /// Inside, Outside or TooClose. \pre the point does not lie on the cage
  Place place(const Vec3<double>& point) const;

  /// Distance, in cage sizes, from which bounds are promised.
  static constexpr double promised_distance = 1e-6;

 private:
  struct Patch {
    ElementKind kind;
    std::vector<Vec3<double>> corners;
  };
  CageLocator(const CageElements& elements, double size);

  std::vector<Patch> patches_;
  WindingNumbers windings_;
  double size_;
};

struct CagePoint {
  Vec3<double> point;
  Place place;
  std::uint64_t index;
  bool exact = false;  ///< of points_on(): doubles hold the point that was meant, so that it lies on the cage
};

/// `count` points off the cage: in the box half as large again, and next to faces at 1e-1 ... 1e-6 sizes on both sides;
/// point i is a function of (seed, cage name, i).
std::vector<CagePoint> points_off(const Cage& cage, const CageLocator& locator, std::uint64_t seed, int count);

/// All vertices, midpoints of edges that elements share, and points within each element (ElementType::interior_points):
/// where doubles represent them exactly, they lie on the cage.
std::vector<CagePoint> points_on(const CageCoordinates& coordinates, const Cage& cage);

}  // namespace cageproof::validation
