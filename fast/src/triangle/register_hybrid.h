// SPDX-License-Identifier: MIT
// Enters a triangle formula's hybrid into the register.
#pragma once

#include "../explain/triangle.h"
#include "../register_hybrid.h"

#include "cageproof/closed_form/triangle/engine/shared_instances.h"
#include "cageproof/fast/triangle/hybrid.h"

namespace cageproof::fast::triangle {

struct Engine {
  using Corners = Triangle<double>;
  template <int O>
  using Seen = HybridMoments<O>;

  template <class F, int O>
  static auto jet(HybridMoments<O>& seen, std::span<const double> parameters, bool /*finite_part*/) {
    return hybrid<F, O>(seen, parameters).jet;
  }
  template <class F, int O>
  static closed_form::Explanation explain(const Query<double>& query, std::span<const double> values,
                                          std::optional<std::size_t> entry) {
    return explain_order<F, O>(query, values, entry);
  }
};

/// `const RegisterHybrid<F> register_<kernel>{"triangle.<kernel>"};` at namespace scope.
template <class F>
using RegisterHybrid = RegisterHybridOn<Engine, F>;

}  // namespace cageproof::fast::triangle
