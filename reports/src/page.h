// SPDX-License-Identifier: MIT
// index.html: one self-contained page, without scripts or network.
#pragma once

#include "cageproof/core/run_result.h"
#include "cageproof/reports/figure_sheet.h"
#include "curve_picture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cageproof::reports {

/// The page; pictures are read from the report's folder and embedded.
/// \throws InputError when a picture cannot be read
std::string page(const RunResult& result, const std::vector<CurvePicture>& curves,
                 const std::vector<FigureEntry>& figures, const std::filesystem::path& folder);

}  // namespace cageproof::reports
