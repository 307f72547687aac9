// SPDX-License-Identifier: MIT
// JSON that a page's script reads: cells, curves and times.
#pragma once

#include "digest.h"
#include "json_value.h"
#include "series_styles.h"
#include "worst_places.h"

namespace cageproof::reports {

/// {"reasons": [...], "checks": {name: words}, "rows": [...]}: one row per cell, with all that the cell answers.
/// Quantiles are there from 1000 samples on: below, they would only repeat the largest.
Json rows_json(const Rows& rows, const WorstPlaces& places);

/// A formula's curves, each with its cell's id, regime, check, evaluation, scalar, order, parameters, errors and bound.
Json curves_json(const RunResult& result, const std::string& subject);

/// The looks of a series, as scripts draw it: {"colour": "#0072b2", "dash": "8 4", "shape": 0, "filled": true}.
Json style_json(const SeriesStyle& style);

/// Which entry of a formula's tensor an index is: "corner 1, row y, column x, d/dx d/dz".
std::string entry_name(const RowKey& row, int index);

}  // namespace cageproof::reports
