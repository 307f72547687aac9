// SPDX-License-Identifier: MIT
#include "cluster_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cageproof::closed_form::batch {
namespace {

// Clusters of at most this many faces are not divided.
constexpr int kLeastCluster = 24;

}  // namespace

ClusterTree::ClusterTree(const Geometry& whole) : whole_(whole), tables_(whole.tables()), faces_(whole.faces()) {
  std::iota(faces_.begin(), faces_.end(), 0);
  add(0, whole.faces());
}

// At the middle one along the widest axis of their centroids.
int ClusterTree::split(int first, int last) {
  int widest = 0;
  double width = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double* const centroid = tables_.centroid + static_cast<std::ptrdiff_t>(axis) * tables_.stride;
    const auto [low, high] = std::minmax_element(faces_.begin() + first, faces_.begin() + last,
                                                 [&](int f, int g) { return centroid[f] < centroid[g]; });
    if (centroid[*high] - centroid[*low] <= width) continue;
    width = centroid[*high] - centroid[*low];
    widest = axis;
  }
  const double* const centroid = tables_.centroid + static_cast<std::ptrdiff_t>(widest) * tables_.stride;
  const int middle = first + (last - first) / 2;
  std::nth_element(faces_.begin() + first, faces_.begin() + middle, faces_.begin() + last,
                   [&](int f, int g) { return std::pair(centroid[f], f) < std::pair(centroid[g], g); });
  return middle;
}

int ClusterTree::add(int first, int last) {
  const int number = static_cast<int>(clusters_.size());
  Cluster cluster{first, last, {-1, -1, -1, -1}, {}, 0, 0, -1};
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  const auto for_corners = [&](auto visit) {
    for (int i = first; i < last; ++i)
      for (const int v : tables_.face[faces_[i]].vertex) visit(tables_.vertex + 3 * static_cast<std::ptrdiff_t>(v));
  };
  for_corners([&](const double* corner) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], corner[axis]);
      high[axis] = std::max(high[axis], corner[axis]);
    }
  });
  for (int axis = 0; axis < 3; ++axis) cluster.centre[axis] = (low[axis] + high[axis]) / 2;
  for_corners([&](const double* corner) {
    cluster.radius = std::max(cluster.radius, std::hypot(corner[0] - cluster.centre[0], corner[1] - cluster.centre[1],
                                                         corner[2] - cluster.centre[2]));
  });
  for (int i = first; i < last; ++i) cluster.area += tables_.face[faces_[i]].area2 / 2;
  clusters_.push_back(cluster);
  if (last - first <= kMostOfPart) {
    clusters_[number].part = static_cast<int>(parts_.size());
    parts_.emplace_back([this, number] {
      ClusterPart part;
      part.geometry = whole_.part(faces(clusters_[number]), part.vertices);
      return part;
    });
  }
  if (last - first <= kLeastCluster) return number;
  const int middle = split(first, last);
  const std::array<int, 5> bounds{first, split(first, middle), middle, split(middle, last), last};
  for (int k = 0; k < 4; ++k) {
    const int child = add(bounds[k], bounds[k + 1]);
    clusters_[number].child[k] = child;
  }
  return number;
}

}  // namespace cageproof::closed_form::batch
