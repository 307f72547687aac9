// SPDX-License-Identifier: MIT
// How curves look: the same in pictures for print and on pages.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::reports {

/// The looks of an evaluation in a scalar.
struct SeriesStyle {
  const char* colour = "";
  std::vector<int> dash;  ///< lengths of line and gap in turn, in pixels; empty for a whole line
  int shape = 0;          ///< of marks: circle, square, triangle, triangle upside down, diamond
  bool filled = true;     ///< marks; open ones are of other scalars than double
};

/// The looks of all curves of a run, and of what it compared with the truth. An evaluation keeps its colour on all
/// pages and pictures of the run, and no two series of one formula look alike, as long as it has at most two
/// evaluations for each colour, in three scalars.
class SeriesStyles {
 public:
  explicit SeriesStyles(const RunResult& result);
  /// \pre the run has a curve or a row against the truth of that evaluation
  SeriesStyle of(const std::string& evaluation, const std::string& scalar) const;

 private:
  std::map<std::string, std::size_t> number_;  ///< by evaluation
  std::vector<std::string> scalars_;
};

}  // namespace cageproof::reports
