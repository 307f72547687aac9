// SPDX-License-Identifier: MIT
// The table of promised bounds: the one place where a bound is written.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/name_pattern.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::validation {

/// The promise for one row of results.
struct Promise {
  std::optional<double> bound;  ///< in the check's unit; nothing: not promised
  std::string_view reason;      ///< why the bound is what it is, or why there is none
  bool in_table = false;        ///< a row of the table says so; without one, nothing is promised
};

/// Names that identify a row of results.
struct PromiseKey {
  std::string_view check, subject, evaluation, scalar, regime;
  int order;
};

/// The first row of the table that matches; a row with no bound for anything that none does.
Promise promise_for(const PromiseKey& key);

/// Every check needs a row, and so does every evaluation that people rely on (recommended, stated or batched): without
/// one a forgotten bound would look like a decision to promise nothing. \param role of the evaluation, where it has one
/// \throws std::logic_error that names the missing row
void require_row(const PromiseKey& key, std::optional<Role> role);

/// The checks of the table, in its order, each once: those of elements and those of whole cages.
std::vector<std::string_view> promised_checks();

/// Whether a list of names and globs names an evaluation, by its name or by the other one that its family has.
bool matches_evaluation(std::string_view pattern, const Evaluation& evaluation);

}  // namespace cageproof::validation
