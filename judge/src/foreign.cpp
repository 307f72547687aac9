// SPDX-License-Identifier: MIT
#include "cageproof/judge/foreign.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

namespace cageproof::judge {

void add_foreign(std::string_view formula, std::string_view name, int max_order,
                 std::function<void(Evaluation&)> fill) {
  formula_named(formula);
  if (EvaluationRegister::instance().find(formula, name))
    throw InputError(fmt::format("{} has an evaluation named {} already: take another name", formula, name));
  EvaluationRegister::instance().add(
      single_family(formula, name, {.description = "judged here", .role = Role::Foreign, .max_order = max_order}, true,
                    std::move(fill)));
}

}  // namespace cageproof::judge
