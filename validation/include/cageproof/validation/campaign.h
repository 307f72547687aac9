// SPDX-License-Identifier: MIT
// A campaign: formulas x evaluations x regimes x samples, from one seed, on all cores, with one result.
#pragma once

#include "cageproof/core/run_result.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/regime.h"

namespace cageproof::validation {

/// What a campaign looks at. Patterns are globs.
struct CampaignOptions {
  std::string formulas = "*";
  std::string evaluations = "*";
  std::string regimes = "*";
  std::uint64_t seed = 1;
  int samples = 1000;          ///< a formula and regime, in double
  int quadrature_divisor = 7;  ///< quadrature rules and float take every n-th of them; prime to every sweep's length
  int integral_samples = 4;    ///< a formula and regime, for the multiprecision integral
  /// A formula and regime, enclosed rigorously; not limited by `samples`. 1000 is a proof run: 40 minutes on two free cores.
  int enclosures = 1;
  int jobs = 0;                ///< threads; 0: all cores
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< called from any thread
};

/// Rows and curves of a campaign, and notes on what the integral reached. Independent of `jobs`, byte for byte.
struct CampaignResult {
  std::vector<ResultRow> rows;
  std::vector<ResultCurve> curves;
  std::vector<std::string> notes;
};

/// \throws InputError when a pattern matches nothing
CampaignResult run_campaign(const CampaignOptions& options);

/// Sets bound, reason and verdict of a row from the table of promises.
void judge(ResultRow& row);

/// Runs `task(i)` for i in [0, count) on `jobs` threads (0: all cores).
void for_each_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& task);

}  // namespace cageproof::validation
