// SPDX-License-Identifier: MIT
// A segment's closed form in Counted numbers: the form in double, and the rung of the ladder to which its bound sent
// the evaluation.
#pragma once

#include "../../explain/rung.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/engine/counted.h"

namespace cageproof::closed_form::segment {

/// Explains an entry of the tensor of order O.
template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Segment<double> ends{query.corners[0], query.corners[1]};
  PointFrames at(ends, query.point);
  const std::span<const double> parameters(query.parameters);
  const auto taken = bounded_form<F, O>(at, parameters, query.finite_part, kTolerance);
  Explanation explanation;
  if (!at.is_in_range()) {
    choose_none(explanation, values, entry);
    explanation.route =
        "form in " + arithmetic_name(taken.digits) + ": none in double, at an end, almost on the line or extreme";
    return explanation;
  }
  constexpr double largest = std::numeric_limits<double>::max();
  const double bound =
      bounded<O, double, double>(jet_at<F, O>(at.tracked<double>(), parameters, query.finite_part), largest).worst();
  const CountedTape tape;
  const Frame<Counted> frame =
      as_tracked(Frame<Counted>({convert<Counted>(ends[0]), convert<Counted>(ends[1])}, convert<Counted>(query.point)));
  const auto jet = jet_at<F, O>(frame, parameters, query.finite_part);
  choose(explanation, tape, entries_of<O>(jet), 0, values, entry);
  explanation.route = rung_name("form", taken, bound);
  return explanation;
}

}  // namespace cageproof::closed_form::segment
