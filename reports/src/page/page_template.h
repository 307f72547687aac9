// SPDX-License-Identifier: MIT
// The files of reports/page/, embedded when the program is built.
#pragma once

namespace cageproof::reports {

extern const char* const kIndexTemplate;
extern const char* const kGivenCageTemplate;
extern const char* const kSubjectTemplate;
extern const char* const kGalleryTemplate;
extern const char* const kPageStyle;
extern const char* const kPageScript;   ///< run by every page with a script
extern const char* const kFrontStyle;   ///< of the first page only, behind kPageStyle
extern const char* const kFrontScript;  ///< of the first page only, behind kPageScript
extern const char* const kCellScript;   ///< run by pages of cells, after kPageScript
extern const char* const kD3Script;     ///< third_party/d3.min.js

}  // namespace cageproof::reports
