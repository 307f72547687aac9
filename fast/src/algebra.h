// SPDX-License-Identifier: MIT
// The closed form that a hybrid falls back on, where double loses too much or has no limit to give.
#pragma once

#include "cageproof/core/evaluation.h"

namespace cageproof::fast {

/// Of the formula whose closed form is F.
template <class F>
struct Algebra {
  static inline std::string_view formula;  ///< set as its hybrid is registered

  /// Puts the closed form's tensors at a point. \param index of the point in the output
  template <Scalar R>
  static void put(std::span<const Vec3<R>> corners, const Vec3<R>& point, int order, std::span<const R> parameters,
                  bool finite_part, std::size_t index, BatchOutput<R> output) {
    static const Evaluation closed_form = evaluation_named(formula, "closed_form");
    for (int o = 0; o <= order; ++o) output.tensors[o] += index * output.stride[o];
    output.statements = nullptr;
    closed_form(Batch<R>{corners, std::span(&point, 1), order, parameters, finite_part}, output);
  }
};

/// The family of a hybrid. \param fill sets its functions in all scalars
inline EvaluationFamily hybrid_family(std::string_view formula, std::function<void(Evaluation&)> fill) {
  return single_family(formula, "hybrid",
                       {.description = "closed form nearby, Gauss points far away: the quickest that keeps its promise",
                        .role = Role::Recommended,
                        .cost = CostClass::Direct},
                       true, std::move(fill));
}

}  // namespace cageproof::fast
