// SPDX-License-Identifier: MIT
// Expansions of clusters of faces for one set of data, and the distances from which on they are accurate enough.
#pragma once

#include "cluster_tree.h"

#include <array>
#include <limits>
#include <vector>

namespace cageproof::closed_form::batch {

/// Densities of the layers in the unit of Geometry, of as many functions as there are moments.
struct ClusterData {
  std::vector<double> vertex;  ///< of the double layer, [vertex][set]
  std::vector<double> face;    ///< of the single layer, [face][set]
};

/// Expansions up to several degrees, the lower ones for points that are farther. Safe from any thread.
class ClusterMoments {
 public:
  static constexpr int kDegrees = 4;

  /// \param error which functions are off at most where the areas of clusters over the squares of their distances sum
  /// to 4 pi kShares
  ClusterMoments(const ClusterTree& tree, const ClusterData& data, double error);

  /// The highest degree that is taken where vertices are mapped to no farther than that many errors from their middle.
  static int degree_for(double errors);

  /// One over the share of `error` that is allowed for a solid angle of 4 pi.
  static constexpr double kShares = 8;
  /// The degrees, the highest first.
  const std::array<int, kDegrees>& degrees() const { return degrees_; }
  /// Near a cluster of at most this many faces these are summed one by one; larger clusters are taken by those within.
  int least() const { return least_; }
  /// Squares of the distances from the cluster's centre from which on each degree is enough; infinite where none is.
  const std::array<double, kDegrees>& from(int cluster) const { return from_[cluster]; }
  /// The moments as FarCluster takes them, up to the highest degree. \pre that degree is enough somewhere
  const double* moments(int cluster) const { return moments_[cluster].data(); }

 private:
  struct Densities;
  void prepare(int cluster);
  double distance_for(const Cluster& cluster, const Densities& densities, int degree) const;
  bool find_rules(const Cluster& cluster, double distance, std::vector<int>& rules) const;
  void expand(int cluster, const std::vector<int>& rules);

  const ClusterTree& tree_;
  const ClusterData& data_;
  CageTables tables_;
  double share_;  // a cluster's largest error, times 4 pi and its distance's square over its area
  std::array<int, kDegrees> degrees_{};
  int least_;
  std::vector<double> charge_, dipole_;  // of faces: their largest densities
  std::vector<std::array<double, kDegrees>> from_;
  std::vector<std::vector<double>> moments_;
};

}  // namespace cageproof::closed_form::batch
