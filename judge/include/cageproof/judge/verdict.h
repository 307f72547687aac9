// SPDX-License-Identifier: MIT
// Somebody else's implementation, judged: its convention, and its defects by name.
#pragma once

#include "cageproof/judge/convention.h"
#include "cageproof/validation/sample.h"

#include <span>

namespace cageproof::judge {

/// One row of the catalogue of defects. Rows stand in the order in which they are tried: if two rows explain a sample,
/// the first is named, because it is the more specific.
struct Defect {
  std::string_view key;        ///< "absolute_threshold"; also the anchor of its paragraph in docs/defects.md
  std::string_view sentence;   ///< what is wrong, in one sentence
  std::string_view signature;  ///< which relation breaks, and how it scales
  std::string_view advice;     ///< what to do instead
  std::string_view page;       ///< the page of docs/ that derives the right form, with its anchor
};

/// All defects that have a name.
std::span<const Defect> defects();
/// The row of that key. \throws InputError where there is none
const Defect& defect_named(std::string_view key);

/// A defect that was found, with the smallest input that proves it.
struct FoundDefect {
  const Defect* defect = nullptr;
  int order = 0;             ///< 0: the value shows it, 1: the gradient does
  validation::Sample input;  ///< shrunk as long as the defect shows; empty corners where no single input proves it
  std::vector<double> ours, theirs;  ///< tensors of that order at the input, in our convention and Result's order
  double error = 0;       ///< conditioned error there, in units of u; 0 where the truth is not what shows the defect
  std::size_t cases = 0;  ///< how many of the tried inputs it explains
  std::string evidence;   ///< what was seen, with figures
};

/// The convention and the defects of one evaluation.
struct Verdict {
  std::optional<Convention> convention;  ///< nothing where none fits all samples; judged as ours then
  std::string convention_sentence;       ///< the convention's, or why there is none
  std::vector<FoundDefect> findings;     ///< none: clean
  std::size_t samples = 0;               ///< inputs that were compared with the truth
  /// False where calls disturb each other, so that values mean nothing until that is mended.
  bool values_judged = true;
};

struct JudgeOptions {
  std::uint64_t seed = 1;
  int max_order = 1;  ///< 0: values only
};

/// Finds the convention, then tries each defect on purpose.
/// \param theirs in double; `hybrid` and any other evaluation can be judged too
/// \throws InputError where it has no double, or where the formula has no truth
Verdict judge(const Evaluation& theirs, const JudgeOptions& options = {});

}  // namespace cageproof::judge
