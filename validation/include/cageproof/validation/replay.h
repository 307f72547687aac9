// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/results/tally.h"
#include "cageproof/validation/check.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cageproof::validation {

/// Facts that a file states of a case, in addition to its row and its input; nothing where one is not known.
struct StoredFacts {
  std::string unit;          ///< of the stored error
  std::string cage_content;  ///< the fingerprint of the cage (JournalHeader::options) when the case was measured
  std::vector<std::filesystem::path> folders =
      {};  ///< where a cage's relative path is looked for, after the current one
};

/// Re-runs worst cases of rows from the rows' names. What a case needs (a cage with its coordinates or deformer) is
/// kept until a case needs another, so that cases in the order of a file prepare each once. For one thread.
class Replayer {
 public:
  Replayer();
  ~Replayer();
  Replayer(const Replayer&) = delete;
  Replayer& operator=(const Replayer&) = delete;

  /// Returns what the row's check finds at the case now, at the row's order: an error in the row's unit, or why it has
  /// none. \throws InputError when a name is unknown (formula, evaluation, scalar, check, kind), the input does not fit
  /// the formula, a cage cannot be read (all places tried are named) or is not the stored one, the unit is another, or
  /// the check is not asked of the evaluation
  Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored = {});

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

/// As Replayer::replay, for one case.
Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored = {});

/// Throws what replay would throw for a case of a single element, and measures nothing.
void require_replayable(const RowKey& row, const WorstCase& worst);

}  // namespace cageproof::validation
