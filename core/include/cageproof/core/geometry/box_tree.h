// SPDX-License-Identifier: MIT
// A tree of boxes, asked which of them meet a box, and in which order they come as one goes away from a point.
#pragma once

#include "cageproof/core/geometry/box.h"

#include <functional>
#include <memory>
#include <vector>

namespace cageproof {

/// Boxes in a packed R-tree (Boost.Geometry). Safe from any thread; copies share it.
class BoxTree {
 public:
  /// \param boxes of finite corners
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `with` for the index of each box that has a point in common with the given one, borders included, in any
  /// order, until it returns false.
  void for_each_meeting(const Box& box, const std::function<bool(int)>& with) const;

  /// Calls `visit` for boxes, the nearest first, as long as they are no further away than the distance that it returned
  /// last. Where squares of distances leave the exponent range, it is called for more boxes.
  void by_distance(const Vec3<double>& from, const std::function<double(int)>& visit) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

/// A box around each element, of its corners.
std::vector<Box> boxes_of(const std::vector<std::vector<Vec3<double>>>& elements);

/// The distance of a point from a box; 0 within it.
double distance_to(const Box& box, const Vec3<double>& point);

}  // namespace cageproof
