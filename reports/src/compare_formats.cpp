// SPDX-License-Identifier: MIT
#include "cageproof/reports/compare_formats.h"

#include "json_value.h"
#include "compare_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::reports {
namespace {

constexpr std::array change_kinds{Change::Kind::Worse,  Change::Kind::Gone,   Change::Kind::Undecided,
                                  Change::Kind::Slight, Change::Kind::Better, Change::Kind::Added};

// Within one kind, the largest changes come first.
std::vector<const Change*> changes_of(const Changes& all, Change::Kind kind) {
  std::vector<const Change*> found;
  for (const Change& change : all.changes)
    if (change.kind == kind) found.push_back(&change);
  const auto size = [](const Change* c) { return std::isnan(c->ratio) ? HUGE_VAL : c->ratio; };
  std::ranges::stable_sort(found, [&](const Change* a, const Change* b) {
    return a->kind == Change::Kind::Better ? size(a) < size(b) : size(a) > size(b);
  });
  return found;
}

std::string times_text(const Change& change) {
  std::string text = change.ratio > 0 && std::isfinite(change.ratio) ? fmt::format("{:.3g}x", change.ratio) : "";
  if (change.p >= 0) text += fmt::format("{}p = {:.2g}", text.empty() ? "" : ", ", change.p);
  return text;
}

std::string change_line(const Change& change) {
  if (change.figure.empty())
    return fmt::format("{}: {}: {}", name_of(change.kind), change.what,
                       change.before.empty() ? change.after : change.before);
  const std::string times = times_text(change);
  return fmt::format("{}: {}: {} {} -> {}{}", name_of(change.kind), change.what, change.figure, change.before,
                     change.after, times.empty() ? "" : " (" + times + ")");
}

std::string verdict_line(const Changes& changes) {
  const auto count = [&](Change::Kind kind) { return changes.count(kind); };
  std::string text = fmt::format(
      "{} compared with tolerance {:g}x: {} worse, {} gone, {} worse within the tolerance, {} better, {} new",
      changes.compared, changes.tolerance, count(Change::Kind::Worse), count(Change::Kind::Gone),
      count(Change::Kind::Slight), count(Change::Kind::Better), count(Change::Kind::Added));
  if (const auto undecided = count(Change::Kind::Undecided))
    text += fmt::format(", {} undecided: at least 5 repetitions of each are needed (--benchmark_repetitions=10)",
                        undecided);
  return text;
}

// A cell of a table: bars would end it.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

}  // namespace

std::string changes_text(const Changes& changes) {
  std::string text;
  for (const Change::Kind kind : change_kinds)
    for (const Change* change : changes_of(changes, kind)) text += change_line(*change) + "\n";
  return text + verdict_line(changes) + "\n";
}

std::string changes_markdown(const Changes& changes) {
  constexpr std::size_t most = 50;
  std::string text = fmt::format("### {}: {} -> {}\n\n{}\n", changes.fails() ? "Got worse" : "Nothing got worse",
                                 changes.old_name, changes.new_name, verdict_line(changes));
  for (const Change::Kind kind : change_kinds) {
    const auto found = changes_of(changes, kind);
    if (found.empty()) continue;
    const bool open = kind == Change::Kind::Worse || kind == Change::Kind::Gone;
    text += open ? fmt::format("\n**{}**\n", name_of(kind))
                 : fmt::format("\n<details><summary>{}: {}</summary>\n", name_of(kind), found.size());
    text += "\n| what | figure | old | new | |\n|---|---|---:|---:|---|\n";
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
      text += fmt::format("| {} | {} | {} | {} | {} |\n", cell(found[i]->what), cell(found[i]->figure),
                          cell(found[i]->before), cell(found[i]->after), times_text(*found[i]));
    if (found.size() > most) text += fmt::format("\n{} more are not shown.\n", found.size() - most);
    if (!open) text += "\n</details>\n";
  }
  return text;
}

std::string changes_json(const Changes& changes) {
  Json json{{"schema", "cageproof-comparison"}, {"schema_version", 1},
            {"old", changes.old_name},          {"new", changes.new_name},
            {"tolerance", changes.tolerance},   {"fails", changes.fails()},
            {"compared", changes.compared},     {"changes", Json::array()}};
  for (const Change::Kind kind : change_kinds)
    for (const Change* change : changes_of(changes, kind))
      json["changes"].push_back({{"kind", name_of(kind)},
                                 {"what", change->what},
                                 {"figure", change->figure},
                                 {"old", change->before},
                                 {"new", change->after},
                                 {"ratio", change->ratio > 0 ? json_number(change->ratio) : Json()},
                                 {"p", change->p >= 0 ? Json(change->p) : Json()}});
  return dump(json) + "\n";
}

std::string changes_junit(const Changes& changes) {
  std::string cases;
  std::size_t failures = 0, tests = 0;
  for (const Change& change : changes.changes) {
    const bool failed = change.kind == Change::Kind::Worse || change.kind == Change::Kind::Gone;
    const bool skipped = change.kind == Change::Kind::Undecided;
    ++tests;
    failures += failed ? 1 : 0;
    cases += fmt::format("  <testcase classname=\"compare\" name=\"{}\"", xml_text(change.what + " " + change.figure));
    if (failed) cases += fmt::format("><failure message=\"{}\"/></testcase>\n", xml_text(change_line(change)));
    else if (skipped) cases += "><skipped/></testcase>\n";
    else cases += "/>\n";
  }
  cases += fmt::format("  <testcase classname=\"compare\" name=\"{} compared\"/>\n", changes.compared);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"cageproof compare\" tests=\"{}\" "
      "failures=\"{}\">\n{}</testsuite>\n</testsuites>\n",
      tests + 1, failures, cases);
}

}  // namespace cageproof::reports
