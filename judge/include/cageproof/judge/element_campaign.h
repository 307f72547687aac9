// SPDX-License-Identifier: MIT
// Foreign code against the truth, over all regimes of a formula.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/judge/foreign_code.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cageproof::judge {

struct ElementCampaignOptions {
  int samples = 200;  ///< a regime; of formulas whose truths are integrals an eighth of them
  std::uint64_t seed = 1;
  std::string regimes = "*";  ///< names and globs
  bool single = false;        ///< in float
  int jobs = 0;               ///< threads for the truths; 0: one per core
  /// The code in our convention (in_our_convention), which is asked instead of the code itself where it has another.
  std::optional<Evaluation> ours = {};
  /// Called as truths are found, from any thread.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// The largest error of some samples, and where.
struct LargestError {
  double error = 0;   ///< infinite where a result was not finite and the truth is
  double median = 0;  ///< of all samples
  std::string input;  ///< a line of `eval`
};

/// Errors found in one regime at one order. Errors are norm-wise over the tensor.
struct CampaignRow {
  std::string regime;
  int order = 0;
  int samples = 0;        ///< that were measured
  int without_truth = 0;  ///< the limit diverges or does not exist, or the input is none in float
  int declined = 0, failed = 0;
  int nonfinite = 0;         ///< of the measured ones: NaN or infinite where the truth is finite
  int zero = 0;              ///< of the measured ones: truth exactly zero, which has no relative error
  LargestError relative;     ///< |f - truth| / |truth|
  LargestError conditioned;  ///< in units of u (errors.md)
  LargestError absolute;     ///< |f - truth|
  LargestError beside, on;   ///< conditioned, of points off the element, and exactly on it
  LargestError continuous;   ///< conditioned, of points on a cage and coordinates that do not jump across it
  std::string nonfinite_input;
  int wrong = 0;            ///< of sides: wrong answers among the measured ones
  std::string first_wrong;  ///< "on, and yours says outside", at absolute.input
};

/// Time for a pair of an element and a point, in blocks of 64 points each.
struct PairTime {
  std::string evaluation;
  int order = 0;
  double nanoseconds = 0;
};

/// Rows and times of one formula, or of one kind of coordinates.
struct SubjectCampaign {
  std::string subject;  ///< the formula's name, or the kind's
  bool is_kind = false;
  int order = 0;  ///< highest that the code gives
  std::vector<CampaignRow> rows;
  std::vector<PairTime> times;
  int dimension = 3;       ///< of a kind's cages
  bool has_sides = false;  ///< answers are sides of a cage, right or wrong, and not numbers with errors
};

/// Asks all samples, in one process as far as it lives, and measures the answers. Rows are of the formula that
/// options.ours computes, where it is set, and to its order.
/// \param formula what the code is asked for \pre code.order_of(formula) >= 0
SubjectCampaign run_element_campaign(ForeignCode& code, const Formula& formula, const std::string& name,
                                     const ElementCampaignOptions& options);

}  // namespace cageproof::judge
