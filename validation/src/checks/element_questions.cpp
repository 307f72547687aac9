// SPDX-License-Identifier: MIT
#include "checks/element_questions.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/regime.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

std::vector<std::string_view> names_of_scalars() {
  std::vector<std::string_view> names;
  names.reserve(scalar_kinds.size());
  for (const ScalarKind kind : scalar_kinds) names.push_back(name_of(kind));
  return names;
}

std::vector<std::string_view> names_of_regimes() {
  std::vector<std::string_view> names{hull_regime, hunted_regime};
  for (const Regime& regime : regimes()) names.push_back(regime.name);
  return names;
}

}  // namespace

const Truth& ElementAt::truth() const {
  if (!truth_) truth_ = truth_from(source_, sample_, order_);
  return *truth_;
}

WorstCase ElementAt::case_of(const Finding& finding, int order) const {
  const Sample& s = sample_;
  WorstCase worst{finding.error, s.parameter, s.index, s.corners, s.point, s.parameters};
  worst.relative = finding.relative;
  if (finding.entry < 0) return worst;
  // Enough to see where a double differs.
  constexpr int digits = 20;
  const Mp100& wanted = truth().tensors.of(order)[static_cast<std::size_t>(finding.entry)];
  worst.furthest = {finding.entry, finding.found, format_digits(wanted, digits)};
  return worst;
}

std::optional<ElementQuestion> element_question(const Check& check, const Evaluation& evaluation, ScalarKind scalar,
                                                std::string_view regime, int order) {
  const Formula& formula = evaluation.formula();
  if (order < check.orders().lowest || !evaluation.supports(scalar) ||
      !check.applies(formula, evaluation, scalar, regime))
    return std::nullopt;
  ElementQuestion question{{}, &check, evaluation, scalar};
  question.key = {RowKey::Section::Element,
                  std::string(formula.name),
                  evaluation.name(),
                  std::string(name_of(scalar)),
                  std::string(regime),
                  std::string(check.name()),
                  "",
                  0};
  question.unit = check.unit();
  question.orders = check.orders();
  question.orders.highest = std::min(question.orders.highest, order);
  // Evaluations with fewer derivatives are asked for fewer.
  question.asked = order < std::min(2, evaluation.max_order()) ? order : 2;
  question.ask = [&check, &formula, evaluation, scalar, order](const ElementAt& at) {
    return check.measure({formula, evaluation, scalar, at.sample(), order, at.truth(), at.results()});
  };
  return question;
}

ElementQuestion element_question(const RowKey& row, int asked) {
  const Evaluation evaluation = evaluation_named(formula_named(row.subject).name, row.evaluation);
  const auto scalar = scalar_named(row.scalar);
  if (!scalar) throw unknown_name("scalar", row.scalar, names_of_scalars());
  const Check* check = find_check(row.check);
  if (!check) throw unknown_name("check", row.check, check_names());
  if (const auto known = names_of_regimes(); std::ranges::find(known, row.setting) == known.end())
    throw unknown_name("regime", row.setting, known);
  const int order = std::min(asked, evaluation.max_order());
  auto question = element_question(*check, evaluation, *scalar, row.setting, order);
  if (!question)
    throw InputError(
        fmt::format("the check '{}' is not asked of {} in {}, {}", row.check, row.evaluation, row.scalar, row.setting));
  if (row.order < 0 || row.order > order)
    throw InputError(fmt::format("{} was not asked for order {}", row.evaluation, row.order));
  return std::move(*question);
}

}  // namespace cageproof::validation
