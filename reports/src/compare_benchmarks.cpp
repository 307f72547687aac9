// SPDX-License-Identifier: MIT
#include "cageproof/reports/compare_changes.h"

#include "cageproof/core/input_error.h"
#include "compare_rank_test.h"
#include "json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cageproof::reports {
namespace {

constexpr double significant = 0.01;

struct Timed {
  std::vector<double> nanoseconds;  // of each repetition
  bool failed = false;
};

double in_nanoseconds(double time, const std::string& unit, std::string_view name) {
  const std::map<std::string, double> units{{"ns", 1}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}};
  const auto found = units.find(unit);
  if (found == units.end()) throw InputError(fmt::format("{}: \"{}\" is not a unit of time", name, unit));
  return time * found->second;
}

// A member that is text, or the fallback where it is missing.
std::string text_in(const Json& entry, const char* key, const char* fallback, std::string_view name) {
  if (!entry.contains(key)) return fallback;
  if (!entry[key].is_string()) throw InputError(fmt::format("{}: {} of a benchmark is no text", name, key));
  return entry[key].get<std::string>();
}

// Repetitions by the benchmark's name. Aggregates are left out: they are computed here.
std::map<std::string, Timed> repetitions(const Json& output, std::string_view name) {
  std::map<std::string, Timed> found;
  for (const Json& entry : output["benchmarks"]) {
    if (!entry.is_object() || !entry.contains("name"))
      throw InputError(fmt::format("{}: a benchmark has no name", name));
    if (text_in(entry, "run_type", "iteration", name) == "aggregate") continue;
    const std::string own_name = text_in(entry, "name", "", name);
    const std::string run = text_in(entry, "run_name", own_name.c_str(), name);
    Timed& timed = found[run];
    if (entry.contains("error_occurred") && entry["error_occurred"] == true) {
      timed.failed = true;
      continue;
    }
    // Google Benchmark marks benchmarks that are judged by the clock on the wall.
    const char* time = run.find("/real_time") != std::string::npos ? "real_time" : "cpu_time";
    if (!entry.contains(time) || !entry[time].is_number())
      throw InputError(fmt::format("{}: {} has no number {}", name, run, time));
    timed.nanoseconds.push_back(
        in_nanoseconds(entry[time].get<double>(), text_in(entry, "time_unit", "ns", name), name));
  }
  if (found.empty())
    throw InputError(
        fmt::format("{}: no repetition of a benchmark; leave out --benchmark_report_aggregates_only", name));
  return found;
}

double median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string time_text(double nanoseconds) { return fmt::format("{:.4g}", nanoseconds); }

Change change_of(const std::string& name, const Timed& before, const Timed& after, double tolerance) {
  Change change{Change::Kind::Slight, name, "time in ns", "failed", "failed"};
  if (!before.failed) change.before = time_text(median_of(before.nanoseconds));
  if (!after.failed) change.after = time_text(median_of(after.nanoseconds));
  if (before.failed || after.failed) {
    change.kind = after.failed ? (before.failed ? Change::Kind::Slight : Change::Kind::Worse) : Change::Kind::Better;
    return change;
  }
  change.ratio = median_of(after.nanoseconds) / median_of(before.nanoseconds);
  change.p = rank_test(before.nanoseconds, after.nanoseconds);
  const bool beyond = change.ratio > tolerance || change.ratio < 1 / tolerance;
  if (least_rank_p(before.nanoseconds.size(), after.nanoseconds.size()) >= significant)
    change.kind = beyond ? Change::Kind::Undecided : Change::Kind::Slight;
  else if (change.p < significant)
    change.kind = change.ratio < 1 ? Change::Kind::Better : beyond ? Change::Kind::Worse : Change::Kind::Slight;
  return change;
}

Json output_in(std::string_view text, std::string_view name) {
  if (!is_benchmark_output(text))
    throw InputError(
        fmt::format("{}: not what Google Benchmark writes with --benchmark_format=json; two reports or two "
                    "such outputs can be compared",
                    name));
  return Json::parse(text);
}

}  // namespace

bool is_benchmark_output(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_object() && json.contains("context") && json.contains("benchmarks") && json["benchmarks"].is_array();
}

Changes changes_of_benchmarks(std::string_view old_text, std::string_view new_text, double tolerance,
                              std::string_view old_name, std::string_view new_name) {
  const Json old_output = output_in(old_text, old_name), new_output = output_in(new_text, new_name);
  const auto before = repetitions(old_output, old_name), after = repetitions(new_output, new_name);
  Changes result{.old_name = std::string(old_name), .new_name = std::string(new_name), .tolerance = tolerance};
  result.benchmarks = true;
  for (const auto& [name, timed] : before) {
    const auto other = after.find(name);
    if (other == after.end()) {
      result.changes.push_back({Change::Kind::Gone, name, "", "timed", ""});
      continue;
    }
    ++result.compared;
    if (Change change = change_of(name, timed, other->second, tolerance); change.before != change.after)
      result.changes.push_back(std::move(change));
  }
  for (const auto& [name, timed] : after) {
    if (!before.contains(name)) result.changes.push_back({Change::Kind::Added, name, "", "", "timed"});
    if (timed.failed || timed.nanoseconds.empty()) continue;
    const auto [least, most] = std::ranges::minmax(timed.nanoseconds);
    result.figures.push_back({name, "ns", median_of(timed.nanoseconds), (most - least) / 2});
  }
  const Json& context = new_output["context"];
  if (context.is_object()) {
    result.date = text_in(context, "date", "", new_name);
    result.commit = text_in(context, "commit", "", new_name);
  }
  return result;
}

}  // namespace cageproof::reports
