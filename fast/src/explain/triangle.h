// SPDX-License-Identifier: MIT
// The triangle's hybrids in numbers that count.
#pragma once

#include "cageproof/adaptive_qmvc/counted_rule.h"
#include "cageproof/closed_form/triangle/engine/counted.h"
#include "cageproof/fast/triangle/hybrid.h"

namespace cageproof::fast::triangle {

/// The description of the form whose operations are counted. \param panels those of a sum over Gauss points
/// \param is_kept whether its numbers are the hybrid's
std::string description_of(Route route, const Panels& panels, bool is_kept);

/// Explains an entry of the tensor of order O.
template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Triangle<double> t{query.corners[0], query.corners[1], query.corners[2]};
  HybridMoments<O> at(t, query.point);
  const Frame<double>& seen = at.frame();
  const auto found = hybrid<F, O>(at, query.parameters);
  Explanation explanation;
  if (seen.extreme || (F::diverges_on_triangle && closed_form::triangle::first_divergent<F>(seen) < 3)) {
    choose_none(explanation, values, entry);
    explanation.route = "none in double: the point is extreme, or the value diverges here";
    return explanation;
  }
  Panels panels;
  if (found.route == Route::Panels)
    for (const int points : {0, kMostPoints})
      if (panels.empty()) panels = at.on_panels().panels(panels_wanted<F, O>(seen, points));
  const CountedTape tape;
  const Frame<Counted> frame = counted_frame(seen, t, query.point);
  const auto parameters = closed_form::triangle::counted_parameters<F>(query.parameters);
  const bool is_near = found.route == Route::Near;
  const bool before = closed_form::triangle::follow_tracked(!is_near);
  const auto components = found.route == Route::Panels
                              ? composed<F, O, Counted>(PanelFormOf<F, Counted, O>(frame, panels), parameters)
                              : near_components<F, O, Counted>(frame, parameters);
  closed_form::triangle::follow_tracked(before);
  choose(explanation, tape, closed_form::triangle::entries_of<F, O>(components),
         (F::degree - O) * std::ilogb(seen.unit), values, entry);
  explanation.route = description_of(found.route, panels, explanation.is_the_value);
  return explanation;
}

}  // namespace cageproof::fast::triangle
