// SPDX-License-Identifier: MIT
// Panels of a figure, and what is measured of them, by name.
#pragma once

#include "cageproof/reports/figure_sheet.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace cageproof::validation {

/// \throws std::invalid_argument where there is none
inline const reports::FigurePanel& panel_of(const reports::FigureSheet& sheet, const std::string& file) {
  const auto at = std::ranges::find(sheet.panels, file, &reports::FigurePanel::file);
  if (at == sheet.panels.end()) throw std::invalid_argument("no panel " + file);
  return *at;
}

/// \throws std::invalid_argument where it was not measured
inline double measured(const reports::FigurePanel& panel, const std::string& name) {
  for (const auto& [known, value] : panel.measured)
    if (known == name) return value;
  throw std::invalid_argument("no figure " + name);
}

}  // namespace cageproof::validation
