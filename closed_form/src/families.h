// SPDX-License-Identifier: MIT
// The families of evaluations that every closed form has.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"

#include <utility>

namespace cageproof::closed_form {

/// The family `closed_form`, with Role::ClosedForm. \param fill sets its functions in all scalars
inline EvaluationFamily closed_form_family(std::string_view formula, std::string_view description,
                                           std::function<void(Evaluation&)> fill) {
  return single_family(formula, "closed_form",
                       {.description = std::string(description), .role = Role::ClosedForm, .cost = CostClass::Direct},
                       true, std::move(fill));
}

/// The family `accurate`, which states a bound of its own error. \param fill sets its functions in the scalars that it
/// has
inline EvaluationFamily accurate_family(std::string_view formula, std::function<void(Evaluation&)> fill) {
  return single_family(formula, "accurate",
                       {.description = "closed form that bounds its own error, in as many digits as that takes",
                        .role = Role::Stated,
                        .cost = CostClass::Direct,
                        .states_error = true},
                       true, std::move(fill));
}

/// The family `plain`. \param fill sets its functions in float and double
inline EvaluationFamily plain_family(std::string_view formula, std::function<void(Evaluation&)> fill) {
  return single_family(formula, "plain",
                       {.description = "the closed form in the scalar's own arithmetic, nothing wider",
                        .role = Role::Plain,
                        .cost = CostClass::Direct},
                       true, std::move(fill));
}

}  // namespace cageproof::closed_form
