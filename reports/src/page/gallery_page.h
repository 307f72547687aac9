// SPDX-License-Identifier: MIT
// pictures.html: error fields and the papers' figures, with the files that hold their data.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/figure_sheet.h"

#include <string>
#include <vector>

namespace cageproof::reports {

/// The page; empty for a run without pictures.
std::string gallery_page(const RunResult& result, const std::vector<FigureEntry>& figures);

}  // namespace cageproof::reports
