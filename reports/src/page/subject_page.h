// SPDX-License-Identifier: MIT
// One page of cells: a formula's, a cage's, or that of the deformers of a cage.
#pragma once

#include "curve_picture.h"
#include "page_data.h"

namespace cageproof::reports {

/// Pages of all formulas, cages and deformed cages that have rows, by file name.
std::map<std::string, std::string> subject_pages(const RunResult& result, const std::vector<CurvePicture>& curves);

}  // namespace cageproof::reports
