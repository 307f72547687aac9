// SPDX-License-Identifier: MIT
// Exact arithmetic for predicates: rational vectors, and roots of quadratics as p + q sqrt(d), whose signs are
// decidable.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <boost/multiprecision/gmp.hpp>

#include <array>
#include <vector>

namespace cageproof::exact {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using Exact3 = std::array<Rational, 3>;

inline Exact3 from(const Vec3<double>& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }
/// \pre finite
inline Exact3 from(const Vec3<Mp200>& v) {
  Exact3 result;
  for (int i = 0; i < 3; ++i) mpfr_get_q(result[i].backend().data(), v[i].data());
  return result;
}
inline Exact3 minus(const Exact3& a, const Exact3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Rational dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Exact3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
inline int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

inline Mp200 to_mp(const Rational& x) {
  Mp200 result;
  mpfr_set_q(result.data(), x.backend().data(), MPFR_RNDN);
  return result;
}
inline double rounded(const Rational& x) { return static_cast<double>(to_mp(x)); }

/// p + q sqrt(d), d >= 0 the same in all that are added.
struct Surd {
  Rational p, q, d;

  Surd plus(const Surd& s) const { return {p + s.p, q + s.q, d}; }
  Surd plus(const Rational& x) const { return {p + x, q, d}; }
  Surd times(const Rational& x) const { return {p * x, q * x, d}; }
  int sign() const {
    const int of_p = exact::sign(p), of_root = exact::sign(d) * exact::sign(q);
    if (of_p * of_root >= 0) return of_p != 0 ? of_p : of_root;
    return exact::sign(Rational(p * p - q * q * d)) * of_p;
  }
  Mp200 value() const { return to_mp(p) + to_mp(q) * sqrt(to_mp(d)); }
};

/// The real roots of a x^2 + b x + c; none where all three vanish.
inline std::vector<Surd> quadratic_roots(const Rational& a, const Rational& b, const Rational& c) {
  if (a == 0) return b == 0 ? std::vector<Surd>{} : std::vector<Surd>{{-c / b, 0, 0}};
  const Rational d = b * b - 4 * a * c, middle = -b / (2 * a), half = 1 / (2 * a);
  if (d < 0) return {};
  return {{middle, half, d}, {middle, -half, d}};
}

}  // namespace cageproof::exact
