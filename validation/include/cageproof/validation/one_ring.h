// SPDX-License-Identifier: MIT
// Whose derivatives an evaluation gives: each triangle's own, or ones that are right in sums over a closed cage alone.
#pragma once

#include "cageproof/core/cage.h"
#include "cageproof/core/run_result.h"

namespace cageproof::validation {

struct OneRingOptions {
  std::string evaluation = "curl-form";
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 24;  ///< at least 2e-2 cage sizes away from it, inside and outside
};

/// Rows of one cage for the derivatives of triangle.double_layer against the closed form's truth: `own_derivative`, the worst
/// triangle, and `one_ring_sum`, the sums over the triangles around each vertex; both norm-wise. An evaluation that keeps the
/// first has the gradients of phi_t^k; one that keeps the second alone has a form like P x d/(2|t|), which must not be mixed
/// with others.
/// \throws InputError when there is no evaluation of that name
std::vector<ResultRow> run_one_ring_check(const Cage& cage, const OneRingOptions& options);

/// The error of one such row at one point. \param check "own_derivative" or "one_ring_sum"
double one_ring_error_at(const Cage& cage, const OneRingOptions& options, std::string_view check, int order,
                         const Vec3<double>& point);

}  // namespace cageproof::validation
