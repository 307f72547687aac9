// SPDX-License-Identifier: MIT
// Boxes within boxes, for many quick questions which of them a point, a ray along an axis or a box meets.
#pragma once

#include "cageproof/core/geometry/box.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace cageproof {

/// A tree of boxes with four below each: a question costs some ten nanoseconds per box above those that are met, and
/// allocates nothing. Safe from any thread. BoxTree is what others use.
class BoxHierarchy {
 public:
  /// \param boxes of finite corners
  explicit BoxHierarchy(const std::vector<Box>& boxes);

  /// Calls `with` for the index of each box that has a point in common with the given one, borders included, and
  /// perhaps of some that are next to it, in any order, until it returns false. Corners of the given box may be
  /// infinite; nothing meets one with NaN.
  template <class With>
  void for_each_meeting(const Box& box, With&& with) const {
    if (nodes_.empty()) return;
    std::array<float, 3> low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = stored(box.low[axis], axis);
      high[axis] = stored(box.high[axis], axis);
    }
    // A level leaves at most three nodes behind, and there are at most 32 / log2(4) levels.
    std::array<int, 64> left;
    int count = 0;
    left[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[left[--count]];
      for (unsigned meeting = meeting_children(node, low, high); meeting != 0; meeting &= meeting - 1) {
        const int child = node.child[std::countr_zero(meeting)];
        if (child >= 0) left[count++] = child;
        else if (!with(-child - 1)) return;
      }
    }
  }

 private:
  static constexpr int kChildren = 4;
  // Four at once, as GCC and Clang know them.
  using Floats = float __attribute__((vector_size(kChildren * sizeof(float))));
  using Meets = int __attribute__((vector_size(kChildren * sizeof(int))));
  struct alignas(64) Node {
    std::array<Floats, 3> low, high;   // by axis; NaN where there is no child
    std::array<int, kChildren> child;  // a node, or of a box -1 - index
  };

  // The float that stands for a coordinate. It never falls where the coordinate rises: boxes that meet do so as they
  // are stored.
  float stored(double x, int axis) const {
    return static_cast<float>(std::clamp(unit_ * x - middle_[axis], -8.0, 8.0));
  }

  // A bit for each child that meets the box.
  static unsigned meeting_children(const Node& node, const std::array<float, 3>& low,
                                   const std::array<float, 3>& high) {
    Meets meets = (node.low[0] <= high[0]) & (node.high[0] >= low[0]);
    meets &= (node.low[1] <= high[1]) & (node.high[1] >= low[1]);
    meets &= (node.low[2] <= high[2]) & (node.high[2] >= low[2]);
#ifdef __SSE2__
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(meets)));
#else
    meets &= Meets{1, 2, 4, 8};
    return static_cast<unsigned>(meets[0] | meets[1] | meets[2] | meets[3]);
#endif
  }

  int add_node(const std::vector<Box>& boxes, int* first, int* last);

  double unit_ = 1;                             // a power of two
  Vec3<double> middle_ = Vec3<double>::Zero();  // of all boxes, in that unit
  std::vector<Node> nodes_;                     // the first is above all others
};

}  // namespace cageproof
