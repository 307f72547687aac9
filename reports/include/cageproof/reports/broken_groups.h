// SPDX-License-Identifier: MIT
// Broken rows in the order in which to look at them: foundations of others first, rows with one likely cause together.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>
#include <vector>

namespace cageproof::reports {

/// Broken rows that share check, evaluation and scalar, and the element or the cage that they are about: one fault in
/// what formulas have in common breaks them together.
struct BrokenGroup {
  std::vector<const ResultRow*> rows;       ///< the one furthest beyond its bound first
  const ResultRow* simplest_row = nullptr;  ///< whose input is the simplest of the group's worst ones; null without any
  const WorstCase* simplest = nullptr;      ///< that input: the fewest characters to write down
};

/// Groups of rows that others rest on (ResultRow::is_foundation) first, then larger groups before smaller ones.
std::vector<BrokenGroup> broken_groups(const RunResult& result);

/// The group's title says what its rows have in common and what they are about, as in "truth of closed_form in double:
/// 25 rows of triangle.double_layer, triangle.solid_angle; near-edge, near-line; orders 0, 1".
std::string title_of(const BrokenGroup& group);

/// Why a row is broken: how far its error is above the bound, and which samples are lost; never a figure within bounds.
std::string breach(const ResultRow& row);

/// The error of one of a row's inputs, and the input: "96 conditioned at (0, 0, 1) (2, 0, 0) seen from (0.25, -1, 0)".
std::string error_line(const ResultRow& row, const WorstCase& input);

/// An input as a line of text, in the shortest decimals that give it back.
std::string input_line(const WorstCase& input);

}  // namespace cageproof::reports
