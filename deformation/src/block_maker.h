// SPDX-License-Identifier: MIT
// Coordinates of many points, in blocks that share what evaluations prepare for an element.
#pragma once

#include "extended.h"

#include "cageproof/deformation/point_images.h"

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {

/// Whether no coordinate of a point is NaN.
inline bool has_coordinates(const std::vector<CoordinateTable<double>>& tables, std::size_t p) {
  return std::ranges::none_of(tables, [&](const CoordinateTable<double>& table) {
    const auto row = std::span(table.tensors[0]).subspan(p * table.stride[0], table.stride[0]);
    bool any = false;  // without leaving early, so that it takes vectors
    for (const double x : row) any |= std::isnan(x);
    return any;
  });
}

/// Points that come together.
struct BlockPart {
  std::size_t first, count;
};

inline BlockPart part_of(std::size_t block, std::size_t length, std::size_t points) {
  return {block * length, std::min(length, points - block * length)};
}

/// As a number that may be larger than integers are.
inline double numbers_of_point(const CageCoordinates& coordinates, int order) {
  double numbers = 0;
  for (const CoordinateBlock& block : coordinates.blocks())
    for (int o = 0; o <= order; ++o)
      numbers += static_cast<double>(block.size) * block.entries() *
                 static_cast<double>(derivative_count(coordinates.dimension(), o));
  return numbers;
}

/// How many points come together: so many that their numbers take 64 MB, a few at least.
inline std::size_t block_length(double numbers, std::size_t most) {
  constexpr double fitting = 1 << 23, least = 16;
  return static_cast<std::size_t>(std::min(static_cast<double>(most), std::max(least, fitting / numbers)));
}

/// Makes coordinates of blocks of points, and says which points have none.
class BlockMaker {
 public:
  BlockMaker(const CageCoordinates& coordinates, std::span<const Vec3<double>> points, const ImageRun& run,
             const std::optional<Inside>& region)
      : coordinates_(coordinates),
        points_(points),
        run_(run),
        region_(region),
        length_(block_length(numbers_of_point(coordinates, run.order), run.block)) {
    if (run.extend) extended_.emplace(coordinates);
  }

  std::size_t length() const { return length_; }
  std::size_t count() const { return (points_.size() + length_ - 1) / length_; }
  BlockPart part(std::size_t block) const { return part_of(block, length_, points_.size()); }

  /// \param missing, beyond as of PointImages, of all points
  void make(std::size_t block, std::vector<CoordinateTable<double>>& tables, std::vector<char>& missing,
            std::vector<double>& beyond) const {
    const auto [first, count] = part(block);
    coordinates_.at(points_.subspan(first, count), run_.order, tables);
    for (std::size_t p = 0; p < count; ++p) {
      const bool outside = region_ && !region_->holds(points_[first + p]);
      if (outside && extended_) beyond[first + p] = extended_->add_to(tables, p, points_[first + p], run_.order);
      missing[first + p] = static_cast<char>((outside && !extended_) || !has_coordinates(tables, p));
    }
  }

 private:
  const CageCoordinates& coordinates_;
  std::span<const Vec3<double>> points_;
  const ImageRun& run_;
  const std::optional<Inside>& region_;
  std::size_t length_;
  std::optional<Extended> extended_;
};

}  // namespace cageproof::deformation
