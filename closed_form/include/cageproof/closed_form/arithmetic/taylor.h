// SPDX-License-Identifier: MIT
// Truncated Taylor polynomials in a displacement of the point: derivatives of every order at once.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/closed_form/arithmetic/names.h"

#include <algorithm>
#include <array>

namespace cageproof::closed_form {

/// The monomials of three variables up to degree N, by degree; the first four are 1, x, y, z.
template <int N>
struct Monomials {
  static constexpr int count = (N + 1) * (N + 2) * (N + 3) / 6;
  /// The place of the first monomial of degree k.
  static constexpr int first(int k) { return k * (k + 1) * (k + 2) / 6; }
  using Exponents = std::array<int, 3>;

  static constexpr std::array<Exponents, count> make_exponents() {
    std::array<Exponents, count> e{};
    int at = 0;
    for (int k = 0; k <= N; ++k)
      for (int x = k; x >= 0; --x)
        for (int y = k - x; y >= 0; --y) e[at++] = {x, y, k - x - y};
    return e;
  }
  static constexpr std::array<Exponents, count> exponents = make_exponents();
  /// The place of the monomial with these exponents, the same for every N.
  static constexpr int place(const Exponents& e) {
    const int rest = e[1] + e[2];
    return first(e[0] + rest) + rest * (rest + 1) / 2 + e[2];
  }
  static constexpr std::array<std::array<int, 3>, count> make_raised() {
    std::array<std::array<int, 3>, count> r{};
    for (int m = 0; m < count; ++m)
      for (int i = 0; i < 3; ++i) {
        Exponents e = exponents[m];
        ++e[i];
        r[m][i] = place(e);
      }
    return r;
  }
  /// raised[m][i]: the place of monomial m times variable i.
  static constexpr std::array<std::array<int, 3>, count> raised = make_raised();
};

template <class R, int N>
struct Taylor;

/// f(delta) up to degree N; coefficient m belongs to Monomials<N>::exponents[m]. A derivative is its coefficient times
/// the factorials of the exponents.
template <class R, int N>
struct Polynomial {
  using M = Monomials<N>;
  std::array<R, M::count> c{};

  Polynomial& operator+=(const Polynomial& other) {
    for (int m = 0; m < M::count; ++m) c[m] += other.c[m];
    return *this;
  }
  Polynomial& operator*=(const R& factor) {
    for (R& x : c) x *= factor;
    return *this;
  }
  /// Adds factor * f, up to this polynomial's degree.
  template <int F>
  void add(const R& factor, const Taylor<R, F>& f) {
    for (int m = 0; m < Monomials<std::min(F, N)>::count; ++m) c[m] += factor * f.c[m];
  }
  /// Adds (v . delta) * (the part of degree k - 1 of f) to the part of degree k.
  template <class V, int F>
  void add_raised(int k, const V& v, const Taylor<R, F>& f) {
    for (int m = M::first(k - 1); m < M::first(k); ++m)
      for (int i = 0; i < 3; ++i) c[M::raised[m][i]] += v[i] * f.c[m];
  }
  void divide_part(int k, const R& divisor) {
    if constexpr (divides_slowly<R>) {
      const R inverse = R(1) / divisor;
      for (int m = M::first(k); m < M::first(k + 1); ++m) c[m] *= inverse;
    } else {
      for (int m = M::first(k); m < M::first(k + 1); ++m) c[m] /= divisor;
    }
  }
  /// Adds (constant + v . delta) * f, up to this polynomial's degree.
  template <class V, int F>
  void add_linear(const R& constant, const V& v, const Taylor<R, F>& f) {
    add(constant, f);
    for (int k = 1; k <= N && k <= F + 1; ++k) add_raised(k, v, f);
  }
};

/// A Polynomial; scalar types whose polynomials do more specialise this (counted.h).
template <class R, int N>
struct Taylor : Polynomial<R, N> {};

/// The derivative along axis i, one degree less.
template <class R, int N>
Taylor<R, N - 1> derivative(const Taylor<R, N>& f, int i) {
  using M = Monomials<N - 1>;
  Taylor<R, N - 1> g;
  for (int m = 0; m < M::count; ++m) g.c[m] = f.c[M::raised[m][i]] * R(M::exponents[m][i] + 1);
  return g;
}

/// Adds factor * delta^2 * (the part of degree k - 2 of f) to f's part of degree k.
template <class R, int N>
void add_square(Taylor<R, N>& f, int k, const R& factor) {
  using M = Monomials<N>;
  for (int m = M::first(k - 2); m < M::first(k - 1); ++m)
    for (int i = 0; i < 3; ++i) f.c[M::raised[M::raised[m][i]][i]] += factor * f.c[m];
}

/// r^p of a corner at x, up to degree N: k r^2 f_k = (2k - 2 - p)(x.delta) f_{k-1} + (p - k + 2) delta^2 f_{k-2},
/// Gegenbauer's recurrence.
template <int N, class R>
Taylor<R, N> distance_power(const Vec3<R>& x, const R& value, const R& r, int p) {
  Taylor<R, N> f;
  f.c[0] = value;
  const R q = R(1) / (r * r);
  for (int k = 1; k <= N; ++k) {
    const R slope = R(2 * k - 2 - p) * q / R(k);
    f.add_raised(k, std::array<R, 3>{slope * x[0], slope * x[1], slope * x[2]}, f);
    if (k >= 2) add_square(f, k, R(R(p - k + 2) * q / R(k)));
  }
  return f;
}

}  // namespace cageproof::closed_form
