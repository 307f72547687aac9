// SPDX-License-Identifier: MIT
// The line form in numbers that count. Where lines are taken is decided in double, as ever; the sums over them are
// counted, and differences in double-double are taken over as a whole.
#include "instances.h"

#include "cageproof/adaptive_qmvc/counted_rule.h"
#include "cageproof/closed_form/explain.h"

namespace cageproof::adaptive_qmvc {
namespace {

using closed_form::Counted;
using closed_form::CountedTape;
using closed_form::Explanation;

constexpr double kDigits = 17;  // as line_form asks for in double
constexpr const char* kFrame = "adaptive_qmvc/src/quad/engine/local_frame.h";

// Where a line's map begins or ends: the only numbers of a rule whose roundings matter.
Counted end_of(const OuterRule<double>& rule, double value, double v) {
  if (rule.plain) return value;
  const Mp200 exact = asinh((Mp200(v) - Mp200(rule.centre)) / Mp200(rule.width));
  return Counted::seen(value, exact, "asinh", "adaptive_qmvc/src/quad/engine/outer_rule.h");
}

OuterRule<Counted> counted_rule(const OuterRule<double>& rule) {
  OuterRule<Counted> counted;
  counted.plain = rule.plain;
  counted.centre = rule.centre;
  counted.width = rule.width;
  counted.lo = rule.lo;
  counted.hi = rule.hi;
  counted.first = end_of(rule, rule.first, rule.lo);
  counted.last = end_of(rule, rule.last, rule.hi);
  return counted;
}

// Takes double's heights over the corners, which are exact except for their roundings.
QuadFrame<Counted> with_heights(QuadFrame<Counted> q, const QuadFrame<double>& plain,
                                std::span<const Vec3<double>> corners, const Vec3<double>& point) {
  std::array<Vec3<Mp200>, 4> x;
  const Vec3<Mp200> from = convert<Mp200>(point);
  for (int k = 0; k < 4; ++k)
    x[k] = ldexp(Mp200(1), -q.unit.exponent) * Vec3<Mp200>(convert<Mp200>(corners[q.unit.corner[k]]) - from);
  std::array<Counted, 4> heights;
  for (int k = 0; k < 4; ++k) {
    const Vec3<Mp200> before = x[k] - x[(k + 3) % 4], after = x[(k + 1) % 4] - x[k];
    heights[k] = Counted::seen(plain.height[k], x[k].dot(before.cross(after)), "height_at_corner",
                               "adaptive_qmvc/src/quad/engine/corner_heights.h");
  }
  q.take(heights);
  return q;
}

// frame_at, with double's choice of the point.
LocalFrame<Counted> counted_frame_at(const QuadFrame<Counted>& q, const QuadFrame<double>& plain,
                                     std::span<const Vec3<double>> corners, const Vec3<double>& point, double line) {
  const LocalFrame<double> local = frame_at<double>(plain, corners, point, line);
  const Mp200 u(local.u0), v(local.v0);
  Vec3<Counted> seen;
  for (int i = 0; i < 3; ++i) {
    std::array<Mp200, 4> x;
    for (int k = 0; k < 4; ++k) x[k] = ldexp(Mp200(corners[q.unit.corner[k]][i]) - Mp200(point[i]), -q.unit.exponent);
    const Mp200 across = x[3] - x[0];
    seen[i] = Counted::seen(local.a[i], x[0] + u * (x[1] - x[0]) + v * (across + u * ((x[2] - x[1]) - across)),
                            "seen_at", kFrame);
  }
  return {q, Counted(local.u0), Counted(local.v0), seen};
}

template <int Order>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  Explanation explanation;
  const auto plain = quad_frame<double>(query.corners, query.point);
  const double ends = plain ? distance_of_ends(*plain) : 0;
  const double rho = plain ? ellipse_from_distance(*plain, ends) : 0;
  const SingularPairs<double> singular = plain ? singular_pairs(*plain) : SingularPairs<double>();
  const bool far = plain && rho >= far_across<double, Order>;
  const Exponents exponents = exponents_of(query.corners, query.point);
  const bool extreme = exponents.are_extreme() || (plain && exponents.are_distant() &&
                                                   (has_short_side(*plain) || is_all_but_in_plane(*plain, exponents)));
  if (!plain || extreme || (!far && is_within(kHolds<double>, *plain, ends, singular))) {
    explanation.route =
        "none in double: on the quad, so close to it that differences are taken in 50 digits, or at the ends of "
        "doubles' "
        "range";
    choose_none(explanation, values, entry);
    return explanation;
  }
  const CountedTape tape;
  std::array<Vec3<Counted>, 4> corners;
  for (int k = 0; k < 4; ++k) corners[k] = convert<Counted>(query.corners[k]);
  const QuadFrame<Counted> q =
      with_heights(*quad_frame<Counted>(corners, convert<Counted>(query.point)), *plain, query.corners, query.point);
  constexpr double order = Order + 1.5;
  WeightSums<Counted, Order> sums;
  if (far) {
    const Panel panel = plain_panel(rho, order, kDigits);
    add_lines<Order>(LineReferences<Counted>(LocalFrame<Counted>(q)), OuterRule<Counted>{}, Counted(0.0), {&panel, 1},
                     kDigits, sums);
    explanation.route = "line form in double, far away";
  } else {
    OuterRules<double> across;
    find_outer_rules(singular, order, kDigits, static_cast<int>(3 * kDigits), across);
    for (const OuterRule<double>& rule : across.rules) {
      const auto local = rule.plain ? LocalFrame<Counted>(q)
                                    : counted_frame_at(q, *plain, query.corners, query.point,
                                                       std::clamp(rule.centre, rule.lo, rule.hi));
      const OuterRule<Counted> counted = counted_rule(rule);
      add_lines<Order>(LineReferences<Counted>(local, q), counted, Counted(counted.centre - local.v0),
                       across.panels_of(rule), kDigits, sums);
    }
    explanation.route = "line form in double, " + std::to_string(across.rules.size()) + " rules across the lines";
    WeightTensors<double> weights;
    line_form<Order, double>(query.corners, query.point, kDigits, weights);
    if (weights.cancelled > kCancelled)
      explanation.route += ", given up for 50 digits or more, as the terms of a fold's sheets cancel";
  }
  // The entries of WeightSums are those of an upper triangle.
  constexpr std::array<int, 9> upper{4, 5, 6, 5, 7, 8, 6, 8, 9};
  constexpr std::size_t size = Order == 0 ? 1 : Order == 1 ? 3 : 9;
  std::vector<Counted> counted(values.size());
  for (int k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < size; ++i)
      counted[size * q.unit.corner[k] + i] =
          q.unit.sign * sums.corner[k][Order == 0   ? 0
                                       : Order == 1 ? 1 + i
                                                    : static_cast<std::size_t>(upper[i])];
  choose(explanation, tape, counted, -(Order + 1) * q.unit.exponent, values, entry);
  if (Order == 0) explanation.route += ", one line at a time instead of four";
  return explanation;
}

Explanation explain(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  if (query.order == 0) return explain_order<0>(query, values, entry);
  if (query.order == 1) return explain_order<1>(query, values, entry);
  return explain_order<2>(query, values, entry);
}

const closed_form::RegisterExplainer explainer{"quad.mean_value", "line_form", &explain};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
