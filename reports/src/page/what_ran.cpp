// SPDX-License-Identifier: MIT
// The line at the top that names the contents of the run, for a reader who knows nothing else of it.
#include "figure.h"
#include "page_data.h"
#include "run_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace cageproof::reports {
namespace {

// More names than these would be a list, and tables below have it.
constexpr std::size_t kMostNames = 3;

std::vector<std::string> values_of(const RunResult& result, RowKey::Section section, std::string RowKey::*member) {
  std::vector<std::string> values;
  for (const ResultRow& row : result.rows)
    if (row.section == section && std::ranges::find(values, row.*member) == values.end()) values.push_back(row.*member);
  return values;
}

std::vector<std::string> cages_of(const RunResult& result, RowKey::Section section, const ShownNames& names) {
  std::vector<std::string> cages = values_of(result, section, &RowKey::setting);
  for (std::string& cage : cages) cage = names.of(cage);
  return cages;
}

// "the cage bunny.obj", "12 cages".
std::string named_or_counted(const std::vector<std::string>& names, std::string_view one, std::string_view many) {
  if (names.size() > kMostNames) return fmt::format("{} {}", grouped(names.size()), many);
  return fmt::format("the {} {}", names.size() == 1 ? one : many, fmt::join(names, ", "));
}

// Places of cages' points; points from a given file have a place of their own.
enum class Whereabouts { Off, On, Given };

Whereabouts whereabouts_of(const std::string& place) {
  if (place == "mesh") return Whereabouts::Given;
  return place.starts_with("on-") ? Whereabouts::On : Whereabouts::Off;
}

// How many points the kinds of coordinates were asked at, at most: checks of one place share their points.
std::map<Whereabouts, std::uint64_t> points_of_cages(const RunResult& result) {
  std::map<std::pair<std::string, std::string>, std::uint64_t> most;
  for (const ResultRow& row : result.rows) {
    if (row.section != RowKey::Section::Cage) continue;
    std::uint64_t& points = most[{row.setting, row.place}];
    points = std::max(points, row.asked);
  }
  std::map<Whereabouts, std::uint64_t> sums;
  for (const auto& [where, points] : most) sums[whereabouts_of(where.second)] += points;
  return sums;
}

// ", up to 16 points off the cage, 278 on it"; empty where no cage was asked.
std::string points_text(const RunResult& result, std::size_t cages) {
  if (cages == 0) return "";
  std::map<Whereabouts, std::uint64_t> points = points_of_cages(result);
  if (points[Whereabouts::Off] + points[Whereabouts::On] == 0) return "";
  std::string text =
      fmt::format(", up to {} points off the {}, {} on {}", grouped(points[Whereabouts::Off]),
                  cages == 1 ? "cage" : "cages", grouped(points[Whereabouts::On]), cages == 1 ? "it" : "them");
  if (const std::uint64_t given = points[Whereabouts::Given]; given > 0)
    text += fmt::format(", {} of those that were given", grouped(given));
  return text;
}

}  // namespace

std::string what_ran(const RunResult& result) {
  using enum RowKey::Section;
  const ShownNames names = names_of_run(result);
  std::vector<std::string> parts;
  const auto formulas = values_of(result, Element, &RowKey::subject);
  if (!formulas.empty())
    parts.push_back(fmt::format("{} in {}", named_or_counted(formulas, "formula", "formulas"),
                                named_or_counted(values_of(result, Element, &RowKey::setting), "regime", "regimes")));
  const auto cages = cages_of(result, Cage, names);
  if (!cages.empty()) parts.push_back("coordinates in " + named_or_counted(cages, "cage", "cages"));
  if (const auto deformed = cages_of(result, Deformer, names); !deformed.empty())
    parts.push_back("deformers of " + named_or_counted(deformed, "cage", "cages"));
  std::string text = parts.empty() ? "Nothing" : fmt::format("{}", fmt::join(parts, "; "));
  text += fmt::format(". Suite {}", result.suite);
  if (const auto samples = result.settings.find("samples"); samples != result.settings.end() && !formulas.empty())
    text += fmt::format(", {} samples per formula and regime", samples->second);
  text += points_text(result, cages.size());
  return fmt::format("{}, seed {}.", text, result.seed);
}

}  // namespace cageproof::reports
