// SPDX-License-Identifier: MIT
// Enters a segment formula's evaluations into the register.
#pragma once

#include "../../register_form.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/engine/plain.h"
#include "explain.h"

namespace cageproof::closed_form::segment {

struct Engine {
  static constexpr std::string_view kAlgebra = "logarithms and an angle, in as many digits as its promise takes";
  template <class R>
  using Corners = Segment<R>;
  template <cageproof::Scalar R, int O>
  using Seen = std::conditional_t<is_multiprecision<R>, WideFrames, PointFrames>;
  using StatedIn = Scalars<float, double>;

  template <class F, int O, class R>
  static auto plain(const Segment<R>& s, const Vec3<R>& eta, std::span<const R> parameters, bool finite_part) {
    return segment::plain<F, O, R>(s, eta, parameters, finite_part);
  }
  template <class F, int O>
  static Explanation explain(const Query<double>& query, std::span<const double> values,
                             std::optional<std::size_t> entry) {
    return explain_order<F, O>(query, values, entry);
  }
};

/// `const RegisterForm<F> register_<kernel>{"segment.<kernel>"};` at namespace scope.
template <class F>
using RegisterForm = RegisterFormOn<Engine, F>;

}  // namespace cageproof::closed_form::segment
