// SPDX-License-Identifier: MIT
#include "cageproof/reports/broken_groups.h"

#include "digest.h"
#include "figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

namespace cageproof::reports {
namespace {

// The rows that one fault may break: those of one element's formulas, of one deformer, or of one cage.
std::string about(const ResultRow& row) {
  return row.section == RowKey::Section::Cage ? row.setting : row.subject.substr(0, row.subject.find('.'));
}

// The first few of the rows' words, each once.
template <class Member>
std::string named(const BrokenGroup& group, Member member) {
  constexpr std::size_t most = 6;
  std::vector<std::string> names;
  for (const ResultRow* row : group.rows) {
    std::string name = member(*row);
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  const std::size_t more = names.size() > most ? names.size() - most : 0;
  names.resize(names.size() - more);
  return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

void find_simplest(BrokenGroup& group) {
  std::size_t shortest = 0;
  for (const ResultRow* row : group.rows)
    for (const WorstCase& worst : row->worst) {
      // An error within its bound shows nothing.
      if (!row->bound || worst.error <= *row->bound) continue;
      const std::size_t length = input_line(worst).size();
      if (group.simplest && length >= shortest) continue;
      shortest = length;
      group.simplest = &worst;
      group.simplest_row = row;
    }
}

}  // namespace

std::vector<BrokenGroup> broken_groups(const RunResult& result) {
  using Key = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<Key, std::size_t> place;
  std::vector<BrokenGroup> groups;
  for (const ResultRow* row : broken_rows(result)) {
    const auto [at, fresh] = place.try_emplace({row->check, row->evaluation, row->scalar, about(*row)}, groups.size());
    if (fresh) groups.emplace_back();
    groups[at->second].rows.push_back(row);
  }
  std::ranges::for_each(groups, find_simplest);
  std::ranges::stable_sort(groups, std::greater(), [](const BrokenGroup& group) {
    return std::tuple(group.rows.front()->is_foundation, group.rows.size());
  });
  return groups;
}

std::string title_of(const BrokenGroup& group) {
  const ResultRow& first = *group.rows.front();
  const bool cage = first.section != RowKey::Section::Element;  // so that rows have a cage for a regime, and a place
  // Deformers with their defaults have no evaluation.
  const std::string evaluation = first.evaluation.empty() ? "" : " of " + first.evaluation;
  return fmt::format("{}{} in {}: {} of {}; {}{}; {} {}", first.check, evaluation, first.scalar,
                     group.rows.size() == 1 ? "1 row" : fmt::format("{} rows", group.rows.size()),
                     named(group, [](const ResultRow& row) { return row.subject; }), cage ? "cage " : "",
                     named(group, [](const ResultRow& row) { return row.setting; }) +
                         (cage ? ", " + named(group, [](const ResultRow& row) { return row.place; }) : ""),
                     "order", named(group, [](const ResultRow& row) { return std::to_string(row.order); }));
}

std::string breach(const ResultRow& row) {
  const bool above = row.bound && row.samples > 0 && !(row.max <= *row.bound);
  return above ? fmt::format("{:.3g} {} > {:.3g}, {}", row.max, row.unit, *row.bound, row.reason) : row.reason;
}

std::string error_line(const ResultRow& row, const WorstCase& input) {
  return fmt::format("{} {} {}{}", short_error(input.error), row.unit, input.corners.empty() ? "" : "at ",
                     input_line(input));
}

std::string input_line(const WorstCase& input) {
  const auto vector = [](const Vec3<double>& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); };
  std::string text;
  for (const Vec3<double>& corner : input.corners) text += vector(corner) + " ";
  text += (text.empty() ? "at " : "seen from ") + vector(input.point);
  if (!input.frame.is_own())
    text += fmt::format(", the cage moved by {} and in units of {}", vector(input.frame.shift), input.frame.unit);
  if (!input.parameters.empty()) text += fmt::format(", parameters {}", fmt::join(input.parameters, ", "));
  return text;
}

}  // namespace cageproof::reports
