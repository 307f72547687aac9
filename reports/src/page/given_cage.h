// SPDX-License-Identifier: MIT
// The head of the report on one cage that a user gave: which kind of coordinates to take there, and why.
#pragma once

#include "page_data.h"

namespace cageproof::reports {

/// Whether a run judged one given cage and no single elements.
bool is_of_given_cage(const RunResult& result);

/// "All 1,026 promises kept for my_cage.obj". \pre is_of_given_cage
std::string given_cage_verdict(const RunResult& result);

/// A kind of coordinates in the cage, by the evaluation that commands take there.
struct KindInCage {
  std::string kind, evaluation;
  std::optional<double> error_inside;     ///< largest relative error of values inside the cage, on it and near it
  std::uint64_t samples_inside = 0;       ///< that this is the largest of
  std::optional<double> error_elsewhere;  ///< and at all other places
  std::string worst_elsewhere;            ///< the place of that
  const ResultRow* unity = nullptr;       ///< the most telling row of partition of unity, null where none was measured
  const ResultRow* linear = nullptr;      ///< and of linear reproduction
  const ResultRow* signs = nullptr;       ///< and of non-negativity, at the points that were given where there are any
  const ResultRow* at_points = nullptr;   ///< linear reproduction at the points that were given
  std::optional<double> nanoseconds;      ///< of all coordinates of a point
  std::uint64_t kept = 0, broken = 0;     ///< promises, of this evaluation and others
  std::uint64_t undecided = 0;
  bool reproduces_linear = false;  ///< everywhere it was measured, as promised
};

/// The kinds that have rows, in their order there.
std::vector<KindInCage> kinds_in_cage(const RunResult& result);

/// The quickest of those that keep all promises, reproduce linear functions and were compared with their truth in,
/// on or next to the cage; of those whose times are alike, the most accurate. Null where none does or none was timed.
const KindInCage* kind_to_take(const std::vector<KindInCage>& kinds);

/// The section as the index shows it ("given_cage_section") and whether it does; nothing for other runs.
void set_given_cage(Data& page, const RunResult& result);

}  // namespace cageproof::reports
