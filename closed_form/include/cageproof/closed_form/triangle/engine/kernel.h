// SPDX-License-Identifier: MIT
// The members that the engine needs of a closed form over triangles.
//
// A closed form is a struct derived from OddPowers or EvenPowers, in a header of its own in the folder above:
//   components    numbers of its value, over corners, rows and columns
//   degree        of homogeneity, as Formula::degree
//   border_order  the first derivative without a limit on the triangle's border; 3 where all have one
//   far_power     the steepest power of the distance in its moments
//   template <class S, class R, int N>
//   static void compose(const S& s, std::span<const R> parameters, std::array<Taylor<R, N>, components>& out)
//                 adds the value and its derivatives up to degree N to `out`, from the moments that EdgeForm and
//                 FarForm (EvenForm) have in common: J() is int 1/r, I() int r, omega() int x.n/r^3, A() and B() those
//                 of 1/r and x.n/r^3 weighted with the hat functions; mean_value() with x.n/r^4.
// A struct redeclares those members in which it differs from its base.
#pragma once

#include "cageproof/closed_form/arithmetic/taylor.h"
#include "cageproof/closed_form/triangle/engine/edge_form.h"
#include "cageproof/closed_form/triangle/engine/even_form.h"

#include <span>

namespace cageproof::closed_form::triangle {

/// The most points a side that the far form takes in double where the edge form is the quicker one, and where that
/// cancels long before (mean value).
inline constexpr int kFarLimit = 20, kCancellingLimit = 48;

/// Behaviour of the first order without a limit on the border: it depends on the direction of approach; or it diverges
/// like the logarithm of the distance, and all other terms have a limit from inside; or both.
enum class OnBorder { NoLimit, Logarithm, LogarithmAndDirection };

/// Kernels with odd powers of the distance, whose moments EdgeForm has.
struct OddPowers {
  static constexpr int extra = 0;            ///< derivatives of the moments beyond the formula's own
  static constexpr int parameter_count = 0;  ///< how many numbers the formula takes besides
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  /// Whether the value is infinite all over the triangle, wherever the corner's hat function is positive.
  static constexpr bool diverges_on_triangle = false;
  /// Whether the form near the triangle cancels within a triangle's size of it already, so that the far form must take
  /// over as early as it can, and the near form in double is always asked for its error bound.
  static constexpr bool cancels_nearby = false;
  /// The most points a side that the far form may take in double.
  static constexpr int far_limit = kFarLimit;
  /// Whether derivatives cancel far away: their far form in double is then asked for its error bound.
  static constexpr bool cancels_far = false;
  /// The moments near the triangle, for derivatives up to order O.
  template <class F, class R, int O>
  using Near = EdgeForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>;
};

/// Kernels with even powers of the distance, whose moments EvenForm has.
struct EvenPowers {
  static constexpr int extra = 0;
  static constexpr int parameter_count = 0;
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  static constexpr bool diverges_on_triangle = true;
  static constexpr bool cancels_nearby = true;
  static constexpr int far_limit = kCancellingLimit;
  static constexpr bool cancels_far = false;
  template <class F, class R, int O>
  using Near = EvenForm<R, O>;
};

}  // namespace cageproof::closed_form::triangle
