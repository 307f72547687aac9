// SPDX-License-Identifier: MIT
// The segment's forms in Counted numbers. As in the triangle's, each number of the geometry counts as one operation.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/explain.h"
#include "cageproof/closed_form/segment/engine/bounded.h"
#include "cageproof/closed_form/segment/engine/exact_frame.h"
#include "cageproof/closed_form/segment/engine/radial_moments.h"

namespace cageproof::closed_form::segment {

template <>
Counted shifted<Counted>(const Counted& x, int exponent);
template <>
Counted scaled_exponential<Counted>(long double x, int shift);
/// The frame in double, each of whose numbers counts as one operation.
template <>
Frame<Counted>::Frame(const Segment<Counted>& segment, const Vec3<Counted>& eta);

/// The frame with log_r, h, log_ratio and angle computed from its other members, as tracked frames compute them.
Frame<Counted> as_tracked(const Frame<Counted>& seen);

/// The numbers of the tensor of order O.
template <int O, int C>
std::vector<Counted> entries_of(const Jet<Counted, C, 2>& jet) {
  std::vector<Counted> entries;
  for_each_entry(O, jet, [&](const Counted& x) { entries.push_back(x); });
  return entries;
}

}  // namespace cageproof::closed_form::segment
