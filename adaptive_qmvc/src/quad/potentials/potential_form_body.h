// SPDX-License-Identifier: MIT
// potential_form's body, compiled one file a scalar.
#pragma once

#include "quad/potentials/potential_form.h"

#include "quad/mean_value/line_form/line_form.h"
#include "quad/engine/more_digits.h"
#include "quad/potentials/potential_sums.h"
#include "inside_step.h"
#include "normal_axes.h"
#include "potential_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace cageproof::adaptive_qmvc {

template <class R>
void fill_nan(const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
  for (int o = 0; o <= task.order; ++o)
    tensors.of[o].assign(4 * kernel_tape(task.potential, task.order).entries[o].size(),
                         std::numeric_limits<R>::quiet_NaN());
  tensors.cancelled = 1;
}

template <Scalar R>
Statement potential_to_digits(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                              PotentialTensors<R>& tensors);

/// As potential_to_digits, in another scalar.
template <class W, Scalar R>
Statement potential_form_in(std::span<const Vec3<R>> corners, const Vec3<W>& point, const PotentialTask<R>& task,
                            double digits, PotentialTensors<R>& tensors) {
  std::array<Vec3<W>, 4> wide_corners;
  for (int k = 0; k < 4; ++k) wide_corners[k] = convert<W>(corners[k]);
  PotentialTensors<W> wide;
  const PotentialTask<W> asked{
      task.potential, task.order, digits, {W(task.parameters[0]), W(task.parameters[1])}, task.finite_part};
  const Statement statement = potential_to_digits<W>(wide_corners, point, asked, wide);
  for (int o = 0; o <= task.order; ++o) {
    tensors.of[o].resize(wide.of[o].size());
    std::ranges::transform(wide.of[o], tensors.of[o].begin(), [](const W& x) { return static_cast<R>(x); });
  }
  tensors.cancelled = wide.cancelled;
  return statement;
}

/// The digits of an integral, relative to the sizes of its terms, that a scalar can be asked for.
template <class R>
inline constexpr double kMostDigits = std::same_as<R, Mp200>         ? 185
                                      : std::same_as<R, Mp100>       ? 90
                                      : std::same_as<R, Mp50>        ? 42
                                      : std::same_as<R, long double> ? 17
                                                                     : 15;

/// As potential_form, in a scalar that has as many digits more as cancel, and in 50 digits at least.
/// \param cancelled how many times as large as the result its terms are known to be
template <Scalar R, class W>
Statement potential_form_in_more_digits(std::span<const Vec3<R>> corners, const Vec3<W>& point,
                                        const PotentialTask<R>& task, double cancelled, PotentialTensors<R>& tensors) {
  const Statement statement = with_what_cancels(
      task.digits, kMostDigits<Mp200>, kPotentialCancelled[0], cancelled, [&](double asked) -> Cancelled {
        const auto in = [&]<class N>() -> std::optional<Statement> {
          const bool holds = std::same_as<N, Mp200> || std::max(asked, kMostDigits<W>) <= kMostDigits<N>;
          if (!holds) return std::nullopt;
          return potential_form_in<N, R>(corners, convert<N>(point), task, asked, tensors);
        };
        const Statement found = in_first_of<Mp50, Mp100, Mp200>(in);
        return {found, tensors.cancelled};
      });
  // The digits that cancelled were added.
  tensors.cancelled = 1;
  return statement;
}

/// Whether a rule's derivatives along the quad are moved onto its border.
template <class R, class F>
bool turns_at(const LocalFrame<F>& frame, const OuterRule<R>& rule, const PotentialTask<R>& task) {
  return !rule.plain && tangential_tape(task.potential, task.order).tangential && has_normal_at(frame);
}

/// Adds a rule's part of the potential: with derivatives along the quad moved onto its border where lines are dense.
/// Vectors are turned in F's digits, and rounded once.
template <class R, class F>
void add_rule(const QuadFrame<F>& q, const LocalFrame<F>& frame, const OuterRule<R>& rule, const R& centre,
              std::span<const Panel> panels, const PotentialTask<R>& task, PotentialParts<R>& parts,
              Statement& statement) {
  const KernelTape& tangential = tangential_tape(task.potential, task.order);
  const bool turns = turns_at(frame, rule, task);
  const NormalAxes<F> axes = turns ? NormalAxes<F>(frame.n, frame.e) : NormalAxes<F>();
  const LocalFrame<R> local(turns ? turned(frame, axes) : frame);
  const LineReferences<R> references =
      rule.plain ? LineReferences<R>(local) : LineReferences<R>(local, QuadFrame<R>(turns ? turned(q, axes) : q));
  PotentialSums<R> sums(turns ? tangential : kernel_tape(task.potential, task.order), task.digits);
  statement.nodes += sums.add_lines(references, rule, centre, panels);
  if (turns) sums.add_border(references, rule, centre);
  statement.converged = statement.converged && rule.whole;
  parts.add(sums, NormalAxes<R>(axes), rule.plain ? 0 : static_cast<double>(R(rule.last - rule.first)));
}

/// The potential from rules that were found in more digits, and rounded once.
template <class R>
Statement potential_of_seen(const SeenQuad& seen, const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
  PotentialParts<R> parts(task);
  Statement statement;
  // Vectors of thin quads must be turned in more digits than double has; multiprecision has digits to spare.
  using F = std::conditional_t<is_multiprecision<R>, R, Mp50>;
  const QuadFrame<F> q(seen.frame);
  for (const SeenRule& rule : seen.rules)
    add_rule<R>(q, LocalFrame<F>(rule.frame), OuterRule<R>(rule.rule), static_cast<R>(rule.centre), rule.panels, task,
                parts, statement);
  parts.put(seen.frame.unit, tensors);
  return statement;
}

/// The same in a scalar N that has the digits asked for, though not R's. \returns nothing where more cancels than N has
/// digits for
template <class N, class R>
std::optional<Statement> potential_of_seen_in(const SeenQuad& seen, const PotentialTask<R>& task,
                                              PotentialTensors<R>& tensors) {
  const PotentialTask<N> narrow_task{task.potential,
                                     task.order,
                                     task.digits,
                                     {static_cast<N>(task.parameters[0]), static_cast<N>(task.parameters[1])}};
  PotentialTensors<N> narrow;
  const Statement statement = potential_of_seen<N>(seen, narrow_task, narrow);
  tensors.cancelled = narrow.cancelled;
  if (!(narrow.cancelled <= kPotentialCancelled[0])) return std::nullopt;
  for (int o = 0; o <= task.order; ++o) {
    tensors.of[o].resize(narrow.of[o].size());
    std::ranges::transform(narrow.of[o], tensors.of[o].begin(), [](const N& x) { return static_cast<R>(x); });
  }
  return statement;
}

/// As potential_of_seen, in the narrowest scalar that has the digits asked for: next to the quad nothing cancels, so
/// that more are spent in differences of coordinates alone, which stand in the frames.
/// \param distant whether coordinates' exponents are so far apart that powers of distances may leave a double's range
template <Scalar R>
Statement potential_of_seen_to_digits(const SeenQuad& seen, const PotentialTask<R>& task, bool distant,
                                      PotentialTensors<R>& tensors) {
  const auto in = [&]<class N>() -> std::optional<Statement> {
    if constexpr (std::same_as<N, R>) return potential_of_seen<R>(seen, task, tensors);
    else if (task.digits > kMostDigits<N> || (std::same_as<N, double> && distant)) return std::nullopt;
    else return potential_of_seen_in<N>(seen, task, tensors);
  };
  if constexpr (std::same_as<R, Mp200>) return in_first_of<double, long double, Mp50, Mp100, Mp200>(in);
  else if constexpr (std::same_as<R, Mp100>) return in_first_of<double, long double, Mp50, Mp100>(in);
  else if constexpr (std::same_as<R, Mp50>) return in_first_of<double, long double, Mp50>(in);
  else return in_first_of<R>(in);
}

/// As potential_to_digits, for a point in more digits than R has: differences are taken in those.
template <class W, Scalar R>
Statement potential_seen_in(std::span<const Vec3<R>> corners, const Vec3<W>& point, const PotentialTask<R>& task,
                            PotentialTensors<R>& tensors) {
  std::array<Vec3<W>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = corners[k].template cast<W>();
  return potential_of_seen_to_digits<R>(see_in_digits<W>(wide, point, task.order + 1, task.digits), task, true,
                                        tensors);
}

/// The limit from inside on the quad: the value at a point that much nearer to the inside that what is missing is below
/// a double's rounding.
template <Scalar R>
Statement potential_on_quad(std::span<const Vec3<R>> corners, const Vec3<R>& point, const BilinearPoint& on,
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
                            ? potential_seen_in<Mp800, R>(corners, step.point.template cast<Mp800>(), limited, tensors)
                            : potential_seen_in<Mp100, R>(corners, convert<Mp100>(step.point), limited, tensors);
  // 200 digits are the most, and whoever asked for them counts what cancels.
  if constexpr (!std::same_as<R, Mp200>)
    if (tensors.cancelled > kPotentialCancelled[0])
      statement = potential_form_in_more_digits<R, Mp200>(corners, step.point, limited, tensors.cancelled, tensors);
  // N.x is zero all over the quad, and not as small as the step.
  if (task.potential == Potential::BiharmonicDoubleLayer && is_in_plane<R>(corners, point))
    std::ranges::fill(tensors.of[0], R(0));
  return statement;
}

/// As potential_to_digits, for coordinates whose exponents are far apart.
template <Scalar R>
Statement potential_of_distant(std::span<const Vec3<R>> corners, const Vec3<R>& point, double order,
                               const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
  if (const auto on = place<R>(corners, point)) return potential_on_quad<R>(corners, point, *on, task, tensors);
  std::array<Vec3<Mp200>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = convert<Mp200>(corners[k]);
  const SeenQuad seen = see_in_800_digits(wide, convert<Mp200>(point), order, task.digits);
  if constexpr (is_multiprecision<R>) return potential_of_seen_to_digits<R>(seen, task, true, tensors);
  // Powers of distances leave a double's range.
  else if (const auto found = potential_of_seen_in<long double>(seen, task, tensors)) return *found;
  return potential_form_in_more_digits<R, R>(corners, point, task, tensors.cancelled, tensors);
}

/// As potential_form, to the digits that are asked for relative to the sizes of terms.
template <Scalar R>
Statement potential_to_digits(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                              PotentialTensors<R>& tensors) {
  Statement statement;
  // Values of the double layers jump like a constant, and each derivative adds one.
  const double order = task.order + 1;
  const Exponents exponents = exponents_of(corners, point);
  const auto of_distant = [&] { return potential_of_distant<R>(corners, point, order, task, tensors); };
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
      if (const auto on = place<R>(corners, point)) return potential_on_quad<R>(corners, point, *on, task, tensors);
    if constexpr (!is_multiprecision<R>)
      if (is_within(kDoubleHolds, *q, ends, singular)) {
        if (exponents.are_distant()) return of_distant();
        return potential_seen_in<Mp100, R>(corners, convert<Mp100>(point), task, tensors);
      }
    if constexpr (is_multiprecision<R>)
      return potential_of_seen_to_digits<R>(see_frame(*q, singular, order, task.digits), task, false, tensors);
    thread_local OuterRules<R> across;
    find_outer_rules(singular, order, task.digits, static_cast<int>(3 * task.digits), across, false);
    for (const OuterRule<R>& rule : across.rules) {
      const auto local =
          rule.plain ? LocalFrame<R>(*q) : frame_at<R>(*q, corners, point, std::clamp(rule.centre, rule.lo, rule.hi));
      if constexpr (!is_multiprecision<R>)
        if (turns_at(local, rule, task) && is_thin_at(local))
          return potential_seen_in<Mp100, R>(corners, convert<Mp100>(point), task, tensors);
      add_rule<R>(*q, local, rule, R(rule.centre - local.v0), across.panels_of(rule), task, parts, statement);
    }
  }
  parts.put(q->unit, tensors);
  return statement;
}

template <Scalar R>
Statement potential_form(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                         PotentialTensors<R>& tensors) {
  const Statement statement = potential_to_digits<R>(corners, point, task, tensors);
  if (tensors.cancelled <= kPotentialCancelled[0]) return statement;
  return potential_form_in_more_digits<R, R>(corners, point, task, tensors.cancelled, tensors);
}

extern template Statement potential_of_seen<double>(const SeenQuad&, const PotentialTask<double>&,
                                                    PotentialTensors<double>&);
extern template Statement potential_of_seen<long double>(const SeenQuad&, const PotentialTask<long double>&,
                                                         PotentialTensors<long double>&);
extern template Statement potential_of_seen<Mp50>(const SeenQuad&, const PotentialTask<Mp50>&, PotentialTensors<Mp50>&);
extern template Statement potential_of_seen<Mp100>(const SeenQuad&, const PotentialTask<Mp100>&,
                                                   PotentialTensors<Mp100>&);
extern template Statement potential_to_digits<double>(std::span<const Vec3<double>>, const Vec3<double>&,
                                                      const PotentialTask<double>&, PotentialTensors<double>&);
extern template Statement potential_to_digits<Mp50>(std::span<const Vec3<Mp50>>, const Vec3<Mp50>&,
                                                    const PotentialTask<Mp50>&, PotentialTensors<Mp50>&);
extern template Statement potential_to_digits<Mp100>(std::span<const Vec3<Mp100>>, const Vec3<Mp100>&,
                                                     const PotentialTask<Mp100>&, PotentialTensors<Mp100>&);
extern template Statement potential_to_digits<Mp200>(std::span<const Vec3<Mp200>>, const Vec3<Mp200>&,
                                                     const PotentialTask<Mp200>&, PotentialTensors<Mp200>&);

}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_POTENTIAL_OF_SEEN(R)                                          \
  template cageproof::Statement cageproof::adaptive_qmvc::potential_of_seen<R>( \
      const SeenQuad&, const PotentialTask<R>&, PotentialTensors<R>&);

#define CAGEPROOF_POTENTIAL_FORM(R)                                                                                   \
  template cageproof::Statement cageproof::adaptive_qmvc::potential_to_digits<R>(                                     \
      std::span<const cageproof::Vec3<R>>, const cageproof::Vec3<R>&, const PotentialTask<R>&, PotentialTensors<R>&); \
  template cageproof::Statement cageproof::adaptive_qmvc::potential_form<R>(                                          \
      std::span<const cageproof::Vec3<R>>, const cageproof::Vec3<R>&, const PotentialTask<R>&, PotentialTensors<R>&);
