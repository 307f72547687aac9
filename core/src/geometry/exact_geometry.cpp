// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/exact_geometry.h"

#include "exact_signs.h"

#include <algorithm>
#include <limits>

namespace cageproof {
namespace {

using exact::Integer;

// The most bits that integers may have: doubles ask for 2098.
constexpr long kWidest = 16384;

// Vectors over integers and over numbers of 200 digits alike.
template <class T, std::size_t N>
using Tuple = std::array<T, N>;

template <class T, std::size_t N>
Tuple<T, N> minus(const Tuple<T, N>& a, const Tuple<T, N>& b) {
  Tuple<T, N> difference;
  for (std::size_t i = 0; i < N; ++i) difference[i] = a[i] - b[i];
  return difference;
}
template <class T, std::size_t N>
T dot(const Tuple<T, N>& a, const Tuple<T, N>& b) {
  T sum = a[0] * b[0];
  for (std::size_t i = 1; i < N; ++i) sum += a[i] * b[i];
  return sum;
}
template <class T>
Tuple<T, 3> cross(const Tuple<T, 3>& a, const Tuple<T, 3>& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}

// The bits from the highest to the lowest that is set in any of the numbers, which must be finite.
struct Bits {
  long low = std::numeric_limits<long>::max(), high = std::numeric_limits<long>::min();

  long count() const { return high > low ? high - low : 0; }
};
template <class W, std::size_t N>
Bits bits_of(const Tuple<W, N>& numbers) {
  Bits bits;
  for (const W& x : numbers) {
    if (x.is_zero()) continue;
    const long high = mpfr_get_exp(x.data());
    bits.high = std::max(bits.high, high);
    bits.low = std::min(bits.low, high - static_cast<long>(mpfr_min_prec(x.data())));
  }
  return bits;
}

// Up to as many bits, products of four differences are exact in W.
template <class W>
constexpr long kNarrow = W::bits / 4 - 4;

// Numbers as integers in units of 2^low.
template <class W, std::size_t N>
Tuple<Integer, N> integers(const Tuple<W, N>& numbers, long low) {
  Tuple<Integer, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    if (numbers[i].is_zero()) continue;
    mpz_ptr integer = result[i].backend().data();
    const long shift = mpfr_get_z_2exp(integer, numbers[i].data()) - low;
    if (shift >= 0) mpz_mul_2exp(integer, integer, static_cast<mp_bitcnt_t>(shift));
    else mpz_tdiv_q_2exp(integer, integer, static_cast<mp_bitcnt_t>(-shift));  // zeros alone
  }
  return result;
}

// Brings a product of `degree` coordinates back to W's digits.
template <class W>
struct Rounded {
  long exponent;

  W operator()(const Integer& x, int degree) const {
    W result;
    mpfr_set_z_2exp(result.data(), x.backend().data(), degree * exponent, MPFR_RNDN);
    return result;
  }
};
struct AsItIs {
  template <class W>
  const W& operator()(const W& x, int /*degree*/) const {
    return x;
  }
};

template <class T>
Tuple<T, 3> triple(const Tuple<T, 12>& x, std::size_t i) {
  return {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
}

// \param x three corners and the point
template <class T, class Round, class W>
void set(const Tuple<T, 12>& x, const Round& round, ExactTriangleIn<W>& out) {
  const auto vector = [&](const Tuple<T, 3>& v, int degree) {
    return Vec3<W>(round(v[0], degree), round(v[1], degree), round(v[2], degree));
  };
  std::array<Tuple<T, 3>, 3> p, e;
  for (int i = 0; i < 3; ++i) {
    p[i] = minus(triple(x, i), triple(x, 3));
    e[i] = minus(triple(x, (i + 1) % 3), triple(x, i));
    out.p[i] = vector(p[i], 1);
    out.e[i] = vector(e[i], 1);
  }
  const Tuple<T, 3> normal = cross(e[0], e[1]);
  out.normal = vector(normal, 2);
  out.volume = round(dot(normal, p[0]), 3);
  for (int i = 0; i < 3; ++i) {
    const Tuple<T, 3> outward = cross(e[i], normal);
    out.outward[i] = vector(outward, 3);
    out.beside[i] = round(dot(outward, p[i]), 4);
    out.before[i] = round(dot(e[i], p[i]), 2);
    out.after[i] = round(dot(e[i], p[(i + 1) % 3]), 2);
  }
}

// \param x two ends and the point
template <class T, class Round, class W>
void set(const Tuple<T, 6>& x, const Round& round, ExactSegmentIn<W>& out) {
  const auto pair = [&](std::size_t i) { return Tuple<T, 2>{x[2 * i], x[2 * i + 1]}; };
  const auto vector = [&](const Tuple<T, 2>& v) { return std::array<W, 2>{round(v[0], 1), round(v[1], 1)}; };
  const std::array<Tuple<T, 2>, 2> p{minus(pair(0), pair(2)), minus(pair(1), pair(2))};
  const Tuple<T, 2> e = minus(pair(1), pair(0));
  out.p = {vector(p[0]), vector(p[1])};
  out.e = vector(e);
  out.cross = round(T(e[0] * p[0][1] - e[1] * p[0][0]), 2);
  const T before = dot(e, p[0]), after = dot(e, p[1]);
  out.before = round(before, 2);
  out.after = round(after, 2);
  out.middle = round(T(before + after), 2);
}

template <class W, std::size_t N, class Exact>
void set_from(const Tuple<W, N>& numbers, Exact& out) {
  const bool finite = std::ranges::all_of(numbers, [](const W& x) { return isfinite(x); });
  const Bits bits = finite ? bits_of(numbers) : Bits();
  if (bits.count() <= kNarrow<W> || bits.count() > kWidest) set(numbers, AsItIs(), out);
  else set(integers(numbers, bits.low), Rounded<W>{bits.low}, out);
}

}  // namespace

template <class W>
ExactTriangleIn<W>::ExactTriangleIn(const Triangle<W>& t, const Vec3<W>& point) {
  set_from(Tuple<W, 12>{t[0][0], t[0][1], t[0][2], t[1][0], t[1][1], t[1][2], t[2][0], t[2][1], t[2][2], point[0],
                        point[1], point[2]},
           *this);
}

template <class W>
ExactSegmentIn<W>::ExactSegmentIn(const Segment<W>& s, const Vec3<W>& point) {
  set_from(Tuple<W, 6>{s[0][0], s[0][1], s[1][0], s[1][1], point[0], point[1]}, *this);
}

template struct ExactTriangleIn<Mp200>;
template struct ExactTriangleIn<Mp400>;
template struct ExactTriangleIn<Mp2000>;
template struct ExactSegmentIn<Mp200>;
template struct ExactSegmentIn<Mp400>;
template struct ExactSegmentIn<Mp2000>;

}  // namespace cageproof
