// SPDX-License-Identifier: MIT
// page/page.mustache and page/page.css, embedded when the program is built.
#pragma once

namespace cageproof::reports {

extern const char* const kPageTemplate;
extern const char* const kPageStyle;

}  // namespace cageproof::reports
