// SPDX-License-Identifier: MIT
// The parts of the page's data. Names of keys are those of page/page.mustache.
#pragma once

#include "cageproof/reports/figure_sheet.h"
#include "curve_picture.h"
#include "digest.h"

#include <kainjow/mustache.hpp>

#include <filesystem>

namespace cageproof::reports {

using Data = kainjow::mustache::data;

/// A list as the template wants it, with a flag that tells whether it has items: {list: [...], has_list: bool}.
void set_list(Data& data, const std::string& name, Data list);

/// A table's cell: text, class (colour), title (what it is, in words). Empty where there is no row.
Data error_cell(const ResultRow* row);

/// The file as a data URI.
std::string embedded_png(const std::filesystem::path& path);

/// An id for links within the page.
std::string anchor(std::string_view kind, std::string_view name);

/// What fell short, and the worst inputs of it.
void set_broken(Data& page, const RunResult& result);

/// The matrix formula x regime of the leading evaluation.
void set_overview(Data& page, const RunResult& result);

/// Formula by formula: definition, tables, pictures.
void set_formulas(Data& page, const RunResult& result, const std::vector<CurvePicture>& curves,
                  const std::filesystem::path& folder);

/// Cage by cage: properties of coordinates, and what deformers keep.
void set_cages(Data& page, const RunResult& result);

/// The papers' figures made again, with captions.
void set_figures(Data& page, const std::vector<FigureEntry>& figures, const std::filesystem::path& folder);

/// Errata of the papers, measured or not.
void set_errata(Data& page, const RunResult& result);

}  // namespace cageproof::reports
