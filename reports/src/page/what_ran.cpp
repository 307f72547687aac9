// SPDX-License-Identifier: MIT
// The line at the top that says what was run, for one who has read nothing else.
#include "figure.h"
#include "page_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

// "the cage bunny.obj", "12 cages".
std::string named_or_counted(const std::vector<std::string>& names, std::string_view one, std::string_view many) {
  if (names.size() > kMostNames) return fmt::format("{} {}", grouped(names.size()), many);
  return fmt::format("the {} {}", names.size() == 1 ? one : many, fmt::join(names, ", "));
}

}  // namespace

std::string what_ran(const RunResult& result) {
  using enum RowKey::Section;
  std::vector<std::string> parts;
  if (const auto formulas = values_of(result, Element, &RowKey::subject); !formulas.empty())
    parts.push_back(fmt::format("{} in {}", named_or_counted(formulas, "formula", "formulas"),
                                named_or_counted(values_of(result, Element, &RowKey::setting), "regime", "regimes")));
  if (const auto cages = values_of(result, Cage, &RowKey::setting); !cages.empty())
    parts.push_back("coordinates in " + named_or_counted(cages, "cage", "cages"));
  if (const auto cages = values_of(result, Deformer, &RowKey::setting); !cages.empty())
    parts.push_back("deformers of " + named_or_counted(cages, "cage", "cages"));
  std::string text = parts.empty() ? "Nothing" : fmt::format("{}", fmt::join(parts, "; "));
  text += fmt::format(". Suite {}", result.suite);
  if (const auto samples = result.settings.find("samples"); samples != result.settings.end())
    text += fmt::format(", {} samples per formula and regime", samples->second);
  return fmt::format("{}, seed {}.", text, result.seed);
}

}  // namespace cageproof::reports
