// SPDX-License-Identifier: MIT
// Questions to single elements: one check of one evaluation in one scalar.
#pragma once

#include "cageproof/validation/check.h"

#include <optional>

namespace cageproof::validation {

/// A sample, its truth and what evaluations give there, each found when first asked for. Not for several threads at
/// once.
class ElementAt {
 public:
  /// \param source of the truth, which outlives this \param order the highest of the truth
  ElementAt(const TruthSource& source, Sample sample, int order = 2)
      : source_(source), sample_(std::move(sample)), order_(order) {}

  ElementAt(const ElementAt&) = delete;
  ElementAt& operator=(const ElementAt&) = delete;

  const Sample& sample() const { return sample_; }
  const Truth& truth() const;
  ResultsAtSample& results() const { return results_; }
  std::uint64_t number() const { return sample_.index; }
  WorstCase case_of(const Finding& finding, int order) const;

 private:
  const TruthSource& source_;
  Sample sample_;
  int order_;
  mutable std::optional<Truth> truth_;
  mutable ResultsAtSample results_{sample_};
};

/// A check of an evaluation in a scalar.
struct ElementQuestion : Question<ElementAt> {
  const Check* check;
  Evaluation evaluation;
  ScalarKind scalar;
};

/// The question of a check to an evaluation; nothing where it is not asked. \param order the highest, at most the
/// evaluation's
std::optional<ElementQuestion> element_question(const Check& check, const Evaluation& evaluation, ScalarKind scalar,
                                                std::string_view regime, int order);

/// The question that a row's figures answer. \param asked the highest derivative, as the row's cases store it
/// \throws InputError when a name is unknown, or the row's check is not asked
ElementQuestion element_question(const RowKey& row, int asked);

}  // namespace cageproof::validation
