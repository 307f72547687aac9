// SPDX-License-Identifier: MIT
// A triangle's closed form in Counted numbers: the near form in double, and the rung of the ladder to which its bound
// sent the evaluation.
#pragma once

#include "../../explain/rung.h"
#include "cageproof/closed_form/triangle/engine/closed_form.h"
#include "cageproof/closed_form/triangle/engine/counted.h"

namespace cageproof::closed_form::triangle {

/// Explains an entry of the tensor of order O.
template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Triangle<double> t{query.corners[0], query.corners[1], query.corners[2]};
  PointMoments<O> at(t, query.point);
  const Frame<double>& seen = at.frame();
  const auto taken = bounded_form<F, O>(at, query.parameters, query.finite_part, kTolerance);
  Explanation explanation;
  if (seen.extreme || taken.digits == 0) {
    choose_none(explanation, values, entry);
    explanation.route = seen.extreme ? "edge form in " + arithmetic_name(taken.digits) + ": the point is extreme"
                                     : "none: the value diverges here";
    return explanation;
  }
  int limit = first_divergent<F>(seen);
  if (limit == 0 && query.finite_part) limit = 1;
  constexpr double largest = std::numeric_limits<double>::max();
  const std::span<const double> parameters(query.parameters);
  const double bound = tracked_near<F, double, O>(at, parameters, limit, largest).worst();
  const CountedTape tape;
  const Frame<Counted> frame = counted_frame(seen, t, query.point);
  const bool before = follow_tracked(true);
  const auto components = near_components<F, O, Counted>(frame, counted_parameters<F>(query.parameters));
  follow_tracked(before);
  choose(explanation, tape, entries_of<F, O>(components), (F::degree - O) * std::ilogb(seen.unit), values, entry);
  explanation.route = rung_name("edge form", taken, bound);
  if (limit <= O) explanation.route += "; on the border, where what has no limit is infinite or no number";
  return explanation;
}

}  // namespace cageproof::closed_form::triangle
