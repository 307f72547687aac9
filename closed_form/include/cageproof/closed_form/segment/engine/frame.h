// SPDX-License-Identifier: MIT
// A segment seen from a point: the distances, directions and the angle that every closed form in the plane is built
// from.
#pragma once

#include "cageproof/closed_form/segment/engine/scalar.h"
#include "cageproof/core/numbers/vector.h"

#include <array>
#include <cmath>

namespace cageproof {
template <class W>
struct ExactSegmentIn;
}

namespace cageproof::closed_form::segment {

/// x 2^exponent. In multiprecision, whose exponents do not overflow, frames have the exponent zero.
template <Scalar R>
R shifted(const R& x, int exponent) {
  if constexpr (is_wide<R>) return x;
  else if constexpr (is_tracked<R>) return {std::ldexp(x.value, exponent), std::ldexp(x.error, exponent)};
  else return std::ldexp(x, exponent);
}

/// A number of the plane, re along the segment and im along its outward normal.
template <class R>
struct Complex {
  R re, im;
  friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator*(const R& a, const Complex& b) { return {a * b.re, a * b.im}; }
};

/// Geometry in units of 2^exponent, just above the largest difference of coordinates, so that no power of a length
/// overflows.
///
/// z_i = s_i - i h is end i as the point sees it, along the segment and its normal; closed forms are real and imaginary
/// parts of log(z_1/z_0) = log_ratio + i angle and of powers of the z_i. The nearer end's distance may be far below the
/// unit, so numbers that depend on it have a scale of their own. On the segment (h = 0) every quantity is the limit
/// from inside, where h -> 0 from below; at an end that limit is taken along the normal.
template <Scalar R>
struct Frame {
  using Number = R;

  Eigen::Matrix<R, 2, 1> u;  ///< unit direction from end 0 to end 1
  Eigen::Matrix<R, 2, 1> n;  ///< outward unit normal, to the right of u
  std::array<int, 2> way;    ///< the signs of u, exactly: infinities along the segment need them where u underflows
  R length;
  R h;                 ///< signed distance of the point from the line, positive outside
  std::array<R, 2> s;  ///< arc length of the ends from the nearest point of the line, s[1] - s[0] = length
  R sum;               ///< s[0] + s[1], which is small over the segment's middle: r[1]^2 - r[0]^2 = length sum
  std::array<R, 2> r;  ///< distances of the ends
  R log_ratio;         ///< log(r[1]/r[0]); infinite at an end
  R angle;             ///< under which the segment is seen, with the sign of h: in [-pi, pi]
  std::array<R, 2> log_r;
  int exponent;

  int near_end;     ///< the nearer of the ends
  bool at_end;      ///< the point is that end
  Complex<R> near;  ///< z of the nearer end over its modulus
  R near_mantissa;  ///< that modulus is near_mantissa 2^near_exponent in the caller's units
  int near_exponent;

  /// Empty, for functions that fill it in.
  Frame() = default;
  /// From exact differences: exact_frame.h.
  Frame(const Segment<R>& segment, const Vec3<R>& eta);
  /// From exact products, each rounded once to a wide type, tracked or not: exact_frame.h.
  template <class W>
  explicit Frame(const ExactSegmentIn<W>& x);
  /// The frame in double with bounds of its roundings: tracked_frame.h. \pre no number has underflown
  template <std::same_as<double> D>
  explicit Frame(const Frame<D>& seen) requires is_tracked<R>;

  const R& far_s() const { return s[1 - near_end]; }
  const R& far_r() const { return r[1 - near_end]; }
  /// Whether the point is more than the segment's length away from it.
  bool is_far() const { return r[near_end] > length; }
  /// Whether both ends are about equally far, so that differences between functions of their distances cancel.
  bool are_alike() const {
    const R square = length * sum;
    return 2 * (square < 0 ? R(-square) : square) < r[near_end] * r[near_end];
  }
  /// Sets the angle and the logarithm of the distances' ratio from the other members.
  void set_angle_and_ratio();
  /// 1/z_i, in units of the frame. \pre not at that end
  Complex<R> scaled_inverse(int i) const {
    if (i != near_end) return {s[i] / r[i] / r[i], h / r[i] / r[i]};
    const int up = exponent - near_exponent;
    return {shifted<R>(near.re / near_mantissa, up), shifted<R>(-near.im / near_mantissa, up)};
  }
  /// 1/z_i, in the caller's units. \pre not at that end
  Complex<R> inverse(int i) const {
    const Complex<R> scaled = scaled_inverse(i);
    return {shifted<R>(scaled.re, -exponent), shifted<R>(scaled.im, -exponent)};
  }

 private:
  void set(const Segment<R>& given, const Vec3<R>& eta) requires std::same_as<R, double>;
};

template <Scalar R>
void Frame<R>::set_angle_and_ratio() {
  using std::atan2, std::log1p;
  const R sine = -near.im, from_inside = at_end ? R(0) : R(h * sine);
  angle = atan2(R(length * sine), R(from_inside + far_s() * near.re));
  if (is_far() || are_alike()) {
    const R sign(near_end == 0 ? 1 : -1), q = r[near_end];
    log_ratio = sign * log1p(R(sign * length * sum / (q * q))) / R(2);
  } else {
    log_ratio = log_r[1] - log_r[0];
  }
}

}  // namespace cageproof::closed_form::segment
