// SPDX-License-Identifier: MIT
// Embedded cages as triangles or segments, in a unit and place, and the points of each regime.
#pragma once

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/geometry/box.h"
#include "cageproof/judge/whole_cage.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace cageproof {
class RandomStream;
}

namespace cageproof::judge {

/// How an embedded cage is placed.
struct Placing {
  double unit = 1;                             ///< a power of two that all coordinates are multiplied with, at the end
  Vec3<double> offset = Vec3<double>::Zero();  ///< added to them before
  bool keeps_quads = false;
  bool is_sheared = false;  ///< by multiples of a quarter first, so that no face is parallel to the axes
};

class CagePlaces {
 public:
  CagePlaces(std::string_view embedded, const Placing& placing);
  explicit CagePlaces(CageRequest cage, bool keeps_quads = false);

  /// The cage without points.
  const CageRequest& question() const { return question_; }
  /// A point strictly inside the cage, or exactly on it in regimes "on-..."; nothing where none was found.
  std::optional<Vec3<double>> point(std::string_view regime, std::uint64_t seed, std::uint64_t index) const;
  /// A point on either side, or on the cage, in a regime of side_regimes().
  Vec3<double> point_on_any_side(std::string_view regime, std::uint64_t seed, std::uint64_t index) const;
  /// 1 inside, 0 on the cage, -1 outside, exactly.
  int side_of(const Vec3<double>& point) const;

 private:
  Vec3<double> anywhere(RandomStream& random) const;
  Vec3<double> on_cage(std::string_view regime, RandomStream& random) const;

  CageRequest question_;
  std::shared_ptr<const WindingNumbers> winding_;
  Box box_;
};

/// The cages of a regime, which it takes in turn.
const std::vector<CagePlaces>& places_of(std::string_view regime, int dimension, bool keeps_quads = false);

}  // namespace cageproof::judge
