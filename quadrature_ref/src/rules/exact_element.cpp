// SPDX-License-Identifier: MIT
#include "exact_element.h"

#include "exact_vectors.h"

#include <algorithm>
#include <limits>

namespace cageproof::quadrature_ref {
namespace {

using certified::Real, certified::WorkingBits;

// Bits from the highest to the lowest of an input: the widest that is accepted, and the widest for which sums of
// products of four differences are exact in Mp200, which takes no heap memory.
constexpr long widest_spread = 100000, narrow_spread = Mp200::bits / 4 - 5;

template <class T>
using Vector = ExactVector<T>;

template <class T>
T square(const Vector<T>& a) {
  return scalar_product(a, a);
}
// a x (b x c)
template <class T>
Vector<T> double_product(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  const T along_b = scalar_product(a, c), along_c = scalar_product(a, b);
  Vector<T> product;
  for (int i = 0; i < 3; ++i) product[i] = b[i] * along_b - c[i] * along_c;
  return product;
}

// Rounds products of `degree` coordinates to Mp200, in units of 2^exponent.
struct Rounded {
  int exponent;

  static Mp200 in_200_digits(const Mp200& x) { return x; }
  static Mp200 in_200_digits(const Real& x) {
    Mp200 rounded;
    arf_get_mpfr(rounded.data(), arb_midref(x.raw()), MPFR_RNDN);
    return rounded;
  }
  template <class T>
  Mp200 operator()(const T& exact, int degree) const {
    return ldexp(in_200_digits(exact), -degree * exponent);
  }
  template <class T>
  Vec3<Mp200> operator()(const Vector<T>& v, int degree) const {
    return {(*this)(v[0], degree), (*this)(v[1], degree), (*this)(v[2], degree)};
  }
  template <class T>
  Mp200 half(const T& exact, int degree) const {
    return ldexp((*this)(exact, degree), -1);
  }
};

// The bits from the highest to the lowest that is set in any coordinate; the largest number where one is not finite.
long spread_of(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point) {
  long low = std::numeric_limits<long>::max(), high = std::numeric_limits<long>::min();
  bool finite = true;
  const auto see = [&](const Vec3<Mp200>& v) {
    for (const Mp200& x : v) {
      finite = finite && isfinite(x);
      if (!finite || x == 0) continue;
      const long exponent = mpfr_get_exp(x.data());
      high = std::max(high, exponent);
      low = std::min(low, exponent - static_cast<long>(mpfr_min_prec(x.data())));
    }
  };
  see(point);
  for (const Vec3<Mp200>& corner : corners) see(corner);
  if (!finite) return std::numeric_limits<long>::max();
  return high > low ? high - low : 0;
}

// Returns ask<T>(), with numbers T that are exact for this input; nothing where none are.
template <class Ask>
auto exactly(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point, const Ask& ask)
    -> std::optional<decltype(ask.template operator()<Real>())> {
  const long spread = spread_of(corners, point);
  if (spread > widest_spread) return std::nullopt;
  if (spread <= narrow_spread) return ask.template operator()<Mp200>();
  const WorkingBits exact = WorkingBits::exact();
  return ask.template operator()<Real>();
}

}  // namespace

std::optional<ExactTriangle> exact_triangle(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point,
                                            int exponent) {
  return exactly(corners, point, [&]<class T>() {
    const auto x = seen<T, 3>(corners, point);
    const Rounded rounded{exponent};
    const std::array edges{minus(x[1], x[0]), minus(x[2], x[1]), minus(x[0], x[2])};
    const std::array between{vector_product(x[0], x[1]), vector_product(x[1], x[2]), vector_product(x[2], x[0])};
    Vector<T> normal;
    for (int i = 0; i < 3; ++i) normal[i] = between[0][i] + between[1][i] + between[2][i];
    ExactTriangle t;
    t.normal = rounded(normal, 2);
    t.volume = rounded(scalar_product(between[0], x[2]), 3);
    for (int k = 0; k < 3; ++k) {
      t.corners[k] = rounded(x[k], 1);
      t.edges[k] = rounded(edges[k], 1);
      t.outward[k] = rounded(double_product(edges[k], edges[0], edges[1]), 3);
      t.inside[k] = rounded(scalar_product(between[k], normal), 4);
      const T growth = square(x[(k + 1) % 3]) - square(x[k]), length = square(edges[k]);
      t.start[k] = rounded.half(T(growth - length), 2);
      t.end[k] = rounded.half(T(growth + length), 2);
    }
    return t;
  });
}

std::optional<ExactSegment> exact_segment(std::span<const Vec3<Mp200>> ends, const Vec3<Mp200>& point, int exponent) {
  // Third coordinates are ignored.
  const std::array flat{Vec3<Mp200>(ends[0][0], ends[0][1], Mp200(0)), Vec3<Mp200>(ends[1][0], ends[1][1], Mp200(0))};
  const Vec3<Mp200> eta(point[0], point[1], Mp200(0));
  return exactly(flat, eta, [&]<class T>() {
    const auto x = seen<T, 2>(flat, eta);
    const Rounded rounded{exponent};
    const T growth = square(x[1]) - square(x[0]), length = square(minus(x[1], x[0]));
    return ExactSegment{rounded(vector_product(x[0], x[1])[2], 2), rounded.half(T(growth - length), 2),
                        rounded.half(T(growth + length), 2)};
  });
}

std::optional<std::array<Mp200, 4>> exact_volumes(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point,
                                                  int exponent) {
  return exactly(corners, point, [&]<class T>() {
    const auto x = seen<T, 4>(corners, point);
    std::array<Mp200, 4> volumes;
    for (int k = 0; k < 4; ++k)
      volumes[k] = Rounded{exponent}(scalar_product(x[k], vector_product(x[(k + 1) % 4], x[(k + 3) % 4])), 3);
    return volumes;
  });
}

}  // namespace cageproof::quadrature_ref
