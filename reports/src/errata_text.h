// SPDX-License-Identifier: MIT
// How an erratum's figures read.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>

namespace cageproof::reports {

/// "1.6", "1.6, not finite on 3 of 24", "not finite".
std::string printed_error_text(const ErratumRow& row);

}  // namespace cageproof::reports
