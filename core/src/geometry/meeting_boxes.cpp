// SPDX-License-Identifier: MIT
#include "meeting_boxes.h"

#include "cageproof/core/geometry/box_tree.h"

#include <algorithm>

namespace cageproof {

void for_meeting_boxes(const std::vector<Eigen::AlignedBox3d>& boxes, const std::function<bool(int, int)>& with) {
  std::vector<Box> plain;
  plain.reserve(boxes.size());
  for (const auto& box : boxes) plain.push_back({box.min(), box.max()});
  const BoxTree tree(plain);
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    found.clear();
    tree.for_each_meeting(plain[i], [&](int other) {
      if (other > i && boxes[i].intersects(boxes[other])) found.push_back(other);
      return true;
    });
    std::ranges::sort(found);
    for (const int other : found)
      if (!with(i, other)) return;
  }
}

}  // namespace cageproof
