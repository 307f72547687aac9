// SPDX-License-Identifier: MIT
// The segment's forms in numbers that count: as the triangle's, geometry is taken over as a whole.
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
/// Each of the numbers that double's frame has is one operation.
template <>
Frame<Counted>::Frame(const Segment<Counted>& segment, const Vec3<Counted>& eta);

/// With what frames of tracked numbers make of the others themselves: tracked_frame.h.
Frame<Counted> as_tracked(const Frame<Counted>& seen);

/// The numbers of the tensor of order O.
template <int O, int C>
std::vector<Counted> entries_of(const Jet<Counted, C, 2>& jet) {
  std::vector<Counted> entries;
  for_each_entry(O, jet, [&](const Counted& x) { entries.push_back(x); });
  return entries;
}

}  // namespace cageproof::closed_form::segment
