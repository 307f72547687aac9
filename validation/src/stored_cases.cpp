// SPDX-License-Identifier: MIT
#include "cageproof/validation/stored_cases.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/campaign.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace cageproof::validation {
namespace {

using reports::WorstLine;

// The row a case belongs to, without figures.
ResultRow row_of(const WorstLine& line) {
  ResultRow row;
  row.subject = line.subject;
  row.evaluation = line.evaluation;
  row.scalar = line.scalar;
  row.regime = hunted_regime;
  row.check = line.check;
  row.order = line.order;
  row.unit = line.unit;
  return row;
}

// By formula as the catalogue has them, then as a campaign sorts its rows.
auto key_of(const WorstLine& line) {
  const auto formula = find_formula(line.subject) - catalogue().data();
  const auto check = std::ranges::find(checks(), line.check, [](const auto& c) { return c->name(); }) - checks().begin();
  return std::tuple(formula, check, line.evaluation != "closed_form", line.evaluation, line.scalar, line.order);
}

}  // namespace

std::vector<ResultRow> replay_stored(std::string_view text, std::string_view name, const std::string& formulas,
                                     const std::string& evaluations, int jobs) {
  std::vector<WorstLine> lines = reports::parse_worst(text, name);
  const auto at = [&](const WorstLine& line) { return fmt::format("{}:{}: ", name, line.number); };
  for (const WorstLine& line : lines) {
    if (line.section != ResultRow::Section::Element) throw InputError(at(line) + "a case of a cage");
    // What is left out today must still be something that exists.
    if (!find_formula(line.subject)) throw InputError(fmt::format("{}unknown formula '{}'", at(line), line.subject));
    if (!EvaluationRegister::instance().find(line.subject, line.evaluation))
      throw InputError(fmt::format("{}{} has no evaluation '{}'", at(line), line.subject, line.evaluation));
  }
  std::erase_if(lines, [&](const WorstLine& line) {
    return !matches(formulas, line.subject) || !matches(evaluations, line.evaluation);
  });
  // Which of several bad lines is named must not depend on the threads.
  std::vector<std::string> failures(lines.size());
  for_each_parallel(lines.size(), jobs, [&](std::size_t i) {
    try {
      lines[i].worst.error = replay(row_of(lines[i]), lines[i].worst, Triangulation::Shortest);
    } catch (const InputError& e) {
      failures[i] = at(lines[i]) + e.what();
    }
  });
  for (const std::string& failure : failures)
    if (!failure.empty()) throw InputError(failure);

  struct Gathered {
    ResultRow row;
    ErrorHistogram errors;
  };
  std::map<decltype(key_of(WorstLine())), Gathered> gathered;
  for (const WorstLine& line : lines) {
    auto& [row, errors] = gathered.try_emplace(key_of(line), Gathered{row_of(line), {}}).first->second;
    if (std::isnan(line.worst.error)) {
      ++row.without_truth;
      continue;
    }
    errors.add(line.worst.error);
    row.worst.push_back(line.worst);
  }
  std::vector<ResultRow> rows;
  for (auto& [key, found] : gathered) {
    auto& [row, errors] = found;
    row.samples = errors.count();
    row.nonfinite = errors.nonfinite();
    row.max = errors.max();
    row.p999 = errors.p999();
    row.median = errors.median();
    row.histogram.assign(errors.counts().begin(), errors.counts().end());
    std::ranges::stable_sort(row.worst, std::greater(), &WorstCase::error);
    judge(row);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace cageproof::validation
