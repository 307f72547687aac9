// SPDX-License-Identifier: MIT
#include "run/regimes_nowhere.h"

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/validation/regime.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

namespace cageproof::validation {
namespace {

using Texts = std::vector<std::string>;

void add_once(Texts& texts, std::string text) {
  if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
}

// The kinds of elements of the formulas that lack the regime; none where a formula of `*` has it.
Texts elements_without(const Regime& regime, std::string_view formulas) {
  Texts without;
  bool any = false;
  for (const Formula& formula : catalogue()) {
    if (!matches(formulas, formula.name)) continue;
    if (exists_for(regime, formula.element)) any = true;
    else add_once(without, fmt::format("{}s", name_of(formula.element)));
  }
  return any && formulas == "*" ? Texts() : without;
}

}  // namespace

std::string regimes_nowhere(std::string_view formulas, std::string_view asked) {
  std::map<Texts, Texts> regimes_by_elements;
  for (const std::string& name : names_in(asked)) {
    const Regime* const regime = is_glob(name) ? nullptr : find_regime(name);
    if (regime == nullptr) continue;
    if (Texts without = elements_without(*regime, formulas); !without.empty())
      add_once(regimes_by_elements[std::move(without)], name);
  }
  Texts sentences;
  for (const auto& [elements, names] : regimes_by_elements)
    sentences.push_back(fmt::format("{} {} of {}: nothing was asked there.", fmt::join(names, ", "),
                                    names.size() == 1 ? "is no regime" : "are no regimes", fmt::join(elements, ", ")));
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace cageproof::validation
