// SPDX-License-Identifier: MIT
// The parts of the pages' data. Names of keys are those of the templates in page/.
#pragma once

#include "cageproof/reports/figure_sheet.h"
#include "digest.h"
#include "worst_places.h"

#include <kainjow/mustache.hpp>

namespace cageproof::reports {

using Data = kainjow::mustache::data;

/// A list as a template wants it, with a flag that tells whether it has items: {list: [...], has_list: bool}.
void set_list(Data& data, const std::string& name, const Data& list);

/// Data that all pages share (version, suite, seed, style, way to the report's folder). \param root "" or "../"
Data common_data(const RunResult& result, const std::string& root);

/// The page that has the row's cell, relative to the report's folder: "formulas/triangle.double_layer.html",
/// "cages/cube.html", "deformers/cube.html".
std::string page_of(const RowKey& row);

/// The cell's id within its page, which a link ends with: "truth.near-edge.closed_form.double.0".
std::string cell_id(const RowKey& row);

/// A cell's text: its largest error, or a dash where no sample had one.
std::string cell_text(const ResultRow& row);

/// A row's unit in words that need no manual; most units are such words as they are.
std::string unit_text(const std::string& unit);

/// How a cell looks: the colour of its error, grey where it is ill-posed or has none, hatched where nothing is
/// promised.
std::string cell_class(const ResultRow& row);

/// A table's cell: text, class, id, href. Empty where there is no row. \param page that the link is on, as page_of
Data error_cell(const ResultRow* row, const std::string& page);

/// An id for links within a page.
std::string anchor(std::string_view kind, std::string_view name);

/// "850 ns", "1.7 us", "23 ms".
std::string duration_text(double nanoseconds);

/// The verdict's line, class and figures of some rows.
void set_verdict(Data& page, const RunResult& result);
void set_tiles(Data& page, const Rows& rows);

/// Broken promises, and the worst input of each.
void set_broken(Data& page, const RunResult& result);

/// Figures of the proof that the truth rests on.
void set_proof(Data& page, const RunResult& result);

/// A run in one line: formulas and regimes, cages, deformers, suite, samples and seed.
std::string what_ran(const RunResult& result);

/// Digits that are right at the worst input, "14.9" or "all"; marked where the promise is broken.
std::string heat_text(const ResultRow& row);

/// How a cell of the heat map looks: coloured by its digits, otherwise as cell_class.
std::string heat_class(const ResultRow& row);

/// Formulas by regimes, of values in the recommended evaluation.
void set_heat_map(Data& page, const RunResult& result);

/// One line per formula and regime, with other evaluations' cells for the script.
void set_overview(Data& page, const RunResult& result);

/// The cages and deformers, a line each.
void set_cages(Data& page, const RunResult& result);

/// Errata of the papers, measured or not.
void set_errata(Data& page, const RunResult& result);

/// A run's processes and their machine, and advice which evaluations to take by their times.
void set_environment(Data& page, const RunResult& result);

/// Renders a template. \throws std::logic_error when it is malformed
std::string rendered(const char* text, const char* name, const Data& data);

}  // namespace cageproof::reports
