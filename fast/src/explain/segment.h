// SPDX-License-Identifier: MIT
// The segment's hybrids in numbers that count.
#pragma once

#include "cageproof/adaptive_qmvc/counted_rule.h"
#include "cageproof/closed_form/segment/engine/counted.h"
#include "segment/hybrid.h"

namespace cageproof::fast::segment {

/// Explains an entry of the tensor of order O.
template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Segment<double> ends{query.corners[0], query.corners[1]};
  Explanation explanation;
  if (!hybrid<F, O>(SeenSegment(ends, query.point), query.parameters, query.finite_part)) {
    explanation.route = "none in double: the point is extreme";
    choose_none(explanation, values, entry);
    return explanation;
  }
  const CountedTape tape;
  const FarFrame<Counted> frame({convert<Counted>(ends[0]), convert<Counted>(ends[1])}, convert<Counted>(query.point));
  const auto jet = jet_at<F, O>(frame, query.parameters, query.finite_part);
  choose(explanation, tape, closed_form::segment::entries_of<O>(jet), 0, values, entry);
  explanation.route = frame.is_far() ? "the form far away, in double" : "the form nearby, in double";
  return explanation;
}

}  // namespace cageproof::fast::segment
