// SPDX-License-Identifier: MIT
// The pages of a report: index.html with the verdict and one line per formula and regime, one page with every cell for
// each formula, cage and deformed cage, and a page of pictures. They need no network; index.html and pictures.html need
// no script.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/figure_sheet.h"
#include "curve_picture.h"

#include <map>
#include <string>
#include <vector>

namespace cageproof::reports {

/// Text by file name, relative to the report's folder. Pictures are linked, not held.
std::map<std::string, std::string> pages(const RunResult& result, const std::vector<CurvePicture>& curves,
                                         const std::vector<FigureEntry>& figures);

}  // namespace cageproof::reports
