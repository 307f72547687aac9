// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/results/run_result.h"

#include <functional>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// The summary's name within a report's folder. It is packed (packed_file.h); up to schema 2 it was "summary.json",
/// plain.
inline constexpr const char* summary_file = "summary.json.gz";

/// "schema_version" of the summary. Since 3 rows have the role of their evaluation; since 4 the recommended
/// evaluations of triangles and segments are called hybrid, and closed_form is another; since 5 curves are of relative
/// errors.
inline constexpr int summary_schema_version = 5;

/// summary.json: every figure. \param schema what the file is: "cageproof-summary" of a
/// verification, "cageproof-field" of a field
std::string summary_json(const RunResult& result, std::string_view schema = "cageproof-summary");
/// Hands out the same text in parts.
void put_summary(const RunResult& result, std::string_view schema, const std::function<void(std::string_view)>& put);

}  // namespace cageproof::reports
