// SPDX-License-Identifier: MIT
// The members that the engine needs of a closed form over triangles.
//
// A closed form is a struct derived from OddPowers or EvenPowers, in a header of its own in the folder above:
//   components    how many numbers its value has: corners (or 1) x rows x columns
//   degree        of homogeneity, as Formula::degree
//   border_order  the first derivative without a limit on the triangle's border; 3 where all have one
//   far_power     the steepest power of the distance in its moments
//   template <class S, class R, int N>
//   static void compose(const S& s, std::span<const R> parameters, std::array<Taylor<R, N>, components>& out)
//                 adds the value and its derivatives up to degree N to `out`, from the moments of the triangle that
//                 `s` has: an EdgeForm, for mean_value() an EvenForm, or far away the far form, which sums over Gauss
//                 points (HatMoments in fast/triangle/far_form.h). J() is int 1/r, I() int r, omega() int x.n/r^3; with
//                 hat functions, A() is int Gamma_k/r, B() int Gamma_k x.n/r^3, mean_value() int Gamma_k x.n/r^4.
// A struct redeclares those members in which it differs from its base.
#pragma once

#include "cageproof/closed_form/arithmetic/taylor.h"
#include "cageproof/closed_form/triangle/engine/edge_form.h"
#include "cageproof/closed_form/triangle/engine/even_form.h"

#include <span>

namespace cageproof::closed_form::triangle {

/// The far form in double takes at most the square of this many Gauss points before the near form is tried: kFarLimit
/// where the near form is quicker then, kCancellingLimit where that cancels long before (mean value).
inline constexpr int kFarLimit = 20, kCancellingLimit = 48;

/// Behaviour of the first order without a limit on the border: it depends on the direction of approach; or it diverges
/// like the logarithm of the distance, and all other terms have a limit from inside; or both.
enum class OnBorder { NoLimit, Logarithm, LogarithmAndDirection };

/// Kernels with odd powers of the distance, whose moments EdgeForm has.
struct OddPowers {
  static constexpr int extra = 0;            ///< derivatives of the moments beyond the formula's own
  static constexpr int parameter_count = 0;  ///< the size of Formula::parameters
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  /// Whether the value is infinite all over the triangle, wherever the corner's hat function is positive.
  static constexpr bool diverges_on_triangle = false;
  /// Whether the near form cancels within a triangle's size already, so that the far form takes over as early as it
  /// can, and the near form in double is always asked for its error bound.
  static constexpr bool cancels_nearby = false;
  /// kFarLimit or kCancellingLimit.
  static constexpr int far_limit = kFarLimit;
  /// Whether derivatives cancel far away: their far form in double is then asked for its error bound.
  static constexpr bool cancels_far = false;
  /// The moments near the triangle, for derivatives up to order O.
  template <class F, class R, int O>
  using Near = EdgeForm<R, O + F::extra, F::extra == 0 ? O : O + F::extra - 1>;
};

/// Kernels with even powers of the distance, whose moments EvenForm has. Members as in OddPowers.
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
