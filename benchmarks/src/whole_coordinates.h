// SPDX-License-Identifier: MIT
// Whole coordinates as benchmarks ask for them: into memory that is there already, or applied to a pose.
#pragma once

#include "deformer_benchmarks.h"

#include "cageproof/core/whole_evaluation.h"

namespace cageproof::benchmarks {

/// The evaluations that a kind is timed by in a cage: whole ones (whole_evaluations) that compute it, the formulas'
/// recommended one, and of kinds that keep quads their schemes and direct rules.
struct TimedEvaluation {
  std::string name;
  bool whole;
};
std::vector<TimedEvaluation> timed_evaluations(const CoordinateKind& kind, const Cage& cage);

/// Coordinates of a kind by one evaluation, and memory for a block of points, which every call fills anew.
class WholeCoordinates {
 public:
  WholeCoordinates(const Cage& cage, const CoordinateKind& kind, const TimedEvaluation& evaluation);

  const CageCoordinates& coordinates() const { return coordinates_; }
  int max_order() const { return coordinates_.max_order(); }
  /// Pairs of a point and a triangle, or of a quad that the kind keeps.
  std::size_t elements() const { return coordinates_.elements().count(); }

  /// Tables for so many points, set to zero.
  std::vector<CoordinateTable<double>> tables_for(std::size_t points, int order) const;
  /// Whole evaluations write to the tables; what is a sum makes tables of its own, whose cost is small beside that of
  /// the sum. \pre tables_for(points.size(), order), set to zero
  void fill(std::span<const Vec3<double>> points, int order, std::vector<CoordinateTable<double>>& tables) const;

 private:
  CageCoordinates coordinates_;
  std::shared_ptr<const PreparedCoordinates> prepared_;  // of whole evaluations
};

/// What a pose of the cage makes of the blocks: deformed vertices, normals of deformed elements times the root of the
/// ratio of areas, and a tenth of these for blocks that reproduce nothing. Coordinates that are numbers have three
/// sets, one a coordinate of space (in the plane two), matrices one.
CageData data_of_pose(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& posed);

}  // namespace cageproof::benchmarks
