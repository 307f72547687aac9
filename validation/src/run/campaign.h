// SPDX-License-Identifier: MIT
// A campaign: formulas x evaluations x regimes x samples, from one seed, on all cores, with one result.
#pragma once

#include "cageproof/validation/check.h"
#include "cageproof/validation/measurement.h"
#include "cageproof/validation/regime.h"
#include "promises/verdicts.h"

namespace cageproof::validation {

/// Selection of a campaign. Patterns are globs.
struct CampaignOptions {
  std::string formulas = "*";
  std::string evaluations = "*";
  std::string regimes = "*";
  std::uint64_t seed = 1;
  int samples = 1000;  ///< for each formula and regime, in double
  /// Where a parameter is swept, a sample for each of its values, at most so many, if that is more than `samples`.
  int swept_samples = 0;
  int quadrature_divisor = 7;  ///< rules, schemes and float take every n-th of them; prime to every sweep's length
  /// For each formula and regime that sweeps a parameter, for the multiprecision integral; half where nothing is swept,
  /// but two at least.
  int integral_samples = 4;
  /// Numbers of an order's tensor, at most, that such an integral is asked for at points on an element, where truths
  /// are costly, and nine times as many where a distance is swept; 0: any. Values are always asked.
  std::size_t integral_entries = 0;
  /// For each formula and regime, enclosed rigorously; not limited by `samples`. 1000 is a proof run: 40 minutes on two
  /// free cores.
  int enclosures = 1;
  int jobs = 0;                                                     ///< threads; 0: all cores
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< called from any thread
};

/// One for each formula in each regime.
/// \throws InputError when a pattern matches nothing
Measurements element_measurements(const CampaignOptions& options);

/// One note for each formula of a glob whose truth is the integral, since it has no recommended evaluation.
std::vector<std::string> notes_on_truth(const std::string& formulas);

/// Measures and judges them. Independent of `jobs`, byte for byte.
/// \throws InputError as element_measurements
Judged run_campaign(const CampaignOptions& options);

}  // namespace cageproof::validation
