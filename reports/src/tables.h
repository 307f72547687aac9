// SPDX-License-Identifier: MIT
// The machine-readable files of a report, as text.
#pragma once

#include "cageproof/core/run_result.h"

#include <string>

namespace cageproof::reports {

/// summary.json: every figure, "schema_version" 1.
std::string summary_json(const RunResult& result);

/// results.csv: a header, then one line a row in the order of the rows; RFC 4180 quoting, line feeds alone.
std::string results_csv(const RunResult& result);

/// summary.md: the verdict, what is broken, then tables.
std::string summary_markdown(const RunResult& result);

/// "element", "cage".
std::string_view name_of(ResultRow::Section section);

}  // namespace cageproof::reports
