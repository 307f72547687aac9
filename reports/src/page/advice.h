// SPDX-License-Identifier: MIT
// Advice which evaluation to take: errors and times of a formula's evaluations side by side.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <optional>
#include <string>
#include <vector>

namespace cageproof::reports {

/// The times of a run: those of the first of its sessions that took any.
const std::vector<EvaluationTime>& times_of(const RunResult& result);

/// Nanoseconds of an evaluation in double; nothing where it was not timed.
std::optional<double> time_of(const RunResult& result, const std::string& formula, const std::string& evaluation,
                              int order);

/// Down to which distance, in sizes of the element, an evaluation's values in double keep twelve digits, 1e4 units of
/// the conditioned error: the smallest decade above which all regimes near-* do, and `generic` too; nothing where they
/// do not keep them at the largest.
std::optional<double> reach_of(const RunResult& result, const std::string& formula, const std::string& evaluation);

/// An evaluation to take, with the distance (element sizes) down to which values keep twelve digits, and its time.
struct Choice {
  std::string evaluation;
  double reach = 0, nanoseconds = 0;
  bool recommended = false;
};

/// The quickest first, each further one slower and more accurate: a rule is left out where another choice takes no more
/// time and reaches no less far. The recommended one always stays, since it is what promises are made of; where a
/// rule is better in both, that rule stands before it.
std::vector<Choice> without_dominated(std::vector<Choice> choices);

/// "12 digits down to 1e-2 sizes: gauss-8, 1.1 us; everywhere: closed_form, 0.9 us (gradient 1.6 us, Hessian 3 us)";
/// empty where nothing was timed.
std::string advice(const RunResult& result, const std::string& formula);

}  // namespace cageproof::reports
