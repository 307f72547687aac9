// SPDX-License-Identifier: MIT
// Inner loops of sums over clusters, for a vector of points or sources at a time, once per instruction set. Their
// arguments are plain arrays, as the tables of cages are.
#pragma once

namespace cageproof::closed_form::batch {

/// Functions that clusters of faces are expanded for: three components of an image, and the coordinates' sum.
inline constexpr int kMomentSets = 4;
/// The highest degree of solid harmonics.
inline constexpr int kMostMomentOrder = 48;
/// Numbers of a cluster's moments up to a degree.
constexpr int moment_count(int order) { return kMomentSets * (order + 1) * (order + 1); }

/// A cluster of faces seen from a block of points that are far from it.
struct FarCluster {
  int order, stored;      ///< degrees that are taken, and those that there are
  const double* moments;  ///< [l][set] of m = 0; then, for each m, [l - m][real, imaginary][set]
  const double* centre;   ///< [3]
  double over;            ///< one over the cluster's radius
  const double* points;   ///< [3][lanes]
  double* sums;           ///< [set][lanes], stored
};

/// Vectors of sources that are taken together.
inline constexpr int kMomentBlocks = 4;

/// Poles and dipoles that a cluster's moments are made of. Lengths are in the cluster's radii, from its centre.
struct MomentSources {
  int order;
  const double *places, *normals;   ///< [3][block][lanes]
  const double *charges, *dipoles;  ///< [set][block][lanes]; dipoles are along the normals
  void* scratch;                    ///< 6 (order + 1) vectors for each block
  double* sums;                     ///< [l (l + 1)/2 + m][real, imaginary][set][lanes], added to
};

/// The functions of one instruction set, whose vectors have as many lanes as those of Kernels.
struct ClusterKernels {
  void (*add_moments)(const MomentSources&);
  void (*sum_far_cluster)(const FarCluster&);
};

/// The kernels for instruction_set(). \throws InputError as that does
const ClusterKernels& cluster_kernels();

#if defined(__x86_64__)
extern const ClusterKernels cluster_kernels_avx512, cluster_kernels_avx2;
#endif
extern const ClusterKernels cluster_kernels_plain;

}  // namespace cageproof::closed_form::batch
