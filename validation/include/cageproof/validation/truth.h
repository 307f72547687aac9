// SPDX-License-Identifier: MIT
// The truth at a sample, and the yardstick that errors are measured with.
#pragma once

#include "cageproof/validation/sample.h"

#include <array>

namespace cageproof::validation {

/// Value, gradient and Hessian at a sample, in multiprecision, and per order the denominator of the conditioned error,
/// |truth| + sum_k |x_k| |d truth/d x_k| over the coordinates x_k of the element and the point.
struct Truth {
  Result<Mp100> tensors;
  /// False for an order where no limit exists (diverges on the element) or where two precisions do not agree to 30 digits.
  std::array<bool, 3> exists{false, false, false};
  std::array<Mp100, 3> norm{};
  std::array<Mp100, 3> conditioned{};
  /// True when the point lies exactly on the triangle. Within it the yardstick counts only moves to its inner side, since the function
  /// may jump; on its border it is the norm alone.
  bool on_element = false;
};

/// Norm of all entries of a tensor: the square root of the sum of squares.
Mp100 norm(const std::vector<Mp100>& tensor);

/// The truth from an evaluation in multiprecision (100 digits, confirmed with 200).
/// \param reference an evaluation that has proven itself against the integral, or the integral
Truth truth_from(const Evaluation& reference, const Sample& sample, int order);

/// |f - truth| over the conditioned denominator, in units of `u`; infinite for a result that is not finite.
/// \pre truth.exists[order]
template <Scalar R>
double conditioned_error(const Result<R>& f, const Truth& truth, int order, const Mp100& u);

/// |f - truth| / |truth|, norm-wise.
template <Scalar R>
double relative_error(const Result<R>& f, const Truth& truth, int order);

/// Where a sample's point lies on its triangle, in exact arithmetic.
enum class Contact { None, Face, Border };
Contact contact_of(const Sample& sample);

}  // namespace cageproof::validation
