// SPDX-License-Identifier: MIT
// Value and gradient of one pair in double, and the reference that conventions are solved against.
#pragma once

#include "cageproof/judge/convention.h"
#include "cageproof/validation/sample.h"

namespace cageproof::judge {

/// Value and gradient at a sample; the gradient is empty where none was asked for.
using Tensors = std::array<std::vector<double>, 2>;

/// Theirs, or ours in double.
Tensors tensors_of(const Evaluation& evaluation, const validation::Sample& sample, int order);

/// Ours: the closed form in 50 digits, rounded; where there is none, the recommended evaluation.
/// \throws InputError where the formula has neither
Tensors reference_of(const Formula& formula, const validation::Sample& sample, int order);

/// How corners and indices are rearranged from ours to theirs.
struct Arrangement {
  std::vector<int> corners;  ///< empty: the same
  bool transposed = false;
  bool normalised = false;
};

/// Ours as theirs has it, up to the factor, the derivatives' sign and their place. Value and gradient.
Tensors arranged(const Formula& formula, const Tensors& ours, const Arrangement& arrangement);

/// The parameters' powers times the factor at a sample.
double scale_of(const Formula& formula, const Convention& convention, std::span<const double> parameters);

/// A gradient [component][i] from one that is stored [i][component].
std::vector<double> component_first(const std::vector<double>& gradient, int dim);

}  // namespace cageproof::judge
