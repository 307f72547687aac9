// SPDX-License-Identifier: MIT
#include "cageproof/benchmarks/kind_times.h"

#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/geometry/box.h"
#include "point_times.h"

#include <algorithm>

namespace cageproof::benchmarks {
namespace {

constexpr std::size_t point_count = 32;
constexpr double seconds_of_kind = 0.02;

// Along lines through the box that no symmetry of a cage keeps.
std::vector<Vec3<double>> points_of_box(const Cage& cage) {
  const auto [low, high] = box_of(cage.vertices());
  std::vector<Vec3<double>> points;
  for (std::size_t i = 0; i < point_count; ++i) {
    const double t = (static_cast<double>(i) + 0.37) / static_cast<double>(point_count);
    const Vec3<double> share(t, 0.93 - 0.83 * t, 0.31 + 0.43 * t);
    points.emplace_back(low + (high - low).cwiseProduct(share));
    if (cage.dimension() == 2) points.back()[2] = 0;
  }
  return points;
}

}  // namespace

std::vector<EvaluationTime> times_of_kinds(const Cage& cage, Triangulation rule) {
  const std::vector<Vec3<double>> points = points_of_box(cage);
  std::vector<EvaluationTime> times;
  for (const CoordinateKind& kind : coordinate_kinds()) {
    const bool solves = kind.solves_on_samples && !(kind.meets_boundary_data && cage.dimension() == 2);
    if (solves || !accepts(kind, cage)) continue;
    const CageCoordinates coordinates(cage, kind, std::string(quickest), rule);
    // The least: on a busy machine other programs run within most batches.
    const double all = std::ranges::min(nanoseconds_of_batches(coordinates, points, seconds_of_kind));
    times.push_back({std::string(kind.name), coordinates.evaluation(), 0, all / static_cast<double>(points.size())});
  }
  return times;
}

}  // namespace cageproof::benchmarks
