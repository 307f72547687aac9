// SPDX-License-Identifier: MIT
// A potential as the sum of its rules' parts: in the caller's scalar, or in the narrowest that has the digits asked
// for.
#pragma once

#include "quad/potentials/potential_form.h"

#include "quad/mean_value/line_form/line_form.h"
#include "quad/engine/more_digits.h"
#include "quad/potentials/potential_sums.h"
#include "normal_axes.h"
#include "potential_parts.h"

#include <algorithm>
#include <type_traits>

namespace cageproof::adaptive_qmvc {

/// The digits of an integral, relative to the sizes of its terms, that a scalar can be asked for.
template <class R>
inline constexpr double kMostDigits = std::same_as<R, Mp200>         ? 185
                                      : std::same_as<R, Mp100>       ? 90
                                      : std::same_as<R, Mp50>        ? 42
                                      : std::same_as<R, long double> ? 17
                                                                     : 15;

/// Asks in another scalar, and rounds what comes to the caller's.
/// \param compute called with a PotentialTask<W> and the PotentialTensors<W> that it fills
template <class W, class R, class Compute>
Statement in_scalar(const PotentialTask<R>& task, double digits, PotentialTensors<R>& tensors, const Compute& compute) {
  const PotentialTask<W> asked{task.potential,
                               task.order,
                               digits,
                               {static_cast<W>(task.parameters[0]), static_cast<W>(task.parameters[1])},
                               task.finite_part};
  PotentialTensors<W> found;
  const Statement statement = compute(asked, found);
  for (int o = 0; o <= task.order; ++o) {
    tensors.of[o].resize(found.of[o].size());
    std::ranges::transform(found.of[o], tensors.of[o].begin(), [](const W& x) { return static_cast<R>(x); });
  }
  tensors.cancelled = found.cancelled;
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
Statement sum_rules(const SeenQuad& seen, const PotentialTask<R>& task, PotentialTensors<R>& tensors) {
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

/// As sum_rules, in a scalar N that has the digits asked for, though not R's. \returns nothing where more cancels than
/// N has digits for
template <class N, class R>
std::optional<Statement> sum_rules_in(const SeenQuad& seen, const PotentialTask<R>& task,
                                      PotentialTensors<R>& tensors) {
  const Statement statement = in_scalar<N>(
      task, task.digits, tensors,
      [&](const PotentialTask<N>& asked, PotentialTensors<N>& found) { return sum_rules<N>(seen, asked, found); });
  return tensors.cancelled <= kPotentialCancelled[0] ? std::optional(statement) : std::nullopt;
}

/// As sum_rules, in the narrowest scalar that has the digits asked for. Next to the quad nothing cancels, so that only
/// differences of coordinates need more digits, and these stand in the frames.
/// \param distant whether coordinates' exponents are so far apart that powers of distances may leave a double's range
template <Scalar R>
Statement sum_rules_narrowly(const SeenQuad& seen, const PotentialTask<R>& task, bool distant,
                             PotentialTensors<R>& tensors) {
  const auto in = [&]<class N>() -> std::optional<Statement> {
    if constexpr (std::same_as<N, R>) return sum_rules<R>(seen, task, tensors);
    else if (task.digits > kMostDigits<N> || (std::same_as<N, double> && distant)) return std::nullopt;
    else return sum_rules_in<N>(seen, task, tensors);
  };
  if constexpr (std::same_as<R, Mp200>) return in_first_of<double, long double, Mp50, Mp100, Mp200>(in);
  else if constexpr (std::same_as<R, Mp100>) return in_first_of<double, long double, Mp50, Mp100>(in);
  else if constexpr (std::same_as<R, Mp50>) return in_first_of<double, long double, Mp50>(in);
  else return in_first_of<R>(in);
}

extern template Statement sum_rules<double>(const SeenQuad&, const PotentialTask<double>&, PotentialTensors<double>&);
extern template Statement sum_rules<long double>(const SeenQuad&, const PotentialTask<long double>&,
                                                 PotentialTensors<long double>&);
extern template Statement sum_rules<Mp50>(const SeenQuad&, const PotentialTask<Mp50>&, PotentialTensors<Mp50>&);
extern template Statement sum_rules<Mp100>(const SeenQuad&, const PotentialTask<Mp100>&, PotentialTensors<Mp100>&);
}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_SUM_OF_RULES(R)                                                                                \
  template cageproof::Statement cageproof::adaptive_qmvc::sum_rules<R>(const SeenQuad&, const PotentialTask<R>&, \
                                                                       PotentialTensors<R>&);
