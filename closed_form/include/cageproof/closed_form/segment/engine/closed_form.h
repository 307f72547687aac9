// SPDX-License-Identifier: MIT
// The evaluation of a segment formula that we stand behind.
//
// A closed form is a struct in a header of its own in the folder above: `components`, the numbers of its value over
// corners, rows and columns, and
//   template <int O, Scalar R>
//   static Jet<R, components, 2> at(const Frame<R>& frame)
// with value and derivatives up to order O in the caller's units.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/arithmetic/working.h"
#include "cageproof/closed_form/segment/engine/frame.h"

namespace cageproof::closed_form::segment {

/// A single formula at a single point. Units and limits: at the formula.
/// \param s ends, the outward normal to the right of s0 -> s1; third coordinates are not looked at \param eta the point
/// \return value and derivatives up to order O; NaN where a derivative has no limit
template <class F, int O, Scalar R>
Jet<R, F::components, 2> closed_form(const Segment<R>& s, const Vec3<R>& eta) {
  using W = Working<R>;
  const Segment<W> wide{convert<W>(s[0]), convert<W>(s[1])};
  return narrowed<R>(F::template at<O, W>(Frame<W>(wide, convert<W>(eta))));
}

}  // namespace cageproof::closed_form::segment
