// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box_tree.h"

#include "box_hierarchy.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {
namespace {

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using TreeBox = boost::geometry::model::box<TreePoint>;

TreePoint tree_point(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }

// Squares of lengths are compared, in a unit in which those of the boxes stay within range.
double unit_of(const std::vector<Box>& boxes) {
  double largest = 0;
  for (const Box& box : boxes)
    largest = std::max({largest, box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()});
  return largest > 0 ? std::ldexp(1, std::clamp(-std::ilogb(largest), -1000, 1000)) : 1;
}

}  // namespace

struct BoxTree::Tree {
  using Entry = std::pair<TreeBox, int>;
  std::vector<Box> boxes;
  BoxHierarchy hierarchy;  // for what meets
  double unit;
  boost::geometry::index::rtree<Entry, boost::geometry::index::linear<16>> entries;

  TreeBox scaled(const Box& box) const { return {tree_point(unit * box.low), tree_point(unit * box.high)}; }
  std::vector<Entry> entries_of() const {
    std::vector<Entry> all;
    all.reserve(boxes.size());
    for (const Box& box : boxes) all.emplace_back(scaled(box), static_cast<int>(all.size()));
    return all;
  }
  explicit Tree(const std::vector<Box>& given)
      : boxes(given), hierarchy(given), unit(unit_of(given)), entries(entries_of()) {}
};

BoxTree::BoxTree(const std::vector<Box>& boxes) : tree_(std::make_shared<const Tree>(boxes)) {}

void BoxTree::for_each_meeting(const Box& box, const std::function<bool(int)>& with) const {
  tree_->hierarchy.for_each_meeting(box, [&](int i) {
    const Box& found = tree_->boxes[i];
    const bool meets = (found.low.array() <= box.high.array()).all() && (box.low.array() <= found.high.array()).all();
    return !meets || with(i);
  });
}

void BoxTree::by_distance(const Vec3<double>& from, const std::function<double(int)>& visit) const {
  constexpr double far = 1e150;
  const Vec3<double> point = tree_->unit * from;
  double enough = std::numeric_limits<double>::infinity();
  if (!(point.cwiseAbs().maxCoeff() < far)) {
    for (std::size_t i = 0; i < tree_->boxes.size(); ++i)
      if (distance_to(tree_->boxes[i], from) <= enough) enough = visit(static_cast<int>(i));
    return;
  }
  const auto nearest = boost::geometry::index::nearest(
      tree_point(point), static_cast<unsigned>(std::max<std::size_t>(1, tree_->boxes.size())));
  for (auto entry = tree_->entries.qbegin(nearest); entry != tree_->entries.qend(); ++entry) {
    if (distance_to(tree_->boxes[entry->second], from) > enough) return;
    enough = visit(entry->second);
  }
}

std::vector<Box> boxes_of(const std::vector<std::vector<Vec3<double>>>& elements) {
  std::vector<Box> boxes;
  boxes.reserve(elements.size());
  for (const auto& corners : elements) boxes.push_back(box_of(corners));
  return boxes;
}

double distance_to(const Box& box, const Vec3<double>& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).stableNorm();
}

}  // namespace cageproof
