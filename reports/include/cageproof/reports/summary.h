// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/run_result.h"

#include <string>
#include <string_view>

namespace cageproof::reports {

/// "schema_version" of summary.json. Since 3 rows have the role of their evaluation.
inline constexpr int summary_schema_version = 3;

/// summary.json: every figure. \param schema what the file is: "cageproof-summary" of a
/// verification, "cageproof-field" of a field
std::string summary_json(const RunResult& result, std::string_view schema = "cageproof-summary");

}  // namespace cageproof::reports
