// SPDX-License-Identifier: MIT
// Study of weights across the hull of a twisted quad, where the projection behind `riemann-<n>` is only continuous
// ([T18] Lemma 3.4).
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <functional>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// Jumps across a surface, relative to the larger side, worst over the four weights' vector.
struct Jump {
  double value = 0, derivative = 0;  ///< of the derivative along the surface's normal
};

using WeightsAt = std::function<std::array<double, 4>(const Vec3<double>&)>;

/// The jumps of `weights` across the plane through `point` with unit normal `normal`: limits of value and derivative
/// from either side by quadratic extrapolation of three points `step` apart, which errs by orders step^3 and step^2
/// over powers of the distance to the quad.
Jump jump_across(const WeightsAt& weights, const Vec3<double>& point, const Vec3<double>& normal, double step);

/// Worst and median jumps, over points of the hull's four faces and, as the control, over these points moved outwards
/// by `control_distance` of the quad's size, where nothing should jump.
struct ContinuityStudy {
  int points = 0;
  std::vector<Jump> hull;  ///< of each point
  Jump hull_worst, hull_median, control_worst, control_median;
};

/// For an evaluation of quad.mean_value.
/// \param points at least 1, drawn from `seed`, on faces away from their edges
/// \param step in sizes of the quad, its longer diagonal
/// \throws std::invalid_argument for planar quads, whose hull is flat
ContinuityStudy study_continuity(const Evaluation& evaluation, const Quad<double>& q, int points, std::uint64_t seed,
                                 double step = 2e-6, double control_distance = 0.3);

}  // namespace cageproof::adaptive_qmvc
