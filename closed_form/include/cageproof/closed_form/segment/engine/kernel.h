// SPDX-License-Identifier: MIT
// The members that the engine needs of a closed form over segments.
//
// A closed form is a struct in a header of its own in the folder above: `components`, the numbers of its value over
// corners, rows and columns, and
//   template <int O, class F, class R = typename F::Number>
//   static Jet<R, components, 2> at(const F& frame)
// with value and derivatives up to order O in the caller's units. Formulas with parameters state `parameter_count`, and
// have `at(frame, const Given<R>&)`.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/segment/engine/frame.h"

#include <span>

namespace cageproof::closed_form::segment {

/// The logarithm in a kernel, |factor| r^power |ln r|. A potential's terms have this size next to its zeros, too.
/// Formulas that have one state it as `logarithmic_part(std::span<const double> parameters)`.
struct LogarithmicPart {
  double factor;
  int power;
  bool over_height = false;  ///< the height over the line takes the place of one r
};

/// The input of a formula with parameters, except the geometry.
template <Scalar R>
struct Given {
  std::span<const R> parameters;  ///< in the order of Formula::parameters
  bool finite_part = false;       ///< Batch::finite_part
};

/// A formula at a frame, whether it has parameters or not.
template <class F, int O, class At, class P, class R = typename At::Number>
Jet<R, F::components, 2> jet_at(const At& frame, std::span<const P> parameters, bool finite_part) {
  if constexpr (requires { F::parameter_count; }) {
    std::array<R, F::parameter_count> own;
    for (int i = 0; i < F::parameter_count; ++i) own[i] = number_from<R>(parameters[i]);
    return F::template at<O>(frame, Given<R>{own, finite_part});
  } else {
    return F::template at<O>(frame);
  }
}

}  // namespace cageproof::closed_form::segment
