// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/reports/field_scene.h"

namespace cageproof::reports {

/// A page that shows a scene in three dimensions in a browser, to be turned with the mouse, and reads nothing but
/// itself. \param picture, files named on the page, relative to it
std::string field_page(const FieldScene& scene, const std::string& picture, const std::vector<std::string>& files);

}  // namespace cageproof::reports
