// SPDX-License-Identifier: MIT
// Enters a segment formula's hybrid into the register.
#pragma once

#include "../explain/segment.h"
#include "../register_hybrid.h"
#include "hybrid.h"

namespace cageproof::fast::segment {

struct Engine {
  using Corners = Segment<double>;
  template <int O>
  using Seen = SeenSegment;

  template <class F, int O>
  static auto jet(const SeenSegment& seen, std::span<const double> parameters, bool finite_part) {
    return hybrid<F, O>(seen, parameters, finite_part);
  }
  template <class F, int O>
  static closed_form::Explanation explain(const Query<double>& query, std::span<const double> values,
                                          std::optional<std::size_t> entry) {
    return explain_order<F, O>(query, values, entry);
  }
};

/// `const RegisterHybrid<F> register_<kernel>{"segment.<kernel>"};` at namespace scope.
template <class F>
using RegisterHybrid = RegisterHybridOn<Engine, F>;

}  // namespace cageproof::fast::segment
