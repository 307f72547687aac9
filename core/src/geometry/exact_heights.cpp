// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/geometry/exact_volume.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace cageproof {
namespace {

// Integers of fixed width, which take no memory. A product of four differences of 113 bits, and the sums of such, fit.
using FixedInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 512, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;
constexpr int kFixedBits = 112;
constexpr int kMantissa = std::numeric_limits<double>::digits;

using FixedVector = std::array<FixedInteger, 3>;

FixedVector difference_of(const FixedVector& a, const FixedVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
FixedInteger dot_of(const FixedVector& a, const FixedVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
FixedVector cross_of(const FixedVector& a, const FixedVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// x 2^exponent, from the highest 63 bits of x. The bits below are too small to count, so this rounds once.
double rounded_times(const FixedInteger& x, int exponent) {
  if (x == 0) return 0;
  const FixedInteger size = abs(x);
  const int drop = std::max(0, static_cast<int>(msb(size)) - 62);
  const auto highest = static_cast<std::int64_t>(FixedInteger(size >> drop));
  const double value = std::ldexp(static_cast<double>(highest), drop + exponent);
  return x < 0 ? -value : value;
}

// The exponent of the lowest bit that is looked at, where all numbers are whole multiples of it within kFixedBits bits.
std::optional<int> lowest_bit(const std::array<Vec3<double>, 4>& points) {
  int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
  for (const Vec3<double>& point : points)
    for (const double x : point) {
      if (x == 0) continue;
      const int exponent = std::ilogb(x) + 1;
      high = std::max(high, exponent);
      low = std::min(low, exponent - kMantissa);
    }
  if (high < low) return 0;  // all numbers are zero
  if (high - low > kFixedBits) return std::nullopt;
  return low;
}

FixedVector fixed_integers(const Vec3<double>& v, int unit) {
  FixedVector result;
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const int exponent = std::ilogb(v[i]) + 1 - kMantissa;
    result[i] = static_cast<std::int64_t>(std::ldexp(v[i], -exponent));
    result[i] <<= exponent - unit;
  }
  return result;
}

int mp_sign(const Mp200& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

ExactHeights wide_heights(const Triangle<double>& t, const Vec3<double>& point, int exponent) {
  const ExactTriangle exact({convert<Mp200>(t[0]), convert<Mp200>(t[1]), convert<Mp200>(t[2])}, convert<Mp200>(point));
  ExactHeights heights{static_cast<double>(ldexp(exact.volume, -3 * exponent)), {}, mp_sign(exact.volume), {}};
  for (int i = 0; i < 3; ++i) {
    heights.beside[i] = static_cast<double>(ldexp(exact.beside[i], -4 * exponent));
    heights.beside_sign[i] = mp_sign(exact.beside[i]);
  }
  return heights;
}

}  // namespace

ExactHeights exact_heights(const Triangle<double>& t, const Vec3<double>& point, int exponent) {
  const std::optional<int> unit = lowest_bit({t[0], t[1], t[2], point});
  if (!unit) return wide_heights(t, point, exponent);
  const FixedVector at = fixed_integers(point, *unit);
  const std::array<FixedVector, 3> corner{fixed_integers(t[0], *unit), fixed_integers(t[1], *unit),
                                          fixed_integers(t[2], *unit)};
  const FixedVector e0 = difference_of(corner[1], corner[0]),
                    normal = cross_of(e0, difference_of(corner[2], corner[1]));
  const int scale = *unit - exponent;
  const FixedInteger volume = dot_of(normal, difference_of(corner[0], at));
  ExactHeights heights{rounded_times(volume, 3 * scale), {}, volume.sign(), {}};
  for (int i = 0; i < 3; ++i) {
    const FixedVector outward = cross_of(difference_of(corner[(i + 1) % 3], corner[i]), normal);
    const FixedInteger beside = dot_of(outward, difference_of(corner[i], at));
    heights.beside[i] = rounded_times(beside, 4 * scale);
    heights.beside_sign[i] = beside.sign();
  }
  return heights;
}

double exact_volume(const Triangle<double>& t, const Vec3<double>& point, int exponent) {
  const std::optional<int> unit = lowest_bit({t[0], t[1], t[2], point});
  if (!unit) return wide_heights(t, point, exponent).volume;
  const FixedVector first = fixed_integers(t[0], *unit), second = fixed_integers(t[1], *unit);
  const FixedVector normal = cross_of(difference_of(second, first), difference_of(fixed_integers(t[2], *unit), second));
  return rounded_times(dot_of(normal, difference_of(first, fixed_integers(point, *unit))), 3 * (*unit - exponent));
}

}  // namespace cageproof
