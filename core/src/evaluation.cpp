// SPDX-License-Identifier: MIT
#include "cageproof/core/evaluation.h"

#include <algorithm>

namespace cageproof {

EvaluationRegister& EvaluationRegister::instance() {
  static EvaluationRegister instance;
  return instance;
}

void EvaluationRegister::add(EvaluationFamily family) { families_.push_back(std::move(family)); }

std::vector<const EvaluationFamily*> EvaluationRegister::families(std::string_view formula) const {
  std::vector<const EvaluationFamily*> found;
  for (const EvaluationFamily& family : families_)
    if (family.formula == formula) found.push_back(&family);
  std::ranges::sort(found, {}, [](const EvaluationFamily* f) { return f->pattern; });
  return found;
}

std::optional<Evaluation> EvaluationRegister::find(std::string_view formula, std::string_view name) const {
  for (const EvaluationFamily* family : families(formula))
    if (auto evaluation = family->make(name)) return evaluation;
  return std::nullopt;
}

std::vector<std::string> EvaluationRegister::standard(std::string_view formula) const {
  std::vector<std::string> names;
  for (const EvaluationFamily* family : families(formula))
    names.insert(names.end(), family->standard.begin(), family->standard.end());
  std::ranges::sort(names, {}, [](const std::string& name) { return std::pair(name != "closed_form", name); });
  return names;
}

}  // namespace cageproof
