// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/formula.h"
#include "cageproof/reports/broken_groups.h"
#include "digest.h"
#include "errata_text.h"
#include "figure_facts.h"
#include "figure.h"
#include "points_outside.h"
#include "tables.h"

#include <fmt/format.h>

namespace cageproof::reports {
namespace {

constexpr std::size_t kMostBroken = 100;

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_' || c == '`' || c == '\\') result += '\\';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result;
}

std::string line(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

std::string head(const std::vector<std::string>& cells) {
  std::string text = line(cells) + "|";
  for (std::size_t i = 0; i < cells.size(); ++i) text += "---|";
  return text + "\n";
}

std::string figure(const ResultRow* row) {
  if (!row) return "";
  return row->verdict == Verdict::Broken ? "**" + figure_text(*row) + "**" : figure_text(*row);
}

std::string broken(const RunResult& result) {
  const Rows rows = broken_rows(result);
  if (rows.empty()) return "";
  std::string text =
      "\n## What fell short\n\nWhat others rest on first; together what one fault may break, with the input that is "
      "shortest to write down.\n\n";
  for (const BrokenGroup& group : broken_groups(result)) {
    text += fmt::format("* {}; {}\n", escaped(title_of(group)), escaped(breach(*group.rows.front())));
    if (group.simplest)
      text += fmt::format("  {}: {}\n", escaped(group.simplest_row->subject),
                          error_line(*group.simplest_row, *group.simplest));
  }
  text += "\nThe furthest beyond its bound first:\n\n" +
          head({"subject", "evaluation", "scalar", "regime or cage", "check", "place", "order", "largest found",
                "bound", "unit", "not finite", "lost"});
  for (std::size_t i = 0; i < std::min(rows.size(), kMostBroken); ++i) {
    const ResultRow& row = *rows[i];
    text += line({escaped(row.subject), escaped(row.evaluation), escaped(row.scalar), escaped(row.setting),
                  escaped(row.check), escaped(row.place), std::string(order_name(row.order)), figure(&row),
                  row.bound ? short_number(*row.bound) : "", escaped(row.unit), grouped(row.nonfinite),
                  grouped(row.asked - std::min(row.asked, row.samples + row.without_truth))});
  }
  if (rows.size() > kMostBroken)
    text += fmt::format("\n... and {} more: results.csv.gz has them all.\n", grouped(rows.size() - kMostBroken));
  return text + "\nTheir worst inputs: worst.jsonl; `cageproof replay worst.jsonl` runs them again.\n";
}

std::string formulas(const RunResult& result) {
  std::string text;
  for (const std::string& subject : subjects(result, ResultRow::Section::Element)) {
    const ErrorTable table = truth_table(result, subject);
    if (table.rows.empty()) continue;
    const Formula* formula = find_formula(subject);
    text += fmt::format("\n### {}\n\n", escaped(subject));
    if (formula)
      text += fmt::format("{} = {} ({})\n\n", escaped(formula->symbol), escaped(formula->definition),
                          escaped(formula->source));
    std::vector<std::string> cells{"regime"};
    for (const Column& column : table.columns) cells.push_back(escaped(column.evaluation + ", " + column.scalar));
    text += head(cells);
    for (const std::string& regime : table.regimes) {
      cells = {escaped(regime)};
      for (const Column& column : table.columns) {
        std::string cell;
        for (int order = 0; order < 3; ++order)
          if (const ResultRow* row = table.at(regime, column, order)) cell += (cell.empty() ? "" : " · ") + figure(row);
        cells.push_back(cell);
      }
      text += line(cells);
    }
  }
  if (text.empty()) return text;
  return "\n## Formulas against the truth\n\nValue · gradient · Hessian: how many digits are right at the worst input "
         "found, whatever the conditioning, and in brackets the largest conditioned error; bold where a promise is "
         "broken.\n" +
         text;
}

std::string properties(const RunResult& result) {
  std::string text;
  for (const std::string& subject : subjects(result, ResultRow::Section::Element))
    for (const ResultRow* row : tightest_properties(result, subject))
      text += line({escaped(subject), escaped(row->check), escaped(row->evaluation + ", " + row->scalar),
                    std::string(order_name(row->order)), figure(row), row->bound ? short_number(*row->bound) : "",
                    escaped(row->unit), escaped(row->setting)});
  if (text.empty()) return text;
  return "\n## Properties of formulas\n\nOf all regimes the one nearest to its bound.\n\n" +
         head({"formula", "check", "evaluation", "order", "largest found", "bound", "unit", "regime"}) + text;
}

std::string table_text(const CageTable& table, const std::string& title, const std::string& lines) {
  if (table.lines.empty()) return "";
  std::vector<std::string> cells{"cage", lines, "unit"};
  for (const std::string& column : table.columns) cells.push_back(escaped(column));
  std::string text = title + head(cells);
  for (const CageTable::Line& l : table.lines) {
    cells = {escaped(l.cage), escaped(l.name), escaped(l.unit)};
    for (const ResultRow* row : l.cells) cells.push_back(figure(row));
    text += line(cells);
  }
  return text;
}

std::string cages(const RunResult& result) {
  return table_text(cage_table(result), "\n## Cages\n\nLargest error found of all places.\n\n", "check") +
         table_text(deformer_table(result),
                    "\n## Deformers\n\nLargest error found of all poses; no promise where a deformer does not keep "
                    "such maps.\n\n",
                    "deformer");
}

std::string figures_section(const std::vector<FigureEntry>& figures) {
  if (figures.empty()) return "";
  std::string text = "\n## Figures of the papers\n\nMade again; for reading, and no part of the verdict.\n";
  for (const FigureEntry& entry : figures) {
    text += fmt::format("\n### {}\n\n{} ({}): {}\n\n", escaped(entry.sheet.heading), escaped(entry.picture),
                        escaped(entry.sheet.source), escaped(entry.sheet.text));
    text += head({"panel", "what it is", "measured", "data"});
    for (std::size_t i = 0; i < entry.data.size(); ++i) {
      const FigurePanel& panel = entry.sheet.panels[i];
      text += line(
          {escaped(panel.title), escaped(facts_text(panel)), escaped(measured_text(panel)), escaped(entry.data[i])});
    }
  }
  return text;
}

std::string errata(const RunResult& result) {
  if (result.errata.empty()) return "";
  std::string measured, texts;
  for (const ErratumRow& row : result.errata) {
    std::vector<std::string> cells{escaped(row.source), escaped(row.printed), escaped(row.correct)};
    if (row.formula.empty()) {
      texts += line(cells);
      continue;
    }
    for (const std::string& cell : {escaped(row.formula), std::string(order_name(row.order)), escaped(row.evaluation),
                                    escaped(row.regime), printed_error_text(row), short_error(row.corrected_error)})
      cells.push_back(cell);
    measured += line(cells);
  }
  std::string text = "\n## Errata of the papers\n";
  if (!measured.empty())
    text +=
        "\nLargest relative error found, in 50 digits, [T18]'s in double; of images in whole cages, in double, the "
        "largest "
        "distance over "
        "their "
        "size.\n\n" +
        head({"where", "printed", "right", "formula", "order", "evaluation", "regime", "as printed", "corrected"}) +
        measured;
  if (!texts.empty()) text += "\nNot measured here.\n\n" + head({"where", "printed", "right"}) + texts;
  return text;
}

std::string pairs(const std::string& title, const std::map<std::string, std::string>& map) {
  if (map.empty()) return "";
  std::string text = fmt::format("\n## {}\n\n", title);
  for (const auto& [key, value] : map) text += fmt::format("* {}: {}\n", escaped(key), escaped(value));
  return text;
}

// The environment comes last, because it may differ between runs with the same findings.
std::string environment_section(const RunResult& result) {
  std::string text = "\n## Environment\n";
  for (const Session& session : result.sessions) {
    text += fmt::format("\n* started: {}, took {:.1f} s\n* command line: {}\n", escaped(session.started),
                        session.seconds, escaped(session.command_line));
    for (const auto& [key, value] : session.machine) text += fmt::format("* {}: {}\n", escaped(key), escaped(value));
  }
  if (!result.session_notes.empty()) text += "\n";
  for (const std::string& note : result.session_notes) text += fmt::format("* {}\n", escaped(note));
  return text;
}

}  // namespace

std::string summary_markdown(const RunResult& result, const std::vector<FigureEntry>& figures) {
  std::string text = fmt::format("# Cageproof: {}\n\n", verdict_line(result));
  text += fmt::format("Suite {}, seed {}, version {}.\n", escaped(result.suite), result.seed, escaped(result.version));
  if (const std::string outside = points_outside_line(result); !outside.empty())
    text += fmt::format("\n**{}** The notes say what that means.\n", escaped(outside));
  text += broken(result) + formulas(result) + properties(result) + cages(result);
  if (!result.fields.empty()) {
    text += "\n## Fields\n\n" + head({"field", "largest", "unit", "data", "picture"});
    for (const FieldEntry& field : result.fields)
      text += line({escaped(field.title), short_number(field.largest), escaped(field.unit), escaped(field.data),
                    escaped(field.picture)});
  }
  text += figures_section(figures) + errata(result);
  if (!result.notes.empty()) text += "\n## Notes\n\n";
  for (const std::string& note : result.notes) text += fmt::format("* {}\n", escaped(note));
  return text + pairs("Settings", result.settings) + environment_section(result);
}

}  // namespace cageproof::reports
