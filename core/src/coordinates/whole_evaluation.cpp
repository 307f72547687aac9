// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates/whole_evaluation.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <algorithm>

namespace cageproof {
namespace {

// Made when first asked for, so that evaluations may be added from any file before main.
std::list<WholeEvaluation>& known() {
  static std::list<WholeEvaluation> instance;
  return instance;
}

}  // namespace

const std::list<WholeEvaluation>& whole_evaluations() { return known(); }

RegisterWholeEvaluation::RegisterWholeEvaluation(WholeEvaluation evaluation) { known().push_back(evaluation); }

const WholeEvaluation* find_whole_evaluation(std::string_view name) {
  for (const WholeEvaluation& evaluation : known())
    if (evaluation.name == name) return &evaluation;
  return nullptr;
}

const WholeEvaluation* find_whole_evaluation(std::string_view name, const CoordinateKind& kind, const Cage& cage) {
  for (const WholeEvaluation& evaluation : known())
    if (evaluation.name == name && evaluation.exists(kind, cage)) return &evaluation;
  return nullptr;
}

std::vector<std::string_view> whole_evaluation_names(const CoordinateKind& kind, const Cage& cage) {
  std::vector<std::string_view> names;
  for (const WholeEvaluation& evaluation : known())
    if (evaluation.exists(kind, cage)) names.push_back(evaluation.name);
  return names;
}

void require_evaluation(const CoordinateKind& kind, const Cage& cage, std::string_view name) {
  if (name.empty() || find_whole_evaluation(name, kind, cage) != nullptr) return;
  for (const SummedBlock& block : kind.blocks)
    for (const ElementKind element : element_kinds)
      if (const Formula* formula = find_formula(element, block.kernel))
        if (EvaluationRegister::instance().find(formula->name, name)) return;
  std::vector<std::string_view> formulas;
  for (const Formula* formula : formulas_of(kind, cage)) formulas.push_back(formula->name);
  throw InputError(why_no_evaluation(kind.name, formulas, name, whole_evaluation_names(kind, cage)));
}

int highest_order(const CoordinateKind& kind, const Cage& cage, std::string_view evaluation) {
  int order = 2;
  for (const Formula* formula : formulas_of(kind, cage))
    if (const auto found = EvaluationRegister::instance().find(formula->name, evaluation))
      order = std::min(order, found->max_order());
  return order;
}

std::string quickest_evaluation(const CoordinateKind& kind, const Cage& cage) {
  for (const WholeEvaluation& evaluation : known())
    if (evaluation.role == Role::Batched && evaluation.exists(kind, cage)) return std::string(evaluation.name);
  return {};
}

}  // namespace cageproof
