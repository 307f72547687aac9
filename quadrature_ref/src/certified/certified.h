// SPDX-License-Identifier: MIT
// Rigorous enclosures of formulas' defining integrals over segments, triangles and quads, in ball arithmetic
// (FLINT/Arb).
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::quadrature_ref {

/// How hard to try.
struct CertifiedEffort {
  int first_bits = 192;  ///< working precision of the first attempt
  int most_bits = 4096;  ///< of the last; on a segment, which costs little, eight times as many
  /// Relative radius aimed at, norm-wise for each order, as a power of two: below 1e-30.
  int bits_wanted = 100;
  /// The limit of all attempts together, in evaluations of an integrand in one word: a few seconds.
  double most_work = 1e7;
};

/// Value, gradient and Hessian of a formula as balls that contain them: `Result::of(order)` the midpoints,
/// `radius_of(order)` the radii, the rounding of the midpoint to R included. Derivatives are taken under the integral
/// sign. Inputs are taken exactly. README.md next to this file has the proof. It takes 1 to 250 ms on a triangle, 1 to
/// 1000 on a quad, a fraction of one on a segment.
///
/// Precision grows until the radius is below 2^-bits_wanted of the tensor, norm-wise, in every order asked; `converged`
/// is false where most_bits, or most_work, do not reach that, and the enclosure, wide as it is, still holds.
/// `stated_digits` come from the radius before rounding to R. On the element, an order whose kernel is weakly singular
/// is enclosed; all others are NaN with infinite radius, and `converged` is false. The same holds without area or
/// length, for an input that is not finite, and for any order on a quad. Points outside the element in its plane or on
/// its line are not special. The result depends only on the input. Thread-safe.
///
/// \throws InputError for an unknown formula, std::out_of_range for one that has no definition
template <Scalar R>
void integrate_certified(std::string_view formula, const Query<R>& query, Result<R>& result,
                         const CertifiedEffort& effort = {});

}  // namespace cageproof::quadrature_ref
