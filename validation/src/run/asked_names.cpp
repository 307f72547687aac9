// SPDX-License-Identifier: MIT
#include "run/asked_names.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/regime.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace cageproof::validation {
namespace {

// Whether it computes coordinates that sum one of the formulas: of the user's cage, or of embedded ones.
bool computes_any(const WholeEvaluation& evaluation, const VerifyOptions& options) {
  std::vector<Cage> cages;
  if (options.cage) cages.push_back(*options.cage);
  else cages = {embedded_cage("cube"), embedded_cage("square")};
  for (const Cage& cage : cages)
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (!kind.is_sum() || !accepts(kind, cage) || !evaluation.exists(kind, cage)) continue;
      for (const Formula* formula : formulas_of(kind, cage))
        if (matches(options.formulas, formula->name)) return true;
    }
  return false;
}

// Formulas of elements that the cage has none of would leave it unverified, beside figures that are not the cage's.
void require_formulas_on_cage(const VerifyOptions& options) {
  std::set<std::string_view> summed;
  for (const CoordinateKind& kind : coordinate_kinds())
    if (kind.is_sum() && exists_on(kind, *options.cage))
      for (const Formula* formula : formulas_of(kind, *options.cage)) summed.insert(formula->name);
  if (std::ranges::any_of(summed, [&](std::string_view name) { return matches(options.formulas, name); })) return;
  throw InputError(fmt::format(
      "{}: no coordinates on it sum a formula of '{}', so that nothing of the cage would be verified; ask for one that "
      "they sum ({}), for all ('*'), or leave out --cage",
      options.cage->name(), options.formulas, fmt::join(summed, ", ")));
}

}  // namespace

void require_known_names(const VerifyOptions& options) {
  std::vector<std::string_view> formulas, regime_names{hull_regime, hunted_regime}, all, asked;
  std::map<std::string_view, std::string_view> found_in;
  for (const Formula& formula : catalogue()) {
    formulas.push_back(formula.name);
    for (const std::string_view name : evaluation_names(formula.name)) {
      all.push_back(name);
      found_in.emplace(name, formula.name);
      if (matches(options.formulas, formula.name)) asked.push_back(name);
    }
  }
  for (const Regime& regime : regimes()) regime_names.push_back(regime.name);
  require_known("formula", options.formulas, formulas);
  require_known("regime", options.regimes, regime_names);
  if (options.cage) require_formulas_on_cage(options);
  for (const WholeEvaluation& evaluation : whole_evaluations()) {
    all.push_back(evaluation.name);
    found_in.emplace(evaluation.name, "coordinates of a whole cage");
    if (computes_any(evaluation, options)) asked.push_back(evaluation.name);
  }
  for (const std::string& name : names_in(options.evaluations)) {
    require_known("evaluation", name, all);
    if (std::ranges::any_of(asked, [&](std::string_view one) { return matches(name, one); })) continue;
    const auto elsewhere = std::ranges::find_if(all, [&](std::string_view one) { return matches(name, one); });
    throw InputError(fmt::format("no formula of '{}' has an evaluation '{}': {} has (see `cageproof list '{}'`)",
                                 options.formulas, name, found_in.at(*elsewhere), name));
  }
}

}  // namespace cageproof::validation
