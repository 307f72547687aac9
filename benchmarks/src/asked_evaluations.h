// SPDX-License-Identifier: MIT
// Evaluations to compare: those that names, lists and globs ask for, or without any the most informative ones.
#pragma once

#include "cageproof/benchmarks/work_precision.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::benchmarks {

/// The subject of evaluations: a formula, or a kind of coordinates in a cage.
struct Subject {
  std::string_view name;
  std::vector<std::string_view> formulas;
  /// Evaluations that compute all coordinates of a kind at once, in addition to the formulas'.
  std::vector<std::string_view> whole;

  bool has_whole(std::string_view evaluation) const { return std::ranges::find(whole, evaluation) != whole.end(); }
};

/// A row a name, with one evaluation of each formula; the row of a whole evaluation is empty. \throws InputError that
/// names all that are missing
std::vector<std::vector<Evaluation>> find_all(const Subject& subject, const WorkPrecisionOptions& options);

/// The names of lists of names and globs, each once; without any, those that are shown: rules coarse to fine, the
/// recommended evaluation, printed forms. \param notes what is left out, and why, is added to them
/// \throws InputError where a name or glob means nothing
std::vector<std::string> evaluations_asked(const std::vector<std::string>& given, const Subject& subject, int order,
                                           std::vector<std::string>& notes);

}  // namespace cageproof::benchmarks
