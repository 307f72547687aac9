// SPDX-License-Identifier: MIT
// Forward differentiation to second order: a number that carries its derivatives by three variables.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cageproof {

/// A value with its gradient and Hessian by three variables. Values are computed by the same operations as plain
/// numbers, to the last bit. Derivatives that do not exist (of sqrt at zero) are not finite.
template <Scalar R>
struct SecondOrder {
  R value = R(0);
  std::array<R, 3> gradient{};
  std::array<R, 6> hessian{};  ///< xx, xy, xz, yy, yz, zz

  SecondOrder() = default;
  /// A constant.
  explicit SecondOrder(const R& constant) : value(constant) {}

  /// Where the derivative by variables i and j stands in `hessian`.
  static constexpr std::size_t entry(std::size_t i, std::size_t j) {
    constexpr std::array<std::array<std::size_t, 3>, 3> entries{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
    return entries[i][j];
  }
  /// Variable number i.
  static SecondOrder variable(const R& x, std::size_t i) {
    SecondOrder r(x);
    r.gradient[i] = R(1);
    return r;
  }
  /// A value whose derivatives are not known, or do not exist: they are NaN.
  static SecondOrder without_derivatives(const R& x) {
    SecondOrder r(x);
    r.gradient.fill(std::numeric_limits<R>::quiet_NaN());
    r.hessian.fill(std::numeric_limits<R>::quiet_NaN());
    return r;
  }

  SecondOrder& operator+=(const SecondOrder& b) {
    value += b.value;
    for (std::size_t i = 0; i < 3; ++i) gradient[i] += b.gradient[i];
    for (std::size_t i = 0; i < 6; ++i) hessian[i] += b.hessian[i];
    return *this;
  }
  SecondOrder& operator-=(const SecondOrder& b) {
    value -= b.value;
    for (std::size_t i = 0; i < 3; ++i) gradient[i] -= b.gradient[i];
    for (std::size_t i = 0; i < 6; ++i) hessian[i] -= b.hessian[i];
    return *this;
  }
  SecondOrder& operator*=(const SecondOrder& b) { return *this = *this * b; }
  SecondOrder& operator/=(const SecondOrder& b) { return *this = *this / b; }

  SecondOrder operator-() const {
    SecondOrder r;
    r.value = -value;
    for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = -gradient[i];
    for (std::size_t i = 0; i < 6; ++i) r.hessian[i] = -hessian[i];
    return r;
  }
  friend SecondOrder operator+(SecondOrder a, const SecondOrder& b) { return a += b; }
  friend SecondOrder operator-(SecondOrder a, const SecondOrder& b) { return a -= b; }
  friend SecondOrder operator*(const SecondOrder& a, const SecondOrder& b) {
    SecondOrder r;
    r.value = a.value * b.value;
    for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = a.value * b.gradient[i] + a.gradient[i] * b.value;
    for (std::size_t i = 0, k = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j, ++k)
        r.hessian[k] = a.value * b.hessian[k] + a.hessian[k] * b.value + a.gradient[i] * b.gradient[j] +
                       a.gradient[j] * b.gradient[i];
    return r;
  }
  friend SecondOrder operator/(const SecondOrder& a, const SecondOrder& b) {
    // a = r b, differentiated twice.
    SecondOrder r;
    r.value = a.value / b.value;
    for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = (a.gradient[i] - r.value * b.gradient[i]) / b.value;
    for (std::size_t i = 0, k = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j, ++k)
        r.hessian[k] =
            (a.hessian[k] - r.value * b.hessian[k] - r.gradient[i] * b.gradient[j] - r.gradient[j] * b.gradient[i]) /
            b.value;
    return r;
  }
};

/// f(x) from f and its first two derivatives at x.
template <Scalar R>
SecondOrder<R> composed(const R& f, const R& df, const R& ddf, const SecondOrder<R>& x) {
  SecondOrder<R> r(f);
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = df * x.gradient[i];
  for (std::size_t i = 0, k = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j, ++k) r.hessian[k] = df * x.hessian[k] + ddf * x.gradient[i] * x.gradient[j];
  return r;
}

/// f(x, y) from f and its partial derivatives at (x, y).
template <Scalar R>
struct Partials {
  R f, x, y, xx, xy, yy;
};
template <Scalar R>
SecondOrder<R> composed(const Partials<R>& p, const SecondOrder<R>& x, const SecondOrder<R>& y) {
  SecondOrder<R> r(p.f);
  for (std::size_t i = 0; i < 3; ++i) r.gradient[i] = p.x * x.gradient[i] + p.y * y.gradient[i];
  for (std::size_t i = 0, k = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j, ++k)
      r.hessian[k] = p.x * x.hessian[k] + p.y * y.hessian[k] + p.xx * x.gradient[i] * x.gradient[j] +
                     p.yy * y.gradient[i] * y.gradient[j] +
                     p.xy * (x.gradient[i] * y.gradient[j] + x.gradient[j] * y.gradient[i]);
  return r;
}

template <Scalar R>
SecondOrder<R> sqrt(const SecondOrder<R>& x) {
  using std::sqrt;
  const R root = sqrt(x.value);
  const R df = 1 / (2 * root);
  return composed<R>(root, df, R(-df / (2 * x.value)), x);
}

/// The value of a number, with derivatives or without.
template <Scalar R>
const R& value_of(const R& x) {
  return x;
}
template <Scalar R>
const R& value_of(const SecondOrder<R>& x) {
  return x.value;
}

/// The scalar that a number is made of.
template <class N>
struct ScalarOf {
  using type = N;
};
template <Scalar R>
struct ScalarOf<SecondOrder<R>> {
  using type = R;
};
template <class N>
using scalar_of = typename ScalarOf<N>::type;

}  // namespace cageproof
