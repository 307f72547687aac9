// SPDX-License-Identifier: MIT
// The hunt for evaluations' worst inputs: samples of the regimes, and local search from the worst of them.
#pragma once

#include "cageproof/core/results/error_measure.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/regime.h"

namespace cageproof::validation {

/// The regime of inputs that a hunt found: its climbs leave the regime they start from.
inline constexpr std::string_view hunted_regime = "hunted";

/// The error that the hunt makes large.
struct HuntObjective {
  Evaluation evaluation;
  const Check* check = nullptr;  ///< whose error
};

/// Options of a hunt, and its limits.
struct HuntOptions {
  const Formula* formula = nullptr;
  std::vector<HuntObjective> objectives;  ///< each is measured at every input, since the truth costs most
  ScalarKind scalar = ScalarKind::Double;
  int order = 0;                ///< the query's, and of the tensor that is looked at
  std::string regimes = "*";    ///< glob; those that do not exist for the formula's element are left out
  std::uint64_t budget = 1000;  ///< inputs measured
  std::uint64_t seed = 1;
  int jobs = 0;          ///< threads; 0: all cores
  std::size_t keep = 3;  ///< how many cases to return an objective, from climbs of their own
  /// Called from any thread when a case is worse than all before it; the order depends on the threads.
  std::function<void(const HuntObjective& objective, const WorstCase& worst, std::string_view regime)> improved;
};

/// The worst input of a climb.
struct HuntedCase {
  WorstCase worst;
  std::string_view regime;  ///< where the climb started; `worst` has the sample number and parameter of the start
  /// Relative difference of the truth and the integral, only for the worst case; nothing where the integral has no 30
  /// digits, or is the truth itself.
  std::optional<double> against_integral;
};

/// The findings for one objective.
struct HuntResult {
  std::vector<HuntedCase> worst;  ///< by falling error; empty where nothing could be measured
  std::uint64_t evaluations = 0;
  std::uint64_t without_truth = 0;
  std::uint64_t declined = 0;  ///< times the evaluation said that it could not meet its tolerance
};

/// Two fifths of the budget are samples of the regimes in turn. Climbs start from each regime's worst samples, equally
/// many per objective. A climb keeps every change that makes its objective's error larger, and has its own random
/// stream; errors of the other objectives on its way are kept too. The result depends only on the options, not on the
/// number of threads. Inputs lie within the hull of the regimes (src/search_domain.h). \return one result per objective
/// \throws InputError when no regime matches, a check is not asked of its evaluation in this scalar and order, nothing
///   gives the formula's truth, or no objective could be measured at any input
std::vector<HuntResult> hunt(const HuntOptions& options);

}  // namespace cageproof::validation
