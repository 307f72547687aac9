// SPDX-License-Identifier: MIT
// The family of the plain evaluation, which every closed form has.
#pragma once

#include "cageproof/core/evaluation.h"

#include <utility>

namespace cageproof::closed_form {

/// \param fill sets its functions in float and double
inline EvaluationFamily plain_family(std::string_view formula, std::function<void(Evaluation&)> fill) {
  return single_family(formula, "plain",
                       {.description = "the closed form in the scalar's own arithmetic, nothing wider",
                        .role = Role::Plain,
                        .cost = CostClass::Direct},
                       true, std::move(fill));
}

}  // namespace cageproof::closed_form
