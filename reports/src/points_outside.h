// SPDX-License-Identifier: MIT
// Points that a user gave and that lie outside the cage: said before anything else.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>

namespace cageproof::reports {

/// "330 of 434 points of mesh.obj are outside cage.obj."; empty where none is.
std::string points_outside_line(const RunResult& result);

}  // namespace cageproof::reports
