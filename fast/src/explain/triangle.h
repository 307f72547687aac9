// SPDX-License-Identifier: MIT
// The triangle's closed forms in numbers that count. The engine's templates are taken as they are; what they have for
// double alone is said for Counted here: where geometry comes from, and which series.
#pragma once

#include "cageproof/adaptive_qmvc/counted_rule.h"
#include "cageproof/closed_form/explain.h"
#include "cageproof/fast/triangle/hybrid.h"

namespace cageproof::closed_form::triangle {

/// Frames are computed in double-double and exact integers, which must not be counted: each of their numbers is one
/// operation, whose exact outcome is the geometry's.
template <>
template <>
Frame<Counted>::Frame(const Frame<double>& wider);

/// Tracked numbers take atanh where double takes its series; counted ones take either. \return what was set before
bool follow_tracked(bool tracked);
template <>
Counted atanh_excess<Counted>(const Counted& z);

}  // namespace cageproof::closed_form::triangle

namespace cageproof::fast::triangle {

using namespace closed_form;
using closed_form::triangle::follow_tracked;

/// What the frames of double see, beside what is there.
Frame<Counted> counted_frame(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta);

/// What is said of the form whose operations are counted. \param panels of a sum over Gauss points \param is_kept
/// whether its numbers are the hybrid's
std::string description_of(Route route, const Panels& panels, bool is_kept);

/// The counted numbers of the tensor of order O, in units of the frame, each entry from its component and monomial.
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
  std::array<Counted, F::parameter_count> parameters;
  for (int i = 0; i < F::parameter_count; ++i) parameters[i] = query.parameters[i];
  const bool is_near = found.route == Route::Near;
  const bool before = follow_tracked(!is_near);
  const auto components = found.route == Route::Panels
                              ? composed<F, O, Counted>(PanelFormOf<F, Counted, O>(frame, panels), parameters)
                              : near_components<F, O, Counted>(frame, parameters);
  follow_tracked(before);
  constexpr std::size_t size = O == 0 ? 1 : O == 1 ? 3 : 9;
  std::vector<Counted> counted;
  counted.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::array<int, 3> exponents{};
    if (O >= 1) ++exponents[i % 3];
    if (O >= 2) ++exponents[i / 3 % 3];
    const int m = Monomials<O>::place(exponents);
    counted.push_back(components[i / size].c[m] * derivative_factor<O>(m));
  }
  choose(explanation, tape, counted, (F::degree - O) * std::ilogb(seen.unit), values, entry);
  explanation.route = description_of(found.route, panels, explanation.is_the_value);
  return explanation;
}

template <class F>
Explanation explain_form(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  if (query.order == 0) return explain_order<F, 0>(query, values, entry);
  if (query.order == 1) return explain_order<F, 1>(query, values, entry);
  return explain_order<F, 2>(query, values, entry);
}

}  // namespace cageproof::fast::triangle
