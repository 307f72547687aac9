// SPDX-License-Identifier: MIT
// page/field.* and vtk.js with its licence, embedded when the program is built.
#pragma once

#include <string_view>

namespace cageproof::reports {

extern const char* const kFieldTemplate;
extern const char* const kFieldStyle;
extern const char* const kFieldScript;
extern const std::string_view kVtkJs;
extern const char* const kVtkJsLicence;
extern const char* const kVtkJsVersion;

}  // namespace cageproof::reports
