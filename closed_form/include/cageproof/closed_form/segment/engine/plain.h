// SPDX-License-Identifier: MIT
// The closed form of a segment formula as one would write it: in the scalar's own arithmetic, with its stable branches,
// and nothing wider. The headers included need only the standard library and Eigen's vectors.
#pragma once

#include "cageproof/closed_form/segment/engine/kernel.h"
#include "cageproof/closed_form/segment/engine/plain_frame.h"

namespace cageproof::closed_form::segment {

/// A single formula at a single point. Units and limits: at the formula. Digits are lost where its terms cancel: far
/// from the segment, and next to its line.
/// \tparam R float or double, the type of every operation
/// \param s ends, the outward normal to the right of s0 -> s1; third coordinates are ignored \param eta the point
/// \param parameters the formula's, in the catalogue's order \param finite_part Batch::finite_part
/// \return value and derivatives up to order O; NaN where a derivative has no limit, as the scalar's own numbers see
/// the point
template <class F, int O, class R>
Jet<R, F::components, 2> plain(const Segment<R>& s, const Vec3<R>& eta, std::span<const R> parameters = {},
                               bool finite_part = false) {
  return jet_at<F, O>(plain_frame(s, eta), parameters, finite_part);
}

}  // namespace cageproof::closed_form::segment
