// SPDX-License-Identifier: MIT
#include "value_names.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/deformation/constrained.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/regime.h"

#include <set>

namespace cageproof::cli {
namespace {

std::vector<std::string> evaluation_names() {
  std::set<std::string> names;
  for (const Formula& formula : catalogue())
    for (const std::string& name : EvaluationRegister::instance().standard(formula.name)) names.insert(name);
  for (const WholeEvaluation& evaluation : whole_evaluations()) names.emplace(evaluation.name);
  return {names.begin(), names.end()};
}

std::vector<std::string> names_of(const auto& rows, auto name) {
  std::vector<std::string> names;
  names.reserve(std::size(rows));
  for (const auto& row : rows) names.emplace_back(name(row));
  return names;
}

}  // namespace

bool is_list_type(std::string_view type) {
  return type == "NAMES" || type == "FORMULAS" || type == "EVALUATIONS" || type == "REGIMES" || type == "CHECKS";
}

bool is_file_type(std::string_view type) { return type == "FILE" || type == "CAGE"; }

bool is_folder_type(std::string_view type) { return type == "FOLDER"; }

std::vector<std::string> names_of_type(std::string_view type) {
  if (is_list_type(type)) type.remove_suffix(1);
  const auto name = [](const auto& row) { return row.name; };
  if (type == "NAME") {
    std::vector<std::string> all;
    for (const std::string_view one : {"FORMULA", "KIND", "METHOD", "REGIME", "CHECK", "CAGE"})
      for (std::string& each : names_of_type(one)) all.push_back(std::move(each));
    return all;
  }
  if (type == "FORMULA") return names_of(catalogue(), name);
  if (type == "EVALUATION") return evaluation_names();
  if (type == "KIND") return names_of(coordinate_kinds(), name);
  if (type == "CHECK") return names_of(validation::checks(), [](const auto& check) { return check->name(); });
  if (type == "REGIME") {
    auto names = names_of(validation::regimes(), name);
    names.emplace_back(validation::hull_regime);
    names.emplace_back(validation::hunted_regime);
    return names;
  }
  if (type == "METHOD") {
    auto names = names_of(deformation::deform_methods(), name);
    for (const auto& method : deformation::constraint_methods()) names.emplace_back(method.name);
    return names;
  }
  if (type == "CAGE") {
    auto names = names_of(embedded_cage_names(), [](std::string_view one) { return one; });
    for (const std::string_view one : extreme_cage_names()) names.emplace_back(one);
    return names;
  }
  return {};
}

}  // namespace cageproof::cli
