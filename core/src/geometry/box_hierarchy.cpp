// SPDX-License-Identifier: MIT
#include "box_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cageproof {
namespace {

// Halves, so that no sum overflows.
double middle(const Box& box, int axis) { return box.low[axis] / 2 + box.high[axis] / 2; }

Box box_around(const std::vector<Box>& boxes, const int* first, const int* last) {
  Box all = boxes[*first];
  for (const int* i = first; i != last; ++i) {
    all.low = all.low.cwiseMin(boxes[*i].low);
    all.high = all.high.cwiseMax(boxes[*i].high);
  }
  return all;
}

// The place to cut a range in two: across the axis along which middles are spread furthest, at a multiple of `full`, so
// that nodes are full.
int* cut(const std::vector<Box>& boxes, int* first, int* last, std::ptrdiff_t full) {
  Vec3<double> low = Vec3<double>::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const int* i = first; i != last; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], middle(boxes[*i], axis));
      high[axis] = std::max(high[axis], middle(boxes[*i], axis));
    }
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (high[axis] / 2 - low[axis] / 2 > high[widest] / 2 - low[widest] / 2) widest = axis;
  int* at = first + ((last - first) / 2 + full - 1) / full * full;
  std::nth_element(first, at, last, [&](int a, int b) { return middle(boxes[a], widest) < middle(boxes[b], widest); });
  return at;
}

}  // namespace

BoxHierarchy::BoxHierarchy(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  double largest = 0;
  for (const Box& box : boxes)
    largest = std::max({largest, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
  if (largest > 0) unit_ = std::ldexp(1, std::clamp(-std::ilogb(largest), -1022, 1022));
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const Box all = box_around(boxes, order.data(), order.data() + order.size());
  for (int axis = 0; axis < 3; ++axis) middle_[axis] = unit_ * middle(all, axis);
  nodes_.reserve(boxes.size() / 2 + 1);
  add_node(boxes, order.data(), order.data() + order.size());
}

int BoxHierarchy::add_node(const std::vector<Box>& boxes, int* first, int* last) {
  const auto at = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  // Ranges below the node, ends of one being beginnings of the next.
  std::array<int*, kChildren + 1> ends;
  int count = 0;
  ends[0] = first;
  if (last - first <= kChildren) {
    for (int* i = first; i != last; ++i) ends[++count] = i + 1;
  } else {
    int* half = cut(boxes, first, last, kChildren);
    for (const auto& [from, to] : {std::pair(first, half), std::pair(half, last)}) {
      if (to - from > kChildren) ends[++count] = cut(boxes, from, to, kChildren);
      ends[++count] = to;
    }
  }
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Node node;
  const Floats none{nan, nan, nan, nan};
  node.low.fill(none);
  node.high.fill(none);
  node.child.fill(0);
  for (int k = 0; k < count; ++k) {
    const Box box = box_around(boxes, ends[k], ends[k + 1]);
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis][k] = stored(box.low[axis], axis);
      node.high[axis][k] = stored(box.high[axis], axis);
    }
    node.child[k] = last - first <= kChildren ? -1 - *ends[k] : add_node(boxes, ends[k], ends[k + 1]);
  }
  nodes_[at] = node;
  return at;
}

}  // namespace cageproof
