// SPDX-License-Identifier: MIT
// Embedded cages as triangles or segments, in a unit and place, and the points of each regime.
#pragma once

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/coordinates/coordinates.h"
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

class CagePlaces {
 public:
  /// \param unit a power of two that all coordinates are multiplied with \param offset added to them before
  CagePlaces(std::string_view embedded, double unit, const Vec3<double>& offset);

  /// The cage without points.
  const CageQuestion& question() const { return question_; }
  /// A point strictly inside the cage, or exactly on it in regimes "on-..."; nothing where none was found.
  std::optional<Vec3<double>> point(std::string_view regime, std::uint64_t seed, std::uint64_t index) const;

 private:
  Vec3<double> anywhere(RandomStream& random) const;
  Vec3<double> on_cage(std::string_view regime, RandomStream& random) const;

  CageQuestion question_;
  std::shared_ptr<const WindingNumbers> winding_;
  Vec3<double> low_, high_;
};

/// The cages of a regime, which it takes in turn.
const std::vector<CagePlaces>& places_of(std::string_view regime, int dimension);

}  // namespace cageproof::judge
