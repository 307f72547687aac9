// SPDX-License-Identifier: MIT
// Error fields on slices: through a cage, or across one triangle.
#pragma once

#include "cageproof/core/coordinates.h"
#include "cageproof/core/run_result.h"
#include "cageproof/validation/sample.h"

namespace cageproof::validation {

/// A slice of points x points samples.
struct SlicePlan {
  Vec3<double> origin, spacing;
  std::array<int, 3> points;
};

/// The slice through the middle of a cage's box, at right angles to its shortest side, a tenth larger than the box.
SlicePlan slice_through(const Cage& cage, int resolution);

/// Partition of unity and linear reproduction on a slice (arrays of those names, raw errors).
/// \param parameters in the order of parameters_of(kind); empty for their defaults
ImageField reproduction_field(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation,
                              Triangulation rule, int resolution, int jobs, const std::vector<double>& parameters = {});

/// Relative error of a kind of coordinates against the closed form in 50 digits on a slice: array `relative error`, the
/// largest over the blocks.
ImageField coordinate_error_field(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation,
                                  Triangulation rule, int resolution, int jobs);

/// How far one evaluation of a kind of coordinates is from another, both in double, on a slice: array `difference`, the largest of a coordinate. For errors far
/// above rounding, where a truth in 50 digits would only cost time.
ImageField coordinate_difference_field(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation, const std::string& other,
                                       Triangulation rule, int resolution, int jobs);

/// Relative error of one formula on a slice, norm-wise over all triangles, against the closed form in 50 digits; arrays
/// `value` (norm over all triangles) and `relative error`.
ImageField formula_error_field(const std::vector<std::array<Vec3<double>, 3>>& triangles, const Formula& formula,
                               const Evaluation& evaluation, int order, const SlicePlan& slice, int jobs);

}  // namespace cageproof::validation
