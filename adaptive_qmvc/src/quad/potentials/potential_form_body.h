// SPDX-License-Identifier: MIT
// potential_form's body; each scalar is compiled in a file of its own.
#pragma once

#include "quad/potentials/potential_form.h"

#include "inside_step.h"
#include "rule_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::adaptive_qmvc {

template <class R>
void fill_nan(const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
  for (int o = 0; o <= task.order; ++o)
    tensors.of[o].assign(4 * kernel_tape(task.potential, task.order).entries[o].size(),
                         std::numeric_limits<R>::quiet_NaN());
  tensors.cancelled = 1;
}

template <Scalar R>
Statement evaluate_once(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                        PotentialTensors<R>& tensors);

/// As evaluate_once, in a scalar that has as many digits more as cancel, and in 50 digits at least.
/// \param cancelled how many times as large as the result its terms are known to be
template <Scalar R, class W>
Statement evaluate_in_more_digits(std::span<const Vec3<R>> corners, const Vec3<W>& point, const PotentialTask<R>& task,
                                  double cancelled, PotentialTensors<R>& tensors) {
  const Statement statement = with_what_cancels(
      task.digits, kMostDigits<Mp200>, kPotentialCancelled[0], cancelled, [&](double asked) -> Cancelled {
        const auto in = [&]<class N>() -> std::optional<Statement> {
          const bool holds = std::same_as<N, Mp200> || std::max(asked, kMostDigits<W>) <= kMostDigits<N>;
          if (!holds) return std::nullopt;
          std::array<Vec3<N>, 4> wide;
          for (int k = 0; k < 4; ++k) wide[k] = convert<N>(corners[k]);
          return in_scalar<N>(task, asked, tensors, [&](const PotentialTask<N>& more, PotentialTensors<N>& found) {
            return evaluate_once<N>(wide, convert<N>(point), more, found);
          });
        };
        const Statement found = in_first_of<Mp50, Mp100, Mp200>(in);
        return {found, tensors.cancelled};
      });
  // The digits that cancelled were added.
  tensors.cancelled = 1;
  return statement;
}

/// As evaluate_once, for a point in more digits than R has, off the quad: differences are taken in those.
template <class W, Scalar R>
Statement sum_seen_from(std::span<const Vec3<R>> corners, const Vec3<W>& point, const PotentialTask<R>& task,
                        PotentialTensors<R>& tensors) {
  std::array<Vec3<W>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = corners[k].template cast<W>();
  return sum_rules_narrowly<R>(see_in_digits<W>(wide, point, task.order + 1, task.digits), task, true, tensors);
}

/// The limit from inside on the quad: the value at a point that much nearer to the inside that what is missing is below
/// a double's rounding.
template <Scalar R>
Statement limit_on_quad(std::span<const Vec3<R>> corners, const Vec3<R>& point, const BilinearPoint& on,
                        const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
  const InsideStep step = step_inside<R>(corners, point, on, is_multiprecision<R>);
  if (!step.exists) {
    fill_nan(task, tensors);
    return {};
  }
  // As seen from one inside: what elements of a cage that meet there add up to depends on no direction.
  const auto has_limit = [&](int o) {
    return !step.border || has_border_limit(task.potential, o) || (task.finite_part && o == 0);
  };
  PotentialTask<R> limited = task;
  while (limited.order >= 0 && !has_limit(limited.order)) --limited.order;
  fill_nan(task, tensors);
  if (limited.order < 0) return {};
  Statement statement = step.tiny
                            ? sum_seen_from<Mp800, R>(corners, step.point.template cast<Mp800>(), limited, tensors)
                            : sum_seen_from<Mp100, R>(corners, convert<Mp100>(step.point), limited, tensors);
  // 200 digits are the most, and whoever asked for them counts what cancels.
  if constexpr (!std::same_as<R, Mp200>)
    if (tensors.cancelled > kPotentialCancelled[0])
      statement = evaluate_in_more_digits<R, Mp200>(corners, step.point, limited, tensors.cancelled, tensors);
  // N.x is zero all over the quad, and not as small as the step.
  if (task.potential == Potential::BiharmonicDoubleLayer && is_in_plane<R>(corners, point))
    std::ranges::fill(tensors.of[0], R(0));
  return statement;
}

/// As evaluate_once, for coordinates whose exponents are far apart.
template <Scalar R>
Statement evaluate_distant(std::span<const Vec3<R>> corners, const Vec3<R>& point, double order,
                           const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
  if (const auto on = place_on_quad<R>(corners, point)) return limit_on_quad<R>(corners, point, *on, task, tensors);
  std::array<Vec3<Mp200>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = convert<Mp200>(corners[k]);
  const SeenQuad seen = see_in_800_digits(wide, convert<Mp200>(point), order, task.digits);
  if constexpr (is_multiprecision<R>) return sum_rules_narrowly<R>(seen, task, true, tensors);
  // Powers of distances leave a double's range.
  else if (const auto found = sum_rules_in<long double>(seen, task, tensors)) return *found;
  return evaluate_in_more_digits<R, R>(corners, point, task, tensors.cancelled, tensors);
}

/// To the digits that are asked for relative to the sizes of terms, whatever cancels, by where the point lies: far away
/// by one rule; on the quad by its limit; so close that R loses too much by differences in more digits; else by rules.
template <Scalar R>
Statement evaluate_once(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                        PotentialTensors<R>& tensors) {
  Statement statement;
  // Values of the double layers jump like a constant, and each derivative adds one.
  const double order = task.order + 1;
  const Exponents exponents = exponents_of(corners, point);
  const auto of_distant = [&] { return evaluate_distant<R>(corners, point, order, task, tensors); };
  if (exponents.finite && (is_multiprecision<R> ? exponents.are_distant() : exponents.are_extreme()))
    return of_distant();
  const auto q = quad_frame<R>(corners, point);
  if (!q) {
    fill_nan(task, tensors);
    return statement;
  }
  if constexpr (!is_multiprecision<R>)
    if (exponents.are_distant() && (has_short_side(*q) || is_all_but_in_plane(*q, exponents))) return of_distant();
  PotentialParts<R> parts(task);
  const double ends = distance_of_ends(*q);
  if (const double rho = ellipse_from_distance(*q, ends); rho >= kFarAcross) {
    const Panel panel = plain_panel(rho, order, task.digits);
    add_rule<R>(*q, LocalFrame<R>(*q), OuterRule<R>{}, R(0), {&panel, 1}, task, parts, statement);
  } else {
    const SingularPairs<R> singular = singular_pairs(*q);
    if (is_within(1e-12, *q, ends, singular))
      if (const auto on = place_on_quad<R>(corners, point)) return limit_on_quad<R>(corners, point, *on, task, tensors);
    if (is_within(kHolds<R>, *q, ends, singular)) {
      if (is_multiprecision<R> || exponents.are_distant()) return of_distant();
      return sum_seen_from<Mp100, R>(corners, convert<Mp100>(point), task, tensors);
    }
    if constexpr (is_multiprecision<R>)
      return sum_rules_narrowly<R>(see_frame(*q, singular, order, task.digits), task, false, tensors);
    thread_local OuterRules<R> across;
    find_outer_rules(singular, order, task.digits, static_cast<int>(3 * task.digits), across, false);
    for (const OuterRule<R>& rule : across.rules) {
      const auto local =
          rule.plain ? LocalFrame<R>(*q) : frame_at<R>(*q, corners, point, std::clamp(rule.centre, rule.lo, rule.hi));
      if constexpr (!is_multiprecision<R>)
        if (turns_at(local, rule, task) && is_thin_at(local))
          return sum_seen_from<Mp100, R>(corners, convert<Mp100>(point), task, tensors);
      add_rule<R>(*q, local, rule, R(rule.centre - local.v0), across.panels_of(rule), task, parts, statement);
    }
  }
  parts.put(q->unit, tensors);
  return statement;
}

template <Scalar R>
Statement potential_form(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                         PotentialTensors<R>& tensors) {
  const Statement statement = evaluate_once<R>(corners, point, task, tensors);
  if (tensors.cancelled <= kPotentialCancelled[0]) return statement;
  return evaluate_in_more_digits<R, R>(corners, point, task, tensors.cancelled, tensors);
}

extern template Statement evaluate_once<double>(std::span<const Vec3<double>>, const Vec3<double>&,
                                                const PotentialTask<double>&, PotentialTensors<double>&);
extern template Statement evaluate_once<Mp50>(std::span<const Vec3<Mp50>>, const Vec3<Mp50>&,
                                              const PotentialTask<Mp50>&, PotentialTensors<Mp50>&);
extern template Statement evaluate_once<Mp100>(std::span<const Vec3<Mp100>>, const Vec3<Mp100>&,
                                               const PotentialTask<Mp100>&, PotentialTensors<Mp100>&);
extern template Statement evaluate_once<Mp200>(std::span<const Vec3<Mp200>>, const Vec3<Mp200>&,
                                               const PotentialTask<Mp200>&, PotentialTensors<Mp200>&);

}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_POTENTIAL_FORM(R)                                                                                   \
  template cageproof::Statement cageproof::adaptive_qmvc::evaluate_once<R>(                                           \
      std::span<const cageproof::Vec3<R>>, const cageproof::Vec3<R>&, const PotentialTask<R>&, PotentialTensors<R>&); \
  template cageproof::Statement cageproof::adaptive_qmvc::potential_form<R>(                                          \
      std::span<const cageproof::Vec3<R>>, const cageproof::Vec3<R>&, const PotentialTask<R>&, PotentialTensors<R>&);
