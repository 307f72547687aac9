// SPDX-License-Identifier: MIT
// The evaluation of a segment formula that we stand behind.
#pragma once

#include "cageproof/closed_form/arithmetic/working.h"
#include "cageproof/closed_form/segment/engine/exact_frame.h"
#include "cageproof/closed_form/segment/engine/far_frame.h"
#include "cageproof/closed_form/segment/engine/kernel.h"

namespace cageproof::closed_form::segment {

/// A single formula at a single point. Units and limits: at the formula.
/// \param s ends, the outward normal to the right of s0 -> s1; third coordinates are not looked at \param eta the point
/// \param parameters the formula's, in the catalogue's order
/// \return value and derivatives up to order O; NaN where a derivative has no limit
template <class F, int O, Scalar R>
Jet<R, F::components, 2> closed_form(const Segment<R>& s, const Vec3<R>& eta, std::span<const R> parameters = {}) {
  using W = Working<R>;
  const Segment<W> wide{convert<W>(s[0]), convert<W>(s[1])};
  return narrowed<R>(jet_at<F, O>(FarFrame<W>(wide, convert<W>(eta)), parameters, false));
}

}  // namespace cageproof::closed_form::segment
