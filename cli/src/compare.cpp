// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/compare.h"
#include "cageproof/reports/compare_formats.h"
#include "cageproof/reports/journal.h"
#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/summary.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <fstream>

namespace cageproof::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string before, after, names, tolerance, format = "text", junit, history, commit, action, bencher;
  std::vector<std::string> badges;
  bool writes() const {
    return !junit.empty() || !history.empty() || !action.empty() || !bencher.empty() || !badges.empty();
  }
};

// "2x", "2" or "20%".
double factor_of(const std::string& text) {
  double factor = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), factor);
  const std::string_view unit(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
  if (unit == "%") factor = 1 + factor / 100;
  if (error != std::errc() || !(unit.empty() || unit == "x" || unit == "%") || !(factor >= 1) || std::isinf(factor))
    throw InputError(fmt::format("--tolerance {}: not a factor of at least 1, such as 2x or 1.2x or 20%", text));
  return factor;
}

// A report's folder, its summary.json.gz, or a journal, which is judged now.
std::string summary_of(const fs::path& path) {
  std::error_code ignored;
  fs::path file = path;
  if (fs::is_directory(path, ignored))
    for (const std::string_view name :
         {std::string_view(reports::summary_file), std::string_view("summary.json"), reports::journal_file})
      if (file = path / name; fs::exists(file, ignored)) break;
  if (!reports::find_journal_header(file)) return reports::read_packed(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (const auto lacking = validation::unfinished(reports::read_journal(file), folder))
    fmt::print(stderr, "warning: {}; only what these found is compared\n", *lacking);
  return validation::summary_of_journal(file);
}

// Rows of other samples differ, and rows that one run has not are gone, whatever the code does.
void warn_of_settings(const Arguments& a, const std::vector<std::string>& settings) {
  if (settings.empty()) return;
  fmt::print(stderr,
             "warning: {} and {} come from other settings ({}), so that figures differ and rows are missing for that "
             "reason, too; run `verify` with the same options for both\n",
             a.before, a.after, fmt::join(settings, "; "));
}

void append_line(const fs::path& path, const std::string& line) {
  std::ofstream file(path, std::ios::app | std::ios::binary);
  file.write(line.data(), static_cast<std::streamsize>(line.size())).flush();
  if (!file) throw InputError(fmt::format("cannot write {}", path.string()));
}

int judge(const Arguments& a) {
  const double tolerance = factor_of(a.tolerance);
  const reports::Renamed renamed = a.names.empty() ? reports::Renamed() : reports::read_renamed(a.names);
  std::vector<fs::path> paths;
  for (const std::string& file : {a.junit, a.action, a.bencher, a.history})
    if (!file.empty()) paths.emplace_back(file);
  for (const std::string& file : a.badges) {
    if (!file.ends_with(".json") && !file.ends_with(".svg"))
      throw InputError(fmt::format("--badge {}: the name must end with .json (shields.io's endpoint) or .svg", file));
    paths.emplace_back(file);
  }
  reports::require_writable(paths);
  const std::string before = summary_of(a.before), after = summary_of(a.after);
  const bool times = reports::is_benchmark_output(before) || reports::is_benchmark_output(after);
  const reports::Changes changes =
      times ? reports::changes_of_benchmarks(before, after, tolerance, a.before, a.after)
            : reports::changes_of_summaries(before, after, renamed, tolerance, a.before, a.after);
  warn_of_settings(a, changes.settings);
  std::vector<std::pair<fs::path, std::string>> files;
  if (!a.junit.empty()) files.emplace_back(a.junit, changes_junit(changes));
  if (!a.action.empty()) files.emplace_back(a.action, smaller_is_better_json(changes));
  if (!a.bencher.empty()) files.emplace_back(a.bencher, bencher_json(changes));
  for (const std::string& file : a.badges)
    files.emplace_back(file, file.ends_with(".svg") ? badge_svg(changes) : badge_json(changes));
  reports::replace_files(files);
  if (!a.history.empty()) append_line(a.history, history_line(changes, a.commit));
  fmt::print("{}", a.format == "json"       ? changes_json(changes)
                   : a.format == "markdown" ? changes_markdown(changes)
                                            : changes_text(changes));
  return changes.fails() ? promise_broken : success;
}

int run(const Arguments& a) {
  if (!a.tolerance.empty()) return judge(a);
  if (a.format != "text" || a.writes())
    throw InputError(
        "--format and files of results need --tolerance, such as --tolerance 2x, which says what is worse");
  const reports::Renamed renamed = a.names.empty() ? reports::Renamed() : reports::read_renamed(a.names);
  const reports::Differences found =
      reports::compare_summaries(summary_of(a.before), summary_of(a.after), renamed, a.before, a.after);
  warn_of_settings(a, found.settings);
  if (found.taken_for_hybrid > 0)
    fmt::print("{} entries closed_form of {}, whose schema is before 4, are compared with hybrid, their name today\n",
               found.taken_for_hybrid, a.before);
  for (const std::string& line : found.differing) fmt::print("differs: {}\n", line);
  for (const std::string& line : found.gone) fmt::print("only in {}: {}\n", a.before, line);
  for (const std::string& line : found.added) fmt::print("only in {}: {}\n", a.after, line);
  fmt::print("{} equal, {} differ, {} only in {}, {} only in {}\n", found.equal, found.differing.size(),
             found.gone.size(), a.before, found.added.size(), a.after);
  return found.same() ? success : promise_broken;
}

}  // namespace

void add_compare(CommandLine& line) {
  Command command = line.command("compare",
                                 "print figures and verdicts that differ between two reports or journals; exit 1 when "
                                 "any does, or with --tolerance when any got worse");
  auto a = std::make_shared<Arguments>();
  command
      .option("old", a->before,
              "a report's folder, its summary.json.gz, or a journal; with --tolerance also Google Benchmark's JSON")
      .taking("FILE")
      .required();
  command.option("new", a->after, "another").taking("FILE").required();
  command
      .option("--names", a->names,
              R"(JSON object {"old": "new"} of names that changed; "subject/old" only in that subject's rows)")
      .taking("FILE");
  command
      .option("--tolerance", a->tolerance,
              "fail only where a verdict got worse, a figure or a time grew by more than this factor, or a promise is "
              "gone: 2x, or 20%")
      .taking("FACTOR");
  command.heading("with --tolerance");
  command.option("--format", a->format, "markdown is for a pull request's comment")
      .one_of({"text", "markdown", "json"})
      .showing_default();
  command.option("--junit", a->junit, "JUnit's XML").taking("FILE");
  command.option("--history", a->history, "append a JSON line: date, commit and figures of the new run").taking("FILE");
  command.option("--commit", a->commit, "the commit in that line; if not given, the run's").taking("NAME");
  command.option("--badge", a->badges, "endpoint JSON for shields.io (.json), or a picture (.svg); may be repeated")
      .taking("FILE")
      .one_at_a_time();
  command.option("--benchmark-action", a->action, "figures for github-action-benchmark, customSmallerIsBetter")
      .taking("FILE");
  command.option("--bencher", a->bencher, "figures for Bencher, BMF JSON").taking("FILE");
  command.example("cageproof compare report-before report-after");
  command.example("cageproof compare report-before report-after --tolerance 2x --format markdown --junit compare.xml");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
