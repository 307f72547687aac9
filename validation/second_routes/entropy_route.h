// SPDX-License-Identifier: MIT
// Maximum entropy coordinates (Hormann, Sukumar 2008) from the conditions that make them: their optimality, and
// another minimiser.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <span>
#include <vector>

namespace cageproof::second_routes {

/// The input of the definition. \pre one prior per vertex
struct EntropyProblem {
  std::vector<Vec3<Mp100>> offsets;  ///< of the vertices from the point, in cage sizes
  std::vector<Mp100> prior;          ///< of any sum; vertices where it is not positive have coordinates of zero

  EntropyProblem(std::span<const Vec3<double>> vertices, std::vector<Mp100> prior_of_vertices,
                 const Vec3<double>& point, double size);
};

/// The coordinates that minimise sum lambda_i log(lambda_i/m_i), from the prior by Newton's method on the dual
/// function of four unknowns, sum m_i exp(c + t.d_i) - c, in steps that change no logarithm by more than one. NaN where
/// there are none.
std::vector<Mp100> entropy_coordinates(const EntropyProblem& problem);

/// How far coordinates are from the conditions of Karush, Kuhn and Tucker, the largest of: |sum - 1|; |sum lambda_i
/// d_i|, in cage sizes; the distance of log(lambda_i/m_i) from an affine function of the vertices, which four of them
/// fix. The entropy is concave and the conditions are linear, so that coordinates that satisfy all are the maximum.
/// Infinite where a coordinate is not positive whose prior is, or not zero elsewhere.
double unmet_optimality(const EntropyProblem& problem, std::span<const Mp100> lambda);

}  // namespace cageproof::second_routes
