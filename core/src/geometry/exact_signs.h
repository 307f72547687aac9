// SPDX-License-Identifier: MIT
// Exact arithmetic for predicates: rational vectors, and roots of quadratics as p + q sqrt(d), whose signs are
// decidable.
#pragma once

#include "cageproof/core/numbers/linear.h"

#ifdef CAGEPROOF_NO_MPFR
#include "cageproof/core/numbers/mp_number.h"

#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif

#include <algorithm>
#include <array>
#include <vector>

namespace cageproof::exact {

#ifdef CAGEPROOF_NO_MPFR
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
#else
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
#endif
using Exact3 = std::array<Rational, 3>;

/// A number as integer * 2^exponent.
struct Scaled {
  Integer integer;
  long exponent = 0;
};

#ifdef CAGEPROOF_NO_MPFR

/// \pre finite
template <class W>
Scaled scaled(const W& x) {
  if (x.is_zero()) return {};
  const auto& parts = number_of(x).backend();
  Integer size(boost::multiprecision::number<std::remove_cvref_t<decltype(parts.bits())>>(parts.bits()));
  // Bits below the lowest that is set would make quotients long.
  const auto zeros = static_cast<long>(lsb(size));
  size >>= zeros;
  return {parts.sign() ? Integer(-size) : size, static_cast<long>(x.exponent()) - static_cast<long>(W::bits) + zeros};
}

/// x 2^exponent, rounded to nearest, ties to even. \param more whether x is a little larger in size
template <class W>
W nearest(const Integer& x, long exponent, bool more = false) {
  Integer size = abs(x);
  if (size == 0) return 0;
  const long drop = static_cast<long>(msb(size)) + 1 - static_cast<long>(W::bits);
  if (drop > 0) {
    const Integer half = Integer(1) << (drop - 1), mask = (half << 1) - 1, below = size & mask;
    size >>= drop;
    if (below > half || (below == half && (more || bit_test(size, 0)))) ++size;
    exponent += drop;
  }
  // No more than W's bits, or a power of two: this is exact.
  W result = 0;
  const Integer low = (Integer(1) << 53) - 1;
  for (long shift = 0; size != 0; shift += 53) {
    result += ldexp(W(static_cast<double>(Integer(size & low))), static_cast<int>(shift + exponent));
    size >>= 53;
  }
  return x < 0 ? -result : result;
}

/// above / below, rounded to nearest. \pre below > 0
template <class W>
W nearest_ratio(const Integer& above, const Integer& below) {
  if (above == 0) return 0;
  const Integer size = abs(above);
  // A quotient of two bits more than there is room for, and whether anything is left.
  const long shift = static_cast<long>(W::bits) + 2 + static_cast<long>(msb(below)) - static_cast<long>(msb(size));
  Integer quotient, rest;
  if (shift >= 0) divide_qr(Integer(size << shift), below, quotient, rest);
  else divide_qr(size, Integer(below << -shift), quotient, rest);
  return nearest<W>(above < 0 ? Integer(-quotient) : quotient, -shift, rest != 0);
}

#else

/// \pre finite
template <class W>
Scaled scaled(const W& x) {
  Scaled result;
  if (x.is_zero()) return result;
  mpz_ptr integer = result.integer.backend().data();
  result.exponent = mpfr_get_z_2exp(integer, x.data());
  return result;
}

/// x 2^exponent, rounded to nearest.
template <class W>
W nearest(const Integer& x, long exponent) {
  W result;
  mpfr_set_z_2exp(result.data(), x.backend().data(), exponent, MPFR_RNDN);
  return result;
}

#endif

inline Exact3 from(const Vec3<double>& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }
/// \pre finite
inline Rational from(const Mp200& x) {
#ifdef CAGEPROOF_NO_MPFR
  const auto [integer, exponent] = scaled(x);
  return exponent >= 0 ? Rational(integer << exponent) : Rational(integer, Integer(1) << -exponent);
#else
  Rational result;
  mpfr_get_q(result.backend().data(), x.data());
  return result;
#endif
}
/// \pre finite
inline Exact3 from(const Vec3<Mp200>& v) { return {from(v[0]), from(v[1]), from(v[2])}; }
inline Exact3 minus(const Exact3& a, const Exact3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Rational dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Exact3& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
inline int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

inline Mp200 to_mp(const Rational& x) {
#ifdef CAGEPROOF_NO_MPFR
  return nearest_ratio<Mp200>(numerator(x), denominator(x));
#else
  Mp200 result;
  mpfr_set_q(result.data(), x.backend().data(), MPFR_RNDN);
  return result;
#endif
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
