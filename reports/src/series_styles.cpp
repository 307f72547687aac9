// SPDX-License-Identifier: MIT
#include "series_styles.h"

#include "cageproof/core/catalogue/role.h"
#include "colours.h"

#include <algorithm>
#include <array>
#include <set>

namespace cageproof::reports {
namespace {

// Dashes per scalar type, double first: of the first evaluations, then of evaluations that share a colour with these.
const std::array<std::array<std::vector<int>, 2>, 3>& dashes() {
  static const std::array<std::array<std::vector<int>, 2>, 3> all{
      {{{{}, {8, 4}}}, {{{2, 3}, {8, 3, 2, 3}}}, {{{12, 3, 2, 3, 2, 3}, {4, 6}}}}};
  return all;
}
constexpr std::size_t kShapeCount = 5;

using Names = std::vector<std::string>;

void note(Names& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// The evaluations of each formula that are drawn, and all of them, those that are recommended first.
struct Drawn {
  std::map<std::string, Names> of_formula;
  Names all;
};

Drawn drawn_in(const RunResult& result) {
  Drawn drawn;
  Names others;
  const auto take = [&](const std::string& formula, const std::string& evaluation, const std::string& role) {
    note(drawn.of_formula[formula], evaluation);
    note(role == name_of(Role::Recommended) ? drawn.all : others, evaluation);
  };
  for (const ResultCurve& curve : result.curves) take(curve.subject, curve.evaluation, curve.role);
  // Times are drawn of what was compared with the truth, and say nothing here: they differ from run to run.
  for (const ResultRow& row : result.rows)
    if (row.section == RowKey::Section::Element && row.check == "truth") take(row.subject, row.evaluation, row.role);
  for (const std::string& name : others) note(drawn.all, name);
  return drawn;
}

}  // namespace

SeriesStyles::SeriesStyles(const RunResult& result) : scalars_{"double"} {
  for (const ResultCurve& curve : result.curves) note(scalars_, curve.scalar);
  const Drawn drawn = drawn_in(result);
  // The least number that no evaluation of a common formula has.
  for (const std::string& name : drawn.all) {
    std::set<std::size_t> taken;
    for (const auto& [formula, names] : drawn.of_formula) {
      if (std::ranges::find(names, name) == names.end()) continue;
      for (const std::string& other : names)
        if (const auto known = number_.find(other); known != number_.end()) taken.insert(known->second);
    }
    std::size_t least = 0;
    while (taken.contains(least)) ++least;
    number_.emplace(name, least);
  }
}

SeriesStyle SeriesStyles::of(const std::string& evaluation, const std::string& scalar) const {
  const std::size_t number = number_.at(evaluation), count = kCurveColours.size();
  const auto place = static_cast<std::size_t>(std::ranges::find(scalars_, scalar) - scalars_.begin());
  const auto& of_scalar = dashes()[std::min(place, dashes().size() - 1)];
  return {kCurveColours[number % count], of_scalar[number / count % of_scalar.size()],
          static_cast<int>((number % count + number / count) % kShapeCount), place == 0};
}

}  // namespace cageproof::reports
