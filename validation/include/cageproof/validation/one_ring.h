// SPDX-License-Identifier: MIT
// Whose derivatives an evaluation gives: each triangle's own, or ones that are right in sums over a closed cage alone.
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/validation/measurement.h"

namespace cageproof::validation {

/// The formula whose derivatives are looked at.
inline constexpr std::string_view one_ring_formula = "triangle.double_layer";

/// Whether the cage's elements are, or become, those of the formula.
bool one_ring_exists_on(const Cage& cage);

struct OneRingOptions {
  std::string evaluation = "curl-form";  ///< empty for the recommended one
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 24;  ///< at least 2e-2 cage sizes away from it, inside and outside
  int jobs = 0;     ///< threads; 0: all cores
};

/// For the derivatives of triangle.double_layer against the closed form's truth: `own_derivative`, the worst
/// triangle, and `one_ring_sum`, the sums over the triangles around each vertex; both norm-wise. An evaluation that
/// keeps the first has the gradients of phi_t^k; one that keeps the second alone has a form like P x d/(2|t|), which
/// must not be mixed with others. \throws InputError when there is no evaluation of that name
std::unique_ptr<const Measurement> one_ring_measurement(std::shared_ptr<const Cage> cage,
                                                        const OneRingOptions& options);

/// Measures and judges them. \throws InputError as one_ring_measurement
std::vector<ResultRow> run_one_ring_check(const Cage& cage, const OneRingOptions& options);

/// The error of one such row at one point. \param check "own_derivative" or "one_ring_sum"
double one_ring_error_at(const Cage& cage, const OneRingOptions& options, std::string_view check, int order,
                         const Vec3<double>& point);

}  // namespace cageproof::validation
