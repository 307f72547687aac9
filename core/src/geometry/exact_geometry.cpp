// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/exact_geometry.h"

#include "exact_signs.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cageproof {
namespace {

using exact::Integer;

// The most bits that integers may have: doubles ask for 2098.
constexpr long kWidest = 16384;

// The least number of bits that hold x. \pre finite, not zero
template <class W>
long significant_bits(const W& x) {
#ifdef CAGEPROOF_NO_MPFR
  return static_cast<long>(msb(abs(exact::scaled(x).integer))) + 1;
#else
  return static_cast<long>(mpfr_min_prec(x.data()));
#endif
}

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
    const auto high = static_cast<long>(x.exponent());
    bits.high = std::max(bits.high, high);
    bits.low = std::min(bits.low, high - significant_bits(x));
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
    exact::Scaled scaled = exact::scaled(numbers[i]);
    const long shift = scaled.exponent - low;
    if (shift >= 0) scaled.integer <<= shift;
    else scaled.integer >>= -shift;  // zeros alone
    result[i] = std::move(scaled.integer);
  }
  return result;
}

// Brings a product of `degree` coordinates back to W's digits.
template <class W>
struct Rounded {
  long exponent;

  W operator()(const Integer& x, int degree) const { return exact::nearest<W>(x, degree * exponent); }
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
