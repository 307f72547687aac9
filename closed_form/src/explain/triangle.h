// SPDX-License-Identifier: MIT
// The triangle's closed forms in numbers that count. The engine's templates are taken as they are; what they have for
// double alone is said for Counted here: where geometry comes from, and which series.
#pragma once

#include "cageproof/closed_form/arithmetic/counted_rule.h"
#include "cageproof/closed_form/explain.h"
#include "cageproof/closed_form/triangle/engine/closed_form.h"

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

/// What the frames of double see, beside what is there.
Frame<Counted> counted_frame(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta);

/// Which form of the engine closed_form() takes in double, as it decides.
struct Route {
  enum class Form { None, Near, Tracked, Points } form = Form::Near;
  Panels panels{};
};

template <class F, int O>
Route route_of(const Triangle<double>& t, const Vec3<double>& eta, const Frame<double>& f, bool finite_part) {
  using Form = Route::Form;
  if (f.extreme) return {Form::None};
  int limit = first_divergent<F>(f);
  if (limit == 0 && finite_part) limit = 1;
  if (F::diverges_on_triangle && limit < 3) return {Form::None};
  if (limit == 3)
    if (Panels panels = cut_to_panels(f, t, eta, panels_wanted<F, O>(f)); !panels.empty())
      return {Form::Points, std::move(panels)};
  return {F::cancels_nearby || f.shape() < kThinShape ? Form::Tracked : Form::Near};
}

/// What is said of a route. \param is_kept whether its numbers are the closed form's
std::string description_of(const Route& route, bool is_kept);

/// The counted numbers of the tensor of order O, in units of the frame, each entry from its component and monomial.
template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Triangle<double> t{query.corners[0], query.corners[1], query.corners[2]};
  const Frame<double> seen(t, query.point);
  const Route route = route_of<F, O>(t, query.point, seen, query.finite_part);
  Explanation explanation;
  if (route.form == Route::Form::None) {
    choose_none(explanation, values, entry);
    explanation.route = description_of(route, false);
    return explanation;
  }
  const CountedTape tape;
  const Frame<Counted> frame = counted_frame(seen, t, query.point);
  std::array<Counted, F::parameter_count> parameters;
  for (int i = 0; i < F::parameter_count; ++i) parameters[i] = query.parameters[i];
  const bool before = follow_tracked(route.form == Route::Form::Tracked);
  const auto components = route.form == Route::Form::Points
                              ? composed<F, O, Counted>(PanelFormOf<F, Counted, O>(frame, route.panels), parameters)
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
  explanation.route = description_of(route, explanation.is_the_value);
  return explanation;
}

template <class F>
Explanation explain_form(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  if (query.order == 0) return explain_order<F, 0>(query, values, entry);
  if (query.order == 1) return explain_order<F, 1>(query, values, entry);
  return explain_order<F, 2>(query, values, entry);
}

}  // namespace cageproof::closed_form::triangle
