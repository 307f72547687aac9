// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/explain.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/input_error.h"

#include <cmath>
#include <map>

namespace cageproof::closed_form {
namespace {

// All explainers, by formula and evaluation.
using Explainers = std::map<std::pair<std::string_view, std::string_view>, Explainer>;

Explainers& explainers() {
  static Explainers all;
  return all;
}

}  // namespace

Explanation explain(const Formula& formula, std::string_view evaluation, const Query<double>& query,
                    std::optional<std::size_t> entry, Result<double>& result) {
  const auto found = explainers().find({formula.name, evaluation});
  if (found == explainers().end())
    throw InputError(std::string(evaluation) + " of " + std::string(formula.name) + " is not run in counted numbers");
  evaluation_named(formula.name, evaluation)(query, result);
  const std::vector<double>& values = result.of(query.order);
  if (entry && *entry >= values.size())
    throw InputError("there is no entry " + std::to_string(*entry) + ": the tensor has " +
                     std::to_string(values.size()));
  return found->second(query, values, entry);
}

std::vector<std::string_view> explained_evaluations(std::string_view formula) {
  std::vector<std::string_view> names;
  for (const auto& [key, explainer] : explainers())
    if (key.first == formula) names.push_back(key.second);
  return names;
}

std::vector<std::string_view> explained_formulas(std::string_view evaluation) {
  std::vector<std::string_view> names;
  for (const auto& [key, explainer] : explainers())
    if (key.second == evaluation) names.push_back(key.first);
  return names;
}

void choose(Explanation& explanation, const CountedTape& tape, std::span<const Counted> counted, int exponent,
            std::span<const double> values, std::optional<std::size_t> entry) {
  const auto error = [&](std::size_t i) {
    const double e = std::abs(static_cast<double>(Mp200(Mp200(counted[i].value) - counted[i].shadow)));
    return std::isfinite(e) ? e : -1;
  };
  std::size_t chosen = entry.value_or(0);
  for (std::size_t i = 0; !entry && i < counted.size(); ++i)
    if (error(i) > error(chosen)) chosen = i;
  const Counted& x = counted[chosen];
  explanation.entry = chosen;
  explanation.value = values[chosen];
  explanation.counted = std::ldexp(x.value, exponent);
  explanation.exact = ldexp(x.shadow, exponent);
  explanation.operations = tape.size();
  explanation.lines = tape.lines(x, std::ldexp(1., exponent));
  const bool both_nan = std::isnan(explanation.value) && std::isnan(explanation.counted);
  explanation.is_the_value = both_nan || explanation.value == explanation.counted;
}

void choose_none(Explanation& explanation, std::span<const double> values, std::optional<std::size_t> entry) {
  explanation.entry = entry.value_or(0);
  explanation.value = explanation.counted = values[explanation.entry];
  explanation.exact = explanation.value;
  explanation.is_the_value = false;
}

RegisterExplainer::RegisterExplainer(std::string_view formula, std::string_view evaluation, Explainer explainer) {
  explainers()[{formula, evaluation}] = explainer;
}

}  // namespace cageproof::closed_form
