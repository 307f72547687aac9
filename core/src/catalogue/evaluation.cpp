// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/evaluation.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/field_words.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <typeinfo>
#include <stdexcept>

namespace cageproof {

Evaluation::Evaluation(std::string_view formula, std::string_view name, EvaluationFacts facts)
    : formula_(find_formula(formula)), name_(name), facts_(std::make_shared<const EvaluationFacts>(std::move(facts))) {
  if (formula_ == nullptr)
    throw std::logic_error("an evaluation of " + std::string(formula) + ", which the catalogue does not have");
}

template <Scalar R>
void Evaluation::operator()(const Query<R>& query, Result<R>& result) const {
  const EvaluationFunctions<R>& functions = of<R>();
  if (functions.point) return functions.point(query, result);
  result.reset(formula_->components(), formula_->dim(), query.order);
  Statement statement;
  functions.batch(Batch<R>{query.corners, {&query.point, 1}, query.order, query.parameters, query.finite_part},
                  output_of(*formula_, result, statement));
  result.stated_digits = statement.digits;
  result.converged = statement.converged;
  result.nodes = statement.nodes;
}

template <Scalar R>
void Evaluation::operator()(const Batch<R>& batch, const BatchOutput<R>& output) const {
  const EvaluationFunctions<R>& functions = of<R>();
  if (functions.batch) return functions.batch(batch, output);
  // The result's arrays are kept from point to point.
  Result<R> result;
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    functions.point(Query<R>{batch.corners, batch.points[p], batch.order, batch.parameters, batch.finite_part}, result);
    for (int o = 0; o <= batch.order; ++o) output.put(p, o, result.of(o));
    output.state(p, result.statement());
  }
}

template <Scalar R>
void Evaluation::together(std::span<const Evaluation* const> members, const Batch<R>& batch,
                          std::span<const BatchOutput<R>> outputs) {
  std::vector<const JointForm<R>*> forms;
  for (const Evaluation* member : members)
    if (const JointForm<R>* form = member->of<R>().joint.get();
        form != nullptr && (forms.empty() || typeid(*form) == typeid(*forms.front())))
      forms.push_back(form);
  if (forms.size() > 1 && forms.size() == members.size()) return forms.front()->together(forms, batch, outputs);
  for (std::size_t m = 0; m < members.size(); ++m) (*members[m])(batch, outputs[m]);
}

#define CAGEPROOF_INSTANTIATE(R)                                                             \
  template void Evaluation::operator()<R>(const Query<R>&, Result<R>&) const;                \
  template void Evaluation::operator()<R>(const Batch<R>&, const BatchOutput<R>&) const;     \
  template void Evaluation::together<R>(std::span<const Evaluation* const>, const Batch<R>&, \
                                        std::span<const BatchOutput<R>>);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

EvaluationRegister& EvaluationRegister::instance() {
  static EvaluationRegister instance;
  return instance;
}

void EvaluationRegister::add(EvaluationFamily family) { families_.push_back(std::move(family)); }

std::vector<const EvaluationFamily*> EvaluationRegister::families(std::string_view formula) const {
  std::vector<const EvaluationFamily*> found;
  for (const EvaluationFamily& family : families_)
    if (family.formula == formula) found.push_back(&family);
  std::ranges::sort(found, {},
                    [](const EvaluationFamily* f) { return std::pair(f->role != Role::Recommended, f->pattern); });
  return found;
}

std::optional<Evaluation> EvaluationRegister::find(std::string_view formula, std::string_view name) const {
  for (const EvaluationFamily* family : families(formula)) {
    const bool is_alias = !family->alias.empty() && name == family->alias;
    if (auto evaluation = family->make(is_alias ? std::string_view(family->pattern) : name)) return evaluation;
  }
  return std::nullopt;
}

std::optional<Evaluation> EvaluationRegister::with_role(std::string_view formula, Role role) const {
  const EvaluationFamily* found = nullptr;
  for (const EvaluationFamily* family : families(formula)) {
    const bool better = found == nullptr || (found->standard.empty() && !family->standard.empty());
    if (family->role == role && better) found = family;
  }
  if (found == nullptr) return std::nullopt;
  return found->example();
}

std::vector<std::string> EvaluationRegister::standard(std::string_view formula) const {
  std::vector<std::pair<bool, std::string>> names;
  for (const EvaluationFamily* family : families(formula))
    for (const std::string& name : family->standard) names.emplace_back(family->role != Role::Recommended, name);
  std::ranges::sort(names);
  std::vector<std::string> sorted;
  sorted.reserve(names.size());
  for (auto& [later, name] : names) sorted.push_back(std::move(name));
  return sorted;
}

EvaluationFamily single_family(std::string_view formula, std::string_view name, EvaluationFacts facts, bool standard,
                               std::function<void(Evaluation&)> fill) {
  const Role role = facts.role;
  const auto make = [formula = std::string(formula), name = std::string(name), facts = std::move(facts),
                     fill = std::move(fill)](std::string_view asked) -> std::optional<Evaluation> {
    if (asked != name) return std::nullopt;
    Evaluation evaluation(formula, name, facts);
    fill(evaluation);
    return evaluation;
  };
  EvaluationFamily family{std::string(formula), std::string(name), role, {}, make};
  if (standard) family.standard = {family.pattern};
  return family;
}

std::vector<std::string_view> evaluation_names(std::string_view formula) {
  std::vector<std::string_view> names;
  const auto add = [&](std::string_view name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(formula)) {
    for (const std::string& name : family->standard) add(name);
    add(family->pattern);
    add(family->alias);
  }
  return names;
}

std::string why_no_evaluation(std::string_view subject, const std::vector<std::string_view>& formulas,
                              std::string_view name, const std::vector<std::string_view>& more) {
  const std::string text = fmt::format("{} has no evaluation '{}'", subject, name);
  if (is_glob(name)) return text + ": one name is asked for here, no glob";
  if (name.find(',') != std::string_view::npos) return text + ": one name is asked for here, no list";
  std::vector<std::string_view> known = more;
  for (const std::string_view formula : formulas) {
    const auto names = evaluation_names(formula);
    known.insert(known.end(), names.begin(), names.end());
  }
  if (const std::string_view family = family_of_number(name); std::ranges::find(known, family) != known.end())
    return fmt::format("{}: {} takes {}", text, family, range_of_pattern(family));
  if (const std::string words = called_here(fmt::format("evaluation of {}", subject), name, known); !words.empty())
    return fmt::format("{}{} (see `cageproof list`)", text, words);
  const std::string_view meant = nearest_name(name, known);
  if (meant.empty()) {
    const auto recommended =
        formulas.empty() ? std::nullopt : EvaluationRegister::instance().with_role(formulas.front(), Role::Recommended);
    return recommended ? fmt::format("{}; '{}' is recommended (see `cageproof list`)", text, recommended->name())
                       : text + "; see `cageproof list`";
  }
  return fmt::format("{}; did you mean '{}'? (see `cageproof list`)", text, meant);
}

std::string why_no_evaluation(std::string_view formula, std::string_view name) {
  return why_no_evaluation(formula, {formula}, name, {});
}

Evaluation evaluation_named(std::string_view formula, std::string_view name) {
  auto found = EvaluationRegister::instance().find(formula, name);
  if (!found) throw InputError(why_no_evaluation(formula, name));
  return std::move(*found);
}

const Formula& formula_named(std::string_view name) {
  const Formula* found = find_formula(name);
  if (found == nullptr) {
    std::vector<std::string_view> known;
    for (const Formula& formula : catalogue()) known.push_back(formula.name);
    throw unknown_single_name("formula", name, known);
  }
  return *found;
}

}  // namespace cageproof
