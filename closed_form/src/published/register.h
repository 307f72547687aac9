// SPDX-License-Identifier: MIT
// Turns a printed form of [T24] into entries of the register: as it is after the errata, and with a misprint kept.
#pragma once

#include "../register.h"
#include "instances.h"

namespace cageproof::closed_form::published {

CAGEPROOF_PUBLISHED_SCALARS(extern)

/// `form(setting, query, misprint)` is a Jet for every scalar. `published` is of the standard set, what keeps a misprint not.
template <class Form>
EvaluationFamily published_family(std::string formula, Misprint misprint, std::string description, Form form,
                                  int max_order = 2) {
  const auto print = [form, misprint]<Scalar R>(const Triangle<R>& t, const Query<R>& q) {
    return form(Setting<R>(t, q.point), q, misprint);
  };
  EvaluationFamily family =
      triangle_family(std::move(formula), std::string(evaluation_name(misprint)), std::move(description), print, max_order);
  if (misprint != Misprint::None) family.standard.clear();
  return family;
}

}  // namespace cageproof::closed_form::published
