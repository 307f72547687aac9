// SPDX-License-Identifier: MIT
// The evaluation of a segment formula that we stand behind.
//
// A closed form is a struct in a header of its own in the folder above: `components`, the numbers of its value over
// corners, rows and columns, and
//   template <int O, Scalar R>
//   static Jet<R, components, 2> at(const Frame<R>& frame)
// with value and derivatives up to order O in the caller's units. Formulas with parameters have their number,
// `parameter_count`, and take what is given of them as `at(frame, const Given<R>&)`.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/arithmetic/working.h"
#include "cageproof/closed_form/segment/engine/frame.h"

#include <span>

namespace cageproof::closed_form::segment {

/// What a formula with parameters is asked for beside the geometry.
template <Scalar R>
struct Given {
  std::span<const R> parameters;  ///< in the order of Formula::parameters
  bool finite_part = false;       ///< Batch::finite_part
};

/// A formula at a frame, whether it has parameters or not.
template <class F, int O, Scalar R, class P>
Jet<R, F::components, 2> jet_at(const Frame<R>& frame, std::span<const P> parameters, bool finite_part) {
  if constexpr (requires { F::parameter_count; }) {
    std::array<R, F::parameter_count> own;
    for (int i = 0; i < F::parameter_count; ++i) own[i] = R(parameters[i]);
    return F::template at<O, R>(frame, Given<R>{own, finite_part});
  } else {
    return F::template at<O, R>(frame);
  }
}

/// A single formula at a single point. Units and limits: at the formula.
/// \param s ends, the outward normal to the right of s0 -> s1; third coordinates are not looked at \param eta the point
/// \param parameters the formula's, in the catalogue's order
/// \return value and derivatives up to order O; NaN where a derivative has no limit
template <class F, int O, Scalar R>
Jet<R, F::components, 2> closed_form(const Segment<R>& s, const Vec3<R>& eta, std::span<const R> parameters = {}) {
  using W = Working<R>;
  const Segment<W> wide{convert<W>(s[0]), convert<W>(s[1])};
  return narrowed<R>(jet_at<F, O, W>(Frame<W>(wide, convert<W>(eta)), parameters, false));
}

}  // namespace cageproof::closed_form::segment
