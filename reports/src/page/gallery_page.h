// SPDX-License-Identifier: MIT
// pictures.html: error fields and the papers' figures, with the files that hold their data.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/figure_sheet.h"

#include <string>
#include <vector>

namespace cageproof::reports {

/// Whether no finite error of a field reaches 1e-13: its picture shows rounding, and nothing else.
bool is_rounding_noise(const FieldEntry& field);

/// The page; empty for a run without pictures.
std::string gallery_page(const RunResult& result, const std::vector<FigureEntry>& figures);

}  // namespace cageproof::reports
