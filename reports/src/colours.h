// SPDX-License-Identifier: MIT
// A field's values as colours: the array that is drawn, its limits and its legend.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/report_writer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace cageproof::reports {

/// Colours of curves: Okabe and Ito's, told apart by people with any colour vision; yellow, too pale for a line, is
/// left out. Then four that are seen on white and on black.
inline constexpr std::array kCurveColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9",
                                          "#e69f00", "#808080", "#7f3fbf", "#8c564b", "#7a9a01"};

/// The colour of a sample that is not finite where one is expected (infinite), and of a masked one (NaN).
inline constexpr const char* kInfiniteColour = "#d62728";
inline constexpr const char* kMaskedColour = "#c8c8c8";

/// One value per sample, ready to be drawn on a linear colour axis.
struct Colours {
  std::vector<double> values;  ///< log10 of the magnitude on a logarithmic scale; NaN masked, +infinity infinite
  double low = 0, high = 1;    ///< limits of the colour axis, low < high
  double largest = 0;          ///< of the finite samples, before any logarithm; 0 when there is none
  std::string commands;        ///< gnuplot: palette, limits, ticks and label of the colour bar
};

/// The array of that name; \throws std::invalid_argument when there is none or a size does not fit the samples
const ImageField::Array& array_named(const std::vector<ImageField::Array>& arrays, const std::string& name,
                                     std::size_t samples);

/// Several components are shown by their magnitude; values beyond given limits take the colour at that end.
Colours colours_of(const ImageField::Array& array, ColourScale scale,
                   std::optional<ColourLimits> limits = std::nullopt);

}  // namespace cageproof::reports
