// SPDX-License-Identifier: MIT
#include "advice.h"

#include "cageproof/core/catalogue/role.h"
#include "digest.h"
#include "figure.h"
#include "page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::reports {
namespace {

// In roundings of double.
constexpr double kTwelveDigits = 1e4;

bool is_values(const RowKey& row, const std::string& formula, const std::string& evaluation) {
  return row.section == RowKey::Section::Element && row.subject == formula && row.evaluation == evaluation &&
         row.scalar == "double" && row.check == "truth" && row.order == 0;
}

std::string recommended(const RunResult& result, const std::string& formula) {
  for (const EvaluationTime& time : times_of(result))
    if (time.formula == formula && role_of(result, formula, time.evaluation) == name_of(Role::Recommended))
      return time.evaluation;
  return "";
}

// "everywhere: hybrid, 1.7 us (gradient 1.8 us, Hessian 2.7 us)"
std::string lead_text(const RunResult& result, const std::string& formula, const std::string& lead) {
  const bool fell_short = std::ranges::any_of(result.rows, [&](const ResultRow& row) {
    return row.section == RowKey::Section::Element && row.subject == formula && row.evaluation == lead &&
           row.verdict == Verdict::Broken;
  });
  const std::string text = fmt::format("{}: {}, {}", fell_short ? "everywhere but where it fell short" : "everywhere",
                                       lead, duration_text(*time_of(result, formula, lead, 0)));
  std::string more;
  for (const int order : {1, 2})
    if (const auto time = time_of(result, formula, lead, order))
      more += fmt::format("{}{} {}", more.empty() ? "" : ", ", order_name(order), duration_text(*time));
  return more.empty() ? text : fmt::format("{} ({})", text, more);
}

// The rules that reach somewhere, and the recommended evaluation, wherever it reaches.
std::vector<Choice> choices(const RunResult& result, const std::string& formula, const std::string& lead) {
  std::vector<Choice> found;
  for (const EvaluationTime& time : times_of(result)) {
    if (time.formula != formula || time.order != 0) continue;
    const auto reach = reach_of(result, formula, time.evaluation);
    if (time.evaluation == lead)
      found.push_back({lead, reach.value_or(std::numeric_limits<double>::infinity()), time.nanoseconds, true});
    else if (reach && role_of(result, formula, time.evaluation) == name_of(Role::Rule))
      found.push_back({time.evaluation, *reach, time.nanoseconds, false});
  }
  return found;
}

}  // namespace

const std::vector<EvaluationTime>& times_of(const RunResult& result) {
  static const std::vector<EvaluationTime> none;
  const auto timed = std::ranges::find_if(result.sessions, [](const Session& s) { return !s.times.empty(); });
  return timed == result.sessions.end() ? none : timed->times;
}

std::optional<double> time_of(const RunResult& result, const std::string& formula, const std::string& evaluation,
                              int order) {
  for (const EvaluationTime& time : times_of(result))
    if (time.formula == formula && time.evaluation == evaluation && time.order == order) return time.nanoseconds;
  return std::nullopt;
}

std::optional<double> reach_of(const RunResult& result, const std::string& formula, const std::string& evaluation) {
  for (const ResultRow& row : result.rows)
    if (is_values(row, formula, evaluation) && row.setting == "generic" &&
        !(row.max_relative <= std::ldexp(kTwelveDigits, -53)))
      return std::nullopt;
  // Above the largest distance at which one of the regimes has lost them.
  double lost = 0, smallest = std::numeric_limits<double>::infinity();
  for (const ResultCurve& curve : result.curves) {
    if (!is_values(curve, formula, evaluation) || !curve.setting.starts_with("near-")) continue;
    for (std::size_t i = 0; i < curve.parameters.size(); ++i)
      if (!(curve.errors[i] <= kTwelveDigits)) lost = std::max(lost, curve.parameters[i]);
  }
  for (const ResultCurve& curve : result.curves)
    if (is_values(curve, formula, evaluation) && curve.setting.starts_with("near-"))
      for (const double parameter : curve.parameters)
        if (parameter > lost) smallest = std::min(smallest, parameter);
  if (!std::isfinite(smallest)) return std::nullopt;
  return smallest;
}

std::vector<Choice> without_dominated(std::vector<Choice> choices) {
  const auto dominates = [](const Choice& a, const Choice& b) {
    return a.nanoseconds <= b.nanoseconds && a.reach <= b.reach &&
           (a.nanoseconds < b.nanoseconds || a.reach < b.reach || a.recommended);
  };
  const std::vector<Choice> all = choices;
  std::erase_if(choices, [&](const Choice& choice) {
    if (choice.recommended) return false;
    return std::ranges::any_of(all, [&](const Choice& o) { return dominates(o, choice); });
  });
  std::ranges::stable_sort(choices, [](const Choice& a, const Choice& b) {
    return a.nanoseconds != b.nanoseconds ? a.nanoseconds < b.nanoseconds : a.reach < b.reach;
  });
  return choices;
}

std::string advice(const RunResult& result, const std::string& formula) {
  const std::string lead = recommended(result, formula);
  std::string text;
  for (const Choice& choice : without_dominated(choices(result, formula, lead))) {
    if (!text.empty()) text += "; ";
    text += choice.evaluation == lead ? lead_text(result, formula, lead)
                                      : fmt::format("12 digits down to {} sizes: {}, {}", short_number(choice.reach),
                                                    choice.evaluation, duration_text(choice.nanoseconds));
  }
  return text;
}

}  // namespace cageproof::reports
