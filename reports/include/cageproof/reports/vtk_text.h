// SPDX-License-Identifier: MIT
// Fields as VTK XML, compressed; array names carry units: "relative error [1]".
#pragma once

#include "cageproof/core/run_result.h"

#include <string>

namespace cageproof::reports {

/// The text of a .vti file. \pre every array has points x components values
std::string vti_text(const ImageField& field);

/// The text of a .vtp file: polygons and polylines, or vertex cells when there are neither. \pre as vti_text; indices
/// in range
std::string vtp_text(const MeshField& field);

}  // namespace cageproof::reports
