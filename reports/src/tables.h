// SPDX-License-Identifier: MIT
// Files of a report, as text; summary.json is in cageproof/reports/summary.h.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/figure_sheet.h"

#include <string>

namespace cageproof::reports {

/// results.csv: a header, then one line per row, in the rows' order; RFC 4180 quoting, lines end in a line feed.
std::string results_csv(const RunResult& result);

/// summary.md: the verdict, what is broken, then tables, of figures their captions.
std::string summary_markdown(const RunResult& result, const std::vector<FigureEntry>& figures = {});

}  // namespace cageproof::reports
