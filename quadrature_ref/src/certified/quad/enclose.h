// SPDX-License-Identifier: MIT
// Enclosures of a formula's integral over a bilinear quad.
#pragma once

#include "../ball.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <optional>

namespace cageproof::quadrature_ref::certified {

struct QuadEnclosure {
  std::array<std::vector<Real>, 3> tensors;  ///< per order, as in a Result
  std::size_t nodes = 0;
};

/// The enclosure at the working_bits (../README.md). Nothing where the point is on the quad, or too close to it,
/// of a quad whose normals vanish all over it, of an input that is not finite, and where work_left would not suffice.
///
/// \param goal truncation error wanted, in bits below the largest contribution: a wish; what was reached is in the
/// radii \param work_left CertifiedEffort::most_work's unit; what is spent is taken off \throws std::out_of_range when
/// the formula has no definition
template <Scalar R>
std::optional<QuadEnclosure> enclose_quad(std::string_view formula, const Query<R>& query, int goal, double& work_left);

/// The names of the formulas that can be enclosed on quads.
std::vector<std::string> formulas_enclosed_on_quads();

}  // namespace cageproof::quadrature_ref::certified
