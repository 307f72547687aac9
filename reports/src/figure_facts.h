// SPDX-License-Identifier: MIT
// A panel's facts and figures as text.
#pragma once

#include "cageproof/reports/figure_sheet.h"

#include <string>

namespace cageproof::reports {

/// "method somigliana, parameters nu=0.3, cage cube"; those without a value are left out.
std::string facts_text(const FigurePanel& panel);

/// "volume ratio 0.951, largest displacement over cage size 0.183".
std::string measured_text(const FigurePanel& panel);

}  // namespace cageproof::reports
