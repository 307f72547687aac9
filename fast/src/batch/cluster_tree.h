// SPDX-License-Identifier: MIT
// Clusters of a cage's faces within clusters, and the faces of the least ones as parts that kernels sum by themselves.
#pragma once

#include "geometry.h"

#include "cageproof/core/lazy.h"

#include <array>
#include <deque>
#include <span>
#include <vector>

namespace cageproof::closed_form::batch {

/// Faces that are near each other, in the unit of Geometry.
struct Cluster {
  int first, last;           ///< of ClusterTree::faces()
  std::array<int, 4> child;  ///< their numbers, -1 where there is none
  std::array<double, 3> centre;
  double radius;  ///< of a ball about the centre that holds the faces
  double area;    ///< of the faces together
  int part;       ///< of clusters of few faces: the number of ClusterTree::part; else -1

  int size() const { return last - first; }
  bool has_others_within() const { return child[0] >= 0; }
};

/// The faces of a cluster as tables of their own.
struct ClusterPart {
  Geometry geometry;
  std::vector<int> vertices;  ///< of the cage, by the part's numbers
};

/// Safe from any thread.
class ClusterTree {
 public:
  /// Faces of the largest clusters that are parts.
  static constexpr int kMostOfPart = 128;

  /// \param whole must outlive it \pre it is sound
  explicit ClusterTree(const Geometry& whole);

  const Geometry& whole() const { return whole_; }
  /// All clusters. The first has all faces; each cluster comes before those within it.
  const std::vector<Cluster>& clusters() const { return clusters_; }
  std::span<const int> faces(const Cluster& cluster) const {
    return std::span(faces_).subspan(cluster.first, cluster.last - cluster.first);
  }
  const ClusterPart& part(int number) const { return parts_[number].get(); }

 private:
  int add(int first, int last);
  int split(int first, int last);

  const Geometry& whole_;
  CageTables tables_;
  std::vector<int> faces_;
  std::vector<Cluster> clusters_;
  std::deque<Lazy<ClusterPart>> parts_;
};

}  // namespace cageproof::closed_form::batch
