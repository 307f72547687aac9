// SPDX-License-Identifier: MIT
#include "subject_page.h"

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/reports/packed_file.h"
#include "advice.h"
#include "base64.h"
#include "check_words.h"
#include "figure.h"
#include "page_template.h"
#include "run_names.h"
#include "rows_json.h"
#include "script_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace cageproof::reports {
namespace {

using Section = RowKey::Section;

// A table of cells: heads of columns, and lines.
struct Matrix {
  std::string caption;
  Data heads{Data::type::list}, lines{Data::type::list};
};

Data line(const std::string& name, const std::string& note, const Data& cells) {
  Data data;
  data.set("name", breakable(name));
  data.set("note", note);
  data.set("joined", false);
  data.set("cells", cells);
  return data;
}

// A check's words, where its name is shown.
void set_words(Data& data, const std::string& check) {
  const std::string words(words_of_check(check));
  data.set("words", words);
  data.set("has_words", !words.empty());
}

Data head(const std::string& name, int span, const std::string& unit = "") {
  Data data;
  data.set("name", breakable(name));
  set_words(data, name);
  data.set("unit", unit);
  data.set("has_unit", !unit.empty());
  data.set("span", fmt::format("{}", span));
  return data;
}

// Regimes by evaluations, three orders each.
Matrix truth_matrix(const ErrorTable& table, const std::string& page) {
  Matrix matrix{
      "Against the truth: how many digits of value, gradient and Hessian are right at the worst input, whatever the "
      "conditioning, and in brackets the largest conditioned error."};
  for (const Column& column : table.columns) matrix.heads << head(column.evaluation + ", " + column.scalar, 3);
  for (const std::string& regime : table.regimes) {
    Data cells{Data::type::list};
    for (const Column& column : table.columns)
      for (int order = 0; order < 3; ++order) {
        Data cell = error_cell(table.at(regime, column, order), page);
        cell.set("first", order == 0);
        cells << cell;
      }
    matrix.lines << line(regime, "", cells);
  }
  return matrix;
}

// Relations that hold without the truth: of all regimes the row nearest to its bound.
Matrix relations_matrix(const RunResult& result, const std::string& subject, const std::string& page) {
  Matrix matrix{
      "Relations that must hold without knowing the truth, and what stands for the truth: of all regimes the "
      "one nearest to its bound."};
  std::vector<std::pair<std::string, std::vector<const ResultRow*>>> lines;
  for (const ResultRow* row : tightest_properties(result, subject)) {
    const std::string name = fmt::format("{}: {}, {}", row->check, row->evaluation, row->scalar);
    if (lines.empty() || lines.back().first != name) lines.push_back({name, std::vector<const ResultRow*>(3)});
    lines.back().second[static_cast<std::size_t>(row->order)] = row;
  }
  matrix.heads << head("value", 1) << head("gradient", 1) << head("Hessian", 1);
  for (const auto& [name, rows] : lines) {
    Data cells{Data::type::list};
    std::string unit;
    for (const ResultRow* row : rows) {
      cells << error_cell(row, page);
      if (row) unit = unit_text(row->unit);
    }
    Data one = line(name, unit, cells);
    set_words(one, name.substr(0, name.find(':')));
    matrix.lines << one;
  }
  return matrix;
}

// "mean_value, batched, double" is a line of the name before the first comma and the note after it.
std::pair<std::string, std::string> name_and_note(const std::string& column) {
  const auto comma = column.find(", ");
  return comma == column.npos ? std::pair(column, std::string())
                              : std::pair(column.substr(0, comma), column.substr(comma + 2));
}

using CageLine = CageTable::Line;

std::vector<const CageLine*> lines_of(const CageTable& table, const std::string& cage) {
  std::vector<const CageLine*> lines;
  for (const CageLine& line : table.lines)
    if (line.cage == cage) lines.push_back(&line);
  return lines;
}

// Checks across, since there are four times as many coordinates as checks. Columns that have nothing of this cage are
// left out.
Matrix coordinates_matrix(const CageTable& table, const std::string& cage, const std::string& page) {
  Matrix matrix{
      "Each cell has the largest error of whole coordinates, of all places (inside, outside, on the cage) and orders, "
      "in the unit below the check's name. Point at a name to see what is compared."};
  const std::vector<const CageLine*> checks = lines_of(table, cage);
  for (const CageLine* check : checks) matrix.heads << head(check->name, 1, unit_text(check->unit));
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (std::ranges::none_of(checks, [&](const CageLine* check) { return check->cells[c] != nullptr; })) continue;
    Data cells{Data::type::list};
    for (const CageLine* check : checks) cells << error_cell(check->cells[c], page);
    const auto [name, note] = name_and_note(table.columns[c]);
    Data joined = line(name, note, cells);
    joined.set("joined", true);
    matrix.lines << joined;
  }
  return matrix;
}

Matrix deformers_matrix(const CageTable& table, const std::string& cage, const std::string& page) {
  Matrix matrix{
      "Each cell has the largest error of all poses and orders: of maps of space that a deformer keeps, of its "
      "derivatives, and against the truth. Where nothing is promised a deformer does not keep such maps, and the "
      "figure says by how much. "
      "Point at a check's name to see what is compared."};
  const std::vector<const CageLine*> deformers = lines_of(table, cage);
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (std::ranges::any_of(deformers, [&](const CageLine* l) { return l->cells[c] != nullptr; })) used.push_back(c);
  for (const std::size_t c : used) matrix.heads << head(table.columns[c], 1);
  for (const CageLine* l : deformers) {
    Data cells{Data::type::list};
    for (const std::size_t c : used) cells << error_cell(l->cells[c], page);
    matrix.lines << line(l->name, unit_text(l->unit), cells);
  }
  return matrix;
}

void add_matrix(Data& list, const Matrix& matrix, const std::string& name_head, const std::string& note_head,
                bool orders, bool narrow = false) {
  if (!matrix.lines.is_non_empty_list()) return;
  Data data;
  data.set("caption", matrix.caption);
  data.set("id", orders ? "truth-table" : "properties-table");
  data.set("narrow", narrow);
  data.set("heads", matrix.heads);
  data.set("lines", matrix.lines);
  data.set("name_head", name_head);
  data.set("note_head", note_head);
  data.set("joined", note_head.empty() && narrow);
  data.set("orders", orders);
  list << data;
}

Data pictures_of(const std::string& subject, const ErrorTable& table, const std::vector<CurvePicture>& curves) {
  // The regime that tells most is open when the page opens.
  const CurvePicture* open = nullptr;
  const ResultRow* telling = nullptr;
  const auto worst_of = [&](const std::string& regime) {
    const ResultRow* worst = nullptr;
    for (int order = 0; order < 3 && !table.columns.empty(); ++order)
      if (const ResultRow* row = table.at(regime, table.columns.front(), order))
        if (!worst || more_telling(*row, *worst)) worst = row;
    return worst;
  };
  for (const CurvePicture& curve : curves) {
    if (curve.subject != subject) continue;
    const ResultRow* row = worst_of(curve.regime);
    if (!open || (row && (!telling || more_telling(*row, *telling)))) open = &curve, telling = row;
  }
  Data list{Data::type::list};
  for (const CurvePicture& curve : curves) {
    if (curve.subject != subject) continue;
    Data data;
    data.set("regime", curve.regime);
    data.set("check", curve.check);
    data.set("is_truth", curve.check == "truth");
    data.set("axis", curve.parameter_name);
    data.set("open", &curve == open);
    data.set("picture", "../" + curve.picture.file);
    data.set("subject", subject);
    list << data;
  }
  return list;
}

// The relative error of a row in double.
double in_roundings(const ResultRow& row) { return std::ldexp(row.max_relative, 53); }

// Times with the errors drawn over them, the largest in `generic` and the largest of all regimes `near-*`.
Json times_json(const RunResult& result, const std::string& formula) {
  const SeriesStyles styles(result);
  Json list = Json::array();
  for (const EvaluationTime& time : times_of(result)) {
    if (time.formula != formula) continue;
    double generic = -1, near = -1;
    for (const ResultRow& row : result.rows) {
      if (row.section != Section::Element || row.subject != formula || row.evaluation != time.evaluation ||
          row.scalar != "double" || row.check != "truth" || row.order != time.order || row.samples == 0)
        continue;
      if (row.setting == "generic") generic = in_roundings(row);
      if (row.setting.starts_with("near-")) near = std::max(near, in_roundings(row));
    }
    list.push_back({{"evaluation", time.evaluation},
                    {"order", time.order},
                    {"nanoseconds", std::round(time.nanoseconds)},
                    {"style", generic < 0 ? Json() : style_json(styles.of(time.evaluation, "double"))},
                    {"generic", generic < 0 ? Json() : json_number(generic)},
                    {"near", near < 0 ? Json() : json_number(near)}});
  }
  return list;
}

Data times_table(const RunResult& result, const std::string& formula) {
  Data lines{Data::type::list};
  std::vector<std::string> names;
  for (const EvaluationTime& time : times_of(result))
    if (time.formula == formula && std::ranges::find(names, time.evaluation) == names.end())
      names.push_back(time.evaluation);
  for (const std::string& name : names) {
    Data data, orders{Data::type::list};
    data.set("evaluation", name);
    for (int order = 0; order < 3; ++order) {
      const auto time = time_of(result, formula, name, order);
      orders << Data(time ? duration_text(*time) : "");
    }
    data.set("orders", orders);
    lines << data;
  }
  return lines;
}

// Parts that the three kinds of pages have in common.
class SubjectPage {
 public:
  SubjectPage(const RunResult& result, Rows rows, std::string file, const std::string& name)
      : rows_(std::move(rows)), file_(std::move(file)), data_(common_data(result, "../")) {
    set_tiles(data_, rows_);
    data_.set("name", name);
  }
  Data& data() { return data_; }
  const std::string& file() const { return file_; }

  std::string text(Json page, const Data& matrices, const WorstPlaces& places) {
    set_list(data_, "matrices", matrices);
    page.update(rows_json(rows_, places));
    data_.set("cells", base64(packed(dump(page))));
    return rendered(kSubjectTemplate, "subject.mustache", data_);
  }

 private:
  Rows rows_;
  std::string file_;
  Data data_;
};

Rows rows_where(const RunResult& result, Section section, const auto& member, const std::string& value) {
  Rows rows;
  for (const ResultRow& row : result.rows)
    if (row.section == section && row.*member == value) rows.push_back(&row);
  return rows;
}

void add_formula(std::map<std::string, std::string>& pages, const RunResult& result, const WorstPlaces& places,
                 const std::string& subject, const std::vector<CurvePicture>& curves) {
  const ErrorTable table = truth_table(result, subject);
  SubjectPage page(result, rows_where(result, Section::Element, &ResultRow::subject, subject),
                   page_of({Section::Element, subject, "", "", "", "", "", 0}), subject);
  Data& data = page.data();
  if (const Formula* formula = find_formula(subject)) {
    data.set("known", true);
    data.set("symbol", std::string(formula->symbol));
    data.set("definition", std::string(formula->definition));
    data.set("source", std::string(formula->source));
    data.set("element", std::string(name_of(formula->element)));
  }
  data.set("what", "formula");
  data.set("of_formula", true);
  data.set("draws", true);
  pages["formulas/d3.min.js"] = kD3Script;
  Data matrices{Data::type::list};
  add_matrix(matrices, truth_matrix(table, page.file()), "Regime", "", true);
  add_matrix(matrices, relations_matrix(result, subject, page.file()), "Check", "Unit", false);
  set_list(data, "pictures", pictures_of(subject, table, curves));
  const Json times = times_json(result, subject);
  data.set("advice", advice(result, subject));
  set_list(data, "times", times_table(result, subject));
  data.set("times_json", script_json(times));
  pages[page.file()] = page.text({{"curves", curves_json(result, subject)}}, matrices, places);
}

void add_cage(std::map<std::string, std::string>& pages, const RunResult& result, const WorstPlaces& places,
              Section section, const CageTable& table, const std::string& cage, const ShownNames& names) {
  const bool deformers = section == Section::Deformer;
  const std::string shown = names.of(cage);
  SubjectPage page(result, rows_where(result, section, &ResultRow::setting, cage),
                   page_of({section, "", "", "", cage, "", "", 0}),
                   fmt::format("{} {}", deformers ? "Deformers of" : "Coordinates in", shown));
  page.data().set("has_path", shown != cage);
  page.data().set("path", cage);
  page.data().set("of_formula", false);
  page.data().set("what", deformers ? "deformers" : "cage");
  Data matrices{Data::type::list};
  if (deformers) add_matrix(matrices, deformers_matrix(table, cage, page.file()), "Deformer", "Unit", false, true);
  else add_matrix(matrices, coordinates_matrix(table, cage, page.file()), "Kind", "", false, true);
  pages[page.file()] = page.text({{"cage", shown}}, matrices, places);
}

// Files that all pages of a folder load are stored once: copies of them would be a tenth of the report.
void add_shared_files(std::map<std::string, std::string>& pages) {
  std::set<std::string> folders;
  for (const auto& [file, text] : pages) folders.insert(file.substr(0, file.find('/') + 1));
  for (const std::string& folder : folders) {
    pages[folder + "page.css"] = kPageStyle;
    pages[folder + "page.js"] = kPageScript;
    pages[folder + "cells.js"] = kCellScript;
  }
}

}  // namespace

std::map<std::string, std::string> subject_pages(const RunResult& result, const std::vector<CurvePicture>& curves) {
  std::map<std::string, std::string> pages;
  const WorstPlaces places(result);
  const ShownNames names = names_of_run(result);
  for (const std::string& subject : subjects(result, Section::Element))
    add_formula(pages, result, places, subject, curves);
  for (const Section section : {Section::Cage, Section::Deformer}) {
    const CageTable table = section == Section::Cage ? cage_table(result) : deformer_table(result);
    for (const std::string& cage : distinct(table.lines, [](const auto& l) -> const std::string& { return l.cage; }))
      add_cage(pages, result, places, section, table, cage, names);
  }
  add_shared_files(pages);
  return pages;
}

}  // namespace cageproof::reports
