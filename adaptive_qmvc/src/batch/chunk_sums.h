// SPDX-License-Identifier: MIT
// Weights of all faces for a chunk of points, whatever is near or far.
#pragma once

#include "geometry.h"
#include "kernels.h"
#include "points_by_plan.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <optional>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// How many points are best taken at a time.
std::size_t chunk_size(const Geometry& geometry);

/// Memory for one chunk of points after the other. What it finds of a point does not depend on the others.
class ChunkSums {
 public:
  /// \param geometry sound, and kept as a reference \param with of an instruction set that the machine has
  ChunkSums(const Geometry& geometry, const CageElements& elements, const Kernels& with = kernels());

  /// Normalised coordinates of at most chunk_size() points. Lists those of which nothing is computed: on the cage, or
  /// at the ends of double's range.
  void run(std::span<const Vec3<double>> points);
  const std::vector<int>& left() const { return left_; }
  /// The coordinate of vertex v at point p is coordinates()[v * stride() + p].
  const double* coordinates() const { return sums_.data(); }
  std::size_t stride() const { return chunk_.stride; }

 private:
  void take(std::span<const Vec3<double>> points);
  void add_alone(std::size_t face, std::span<const Vec3<double>> points);

  const Geometry& geometry_;
  const CageElements& elements_;
  const Kernels& kernels_;
  const Plans& plans_;
  std::array<std::optional<Evaluation>, element_kinds.size()> evaluations_;
  std::vector<double> at_, sums_, distances_, whole_;
  PointsByPlan sorted_;
  std::vector<int> left_;
  Chunk chunk_{};
  int points_ = 0;
};

}  // namespace cageproof::adaptive_qmvc::batch
