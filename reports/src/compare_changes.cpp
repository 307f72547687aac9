// SPDX-License-Identifier: MIT
#include "cageproof/reports/compare_changes.h"

#include "compare_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::reports {
namespace {

// How bad a verdict is. "not promised" is worse than "undecided", which more samples can settle.
int badness(const std::string& verdict) {
  constexpr std::array<std::string_view, 4> worse_and_worse{"kept", "undecided", "not promised", "BROKEN"};
  return static_cast<int>(std::ranges::find(worse_and_worse, verdict) - worse_and_worse.begin());
}

double rounding_of(const Json& row) {
  const std::string scalar = row.value("scalar", "double");
  if (scalar == "float") return std::ldexp(1., -24);
  return scalar == "double" ? std::ldexp(1., -53) : 1e-30;
}

// Smaller errors are rounding: one that goes from a tenth of a unit to half of one is not five times worse.
double floor_of(const Json& row) {
  const std::string unit = row.value("unit", "");
  if (unit == "relative") return rounding_of(row);
  return unit == "of the radius" || unit == "of what is stated" ? 1. / 64 : 1;
}

std::string figure_text(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  return json.is_number_float() ? fmt::format("{:.4g}", json.get<double>()) : dump(json);
}

// A figure of a row; nothing where it is unknown.
std::optional<double> figure_in(const Json& row, const char* name) {
  const auto found = row.find(name);
  if (found == row.end()) return std::nullopt;
  return number_of(*found);
}

void add_change(Changes& result, Change change) {
  const bool worse = std::isnan(change.ratio) || change.ratio > 1;
  if (change.ratio == 1) return;
  if (!worse) change.kind = Change::Kind::Better;
  else change.kind = change.ratio <= result.tolerance ? Change::Kind::Slight : Change::Kind::Worse;
  result.changes.push_back(std::move(change));
}

// The new by the old one, NaN when it cannot be told: an error that became NaN is worse than any.
double ratio_of(double before, double after, double floor) {
  if (std::isnan(before) && std::isnan(after)) return 1;
  if (std::isnan(before)) return 0;
  before = std::max(before, floor);
  after = std::max(after, floor);
  return before == after ? 1 : after / before;
}

void compare_row(Changes& result, const std::string& name, const Json& before, const Json& after) {
  const auto change = [&](const char* figure, double ratio) {
    const auto text = [&](const Json& row) { return row.contains(figure) ? figure_text(row[figure]) : "unknown"; };
    add_change(result, {Change::Kind::Worse, name, figure, text(before), text(after), ratio});
  };
  const std::string old_verdict = before.value("verdict", "not promised"),
                    new_verdict = after.value("verdict", "not promised");
  if (const int step = badness(new_verdict) - badness(old_verdict); step != 0)
    change("verdict", step > 0 ? HUGE_VAL : 0);
  const bool same_unit = before.value("unit", "") == after.value("unit", "");
  if (!same_unit) change("unit", HUGE_VAL);
  for (const char* figure : {"max", "p999", "median", "max_relative", "bound"}) {
    const bool relative = std::string_view(figure) == "max_relative";
    const auto a = figure_in(before, figure), b = figure_in(after, figure);
    // Without a bound nothing is promised, which the verdict says.
    if (!a || !b || (!same_unit && !relative)) continue;
    if (const double ratio = ratio_of(*a, *b, relative ? rounding_of(before) : floor_of(before)); ratio != 1)
      change(figure, ratio);
  }
  const double old_samples = figure_in(before, "samples").value_or(0),
               new_samples = figure_in(after, "samples").value_or(0);
  if (old_samples > 0 && new_samples <= 0) change("samples", HUGE_VAL);
  for (const char* count : {"nonfinite", "without_truth", "unreached", "declined"}) {
    const double a = figure_in(before, count).value_or(0) / std::max(1., old_samples),
                 b = figure_in(after, count).value_or(0) / std::max(1., new_samples);
    if (a != b) change(count, a > 0 ? b / a : HUGE_VAL);
  }
}

// Largest errors against the truth of rows that are promised: the figures worth a curve over time.
void track(Changes& result, const Json& summary) {
  std::map<std::string, double> largest;
  for (const Json& row : summary["rows"]) {
    const auto max = figure_in(row, "max");
    const std::string verdict = row.value("verdict", "");
    if (verdict == "kept" || verdict == "BROKEN") ++result.promises;
    if (verdict == "BROKEN") ++result.broken;
    if (!max || !figure_in(row, "bound") || row.value("check", "") != "truth" || row.value("unit", "") != "conditioned")
      continue;
    const int order = std::clamp(row.value("order", 0), 0, 2);
    constexpr std::array orders{"value", "gradient", "Hessian"};
    double& known = largest[fmt::format("{} {} {} {}", row.value("subject", ""), row.value("evaluation", ""),
                                        row.value("scalar", ""), orders.at(order))];
    known = std::isnan(*max) ? HUGE_VAL : std::max(known, *max);
  }
  result.figures.push_back({"promises broken", "promises", static_cast<double>(result.broken)});
  for (const auto& [name, value] : largest) result.figures.push_back({name, "conditioned units", value});
}

}  // namespace

std::string_view name_of(Change::Kind kind) {
  switch (kind) {
    case Change::Kind::Worse: return "worse";
    case Change::Kind::Gone: return "gone";
    case Change::Kind::Slight: return "within the tolerance";
    case Change::Kind::Better: return "better";
    case Change::Kind::Added: return "new";
    case Change::Kind::Undecided: break;
  }
  return "undecided";
}

std::size_t Changes::count(Change::Kind kind) const {
  return std::ranges::count_if(changes, [&](const Change& change) { return change.kind == kind; });
}

Changes changes_of_summaries(std::string_view old_text, std::string_view new_text, const Renamed& renamed,
                             double tolerance, std::string_view old_name, std::string_view new_name) {
  const MatchedRows rows(old_text, new_text, renamed, old_name, new_name);
  Changes result{.old_name = std::string(old_name), .new_name = std::string(new_name), .tolerance = tolerance};
  result.settings = differing_settings(rows.before, rows.after);
  for (const auto& [name, row] : rows.old_rows) {
    const std::string verdict = row->value("verdict", "not promised");
    if (const auto other = rows.new_rows.find(name); other != rows.new_rows.end()) {
      ++result.compared;
      compare_row(result, name, *row, *other->second);
    } else {
      result.changes.push_back(
          {verdict == "not promised" ? Change::Kind::Slight : Change::Kind::Gone, name, "", verdict, ""});
    }
  }
  for (const auto& [name, row] : rows.new_rows) {
    if (rows.old_rows.contains(name)) continue;
    const std::string verdict = row->value("verdict", "not promised");
    result.changes.push_back({verdict == "BROKEN" ? Change::Kind::Worse : Change::Kind::Added, name, "", "", verdict});
  }
  track(result, rows.after);
  if (const auto sessions = rows.after.find("environment");
      sessions != rows.after.end() && sessions->contains("sessions") && !(*sessions)["sessions"].empty()) {
    const Json& last = (*sessions)["sessions"].back();
    result.date = last.value("started", "");
    if (last.contains("machine")) result.commit = last["machine"].value("commit", "");
  }
  return result;
}

}  // namespace cageproof::reports
