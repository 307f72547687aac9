// SPDX-License-Identifier: MIT
// Enters a triangle formula's evaluations into the register.
#pragma once

#include "../../register_form.h"
#include "cageproof/closed_form/triangle/engine/plain.h"
#include "cageproof/closed_form/triangle/engine/shared_instances.h"
#include "explain.h"

namespace cageproof::closed_form::triangle {

struct Engine {
  static constexpr std::string_view kAlgebra = "edge form, in as many digits as its promise takes";
  template <class R>
  using Corners = Triangle<R>;
  template <Scalar R, int O>
  using Seen = std::conditional_t<is_multiprecision<R>, WideMoments<O>, PointMoments<O>>;
  using StatedIn = Scalars<double>;

  template <class F, int O, class R>
  static auto plain(const Triangle<R>& t, const Vec3<R>& eta, std::span<const R> parameters, bool finite_part) {
    return triangle::plain<F, O, R>(t, eta, parameters, finite_part);
  }
  template <class F, int O>
  static Explanation explain(const Query<double>& query, std::span<const double> values,
                             std::optional<std::size_t> entry) {
    return explain_order<F, O>(query, values, entry);
  }
};

/// `const RegisterForm<F> register_<kernel>{"triangle.<kernel>"};` at namespace scope.
template <class F>
using RegisterForm = RegisterFormOn<Engine, F>;

}  // namespace cageproof::closed_form::triangle
