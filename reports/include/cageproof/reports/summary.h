// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/run_result.h"

#include <string>
#include <string_view>

namespace cageproof::reports {

/// summary.json: every figure, "schema_version" 2. \param schema what the file is: "cageproof-summary" of a
/// verification, "cageproof-field" of a field
std::string summary_json(const RunResult& result, std::string_view schema = "cageproof-summary");

}  // namespace cageproof::reports
