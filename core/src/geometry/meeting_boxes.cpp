// SPDX-License-Identifier: MIT
#include "meeting_boxes.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>

namespace cageproof {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Corner>;
using Tree = bg::index::rtree<std::pair<Box, int>, bg::index::linear<16>>;

Box box_of(const Eigen::AlignedBox3d& box) {
  const auto corner = [](const Eigen::Vector3d& v) { return Corner(v[0], v[1], v[2]); };
  return {corner(box.min()), corner(box.max())};
}

}  // namespace

void for_meeting_boxes(const std::vector<Eigen::AlignedBox3d>& boxes, const std::function<bool(int, int)>& with) {
  std::vector<std::pair<Box, int>> entries;
  entries.reserve(boxes.size());
  for (const auto& box : boxes) entries.emplace_back(box_of(box), static_cast<int>(entries.size()));
  const Tree tree(entries);
  std::vector<std::pair<Box, int>> found;
  for (const auto& [box, index] : entries) {
    found.clear();
    const auto is_later = [first = index](const auto& other) { return other.second > first; };
    tree.query(bg::index::intersects(box) && bg::index::satisfies(is_later), std::back_inserter(found));
    std::ranges::sort(found, {}, &std::pair<Box, int>::second);
    for (const auto& other : found)
      if (!with(index, other.second)) return;
  }
}

}  // namespace cageproof
