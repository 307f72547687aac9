// SPDX-License-Identifier: MIT
// Work-precision: the error of evaluations and the time they take, measured on the same inputs.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/results/work_precision.h"
#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/regime.h"

namespace cageproof::benchmarks {

struct WorkPrecisionOptions {
  std::vector<std::string> evaluations;  ///< empty: those of default_work_precision_evaluations
  std::vector<double> parameters;        ///< empty: the defaults of a kind, the samples' own of a formula
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int samples = 32;           ///< a place
  int order = 0;              ///< of formulas; cages are asked only for values
  bool by_parameter = false;  ///< a place for each parameter of a regime (distance ...), instead of one for all
  bool relative = false;      ///< leaves the conditioned errors of formulas out
  int timed = 1000;           ///< pairs timed, an evaluation and place, each by itself
  /// Spent on the pairs beyond the first 64, an evaluation and place; of whole coordinates, timed at least.
  double seconds = 0.5;
  int jobs = 0;  ///< threads for the errors; times are always taken on one
};

/// Points at about the same distance from a cage.
struct PointGroup {
  std::string place;
  double distance;  ///< in cage sizes; of "interior" the least
  std::vector<validation::CagePoint> points;
};

/// Points inside: "interior", at least 1e-1 sizes from the cage, then 1e-1 ... 1e-4 sizes from a random point of a face
/// and no nearer to any other. A group has fewer than `count` where the cage is too thin for them.
std::vector<PointGroup> groups_inside(const Cage& cage, const validation::CageLocator& locator, std::uint64_t seed,
                                      int count);

/// Given points by decade of distance ("1e-2..1e-1"), the farthest first; those nearer than 1e-6 sizes, on which no
/// bound is promised, left out.
std::vector<PointGroup> groups_of(const Cage& cage, const validation::CageLocator& locator,
                                  const std::vector<Vec3<double>>& points);

/// Largest and root-mean-square residual of the partition of unity, and the time of all formulas of the kind on one
/// triangle. For kinds that are not sums it is the time of all coordinates at a point, and the difference from the kind
/// that they approximate in the cage (CoordinateKind::approximates), if any, at points inside. Kinds that cut edges in
/// pieces are measured by the number of pieces, up to 1024 nodes, unless parameters or evaluations are given. \throws
/// InputError when the kind's formulas lack an evaluation, naming all that are missing
WorkPrecision cage_work_precision(const Cage& cage, const CoordinateKind& kind, const std::vector<PointGroup>& groups,
                                  const WorkPrecisionOptions& options);

/// Errors at the samples of regimes, against the formula's truth.
/// \throws InputError when the formula lacks an evaluation, or that derivative of it, all such named
WorkPrecision formula_work_precision(const Formula& formula, const std::vector<const validation::Regime*>& regimes,
                                     const WorkPrecisionOptions& options);

/// The evaluations shown when none are asked for: schemes and rules as their families propose
/// (EvaluationFamily::studied), the recommended evaluation, the printed ones; those of them that all the formulas have.
std::vector<std::string> default_work_precision_evaluations(const std::vector<std::string_view>& formulas, int order);

}  // namespace cageproof::benchmarks
