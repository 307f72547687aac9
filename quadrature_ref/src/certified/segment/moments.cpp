// SPDX-License-Identifier: MIT
#include "moments.h"

#include <stdexcept>

namespace cageproof::quadrature_ref::certified {
namespace {

Real to_the(const Real& x, int exponent) {
  Real y;
  arb_pow_ui(y.raw(), x.raw(), static_cast<ulong>(exponent), working_bits);
  return y;
}

}  // namespace

Real SegmentMoments::distance_power(int end, int exponent) const {
  const int size = std::abs(exponent);
  Real y = to_the(frame_.squares[end], size / 2);
  if (size % 2 != 0) y = y * sqrt(frame_.squares[end]);
  return exponent < 0 ? Real(1) / y : y;
}

Real SegmentMoments::between_ends(int m, int q) const {
  const auto at = [&](int end) { return to_the(frame_.s[end], m) * distance_power(end, -q); };
  return at(1) - at(0);
}

// d(s r^-q) = ((1 - q) r^-q + q d^2 r^(-q-2)) ds, d(r^(2-q)) = (2 - q) s r^-q ds, d(s^(m-1) r^(2-q)) = ((m + 1 - q) s^m
// + (m - 1) d^2 s^(m-2)) r^-q ds, and s^2 = r^2 - d^2.
Real SegmentMoments::power_off_line(int m, int q) const {
  const Real square = frame_.height * frame_.height;
  if (m == 0) {
    if (q == 0) return frame_.length;
    if (q == 1) {
      Real distance;
      arb_abs(distance.raw(), frame_.height.raw());
      return asinh(frame_.s[1] / distance) - asinh(frame_.s[0] / distance);
    }
    if (q == 2) return frame_.angle / frame_.height;
    if (q > 2) return (between_ends(1, q - 2) + power(0, q - 2) * (q - 3)) / (square * (q - 2));
    return (between_ends(1, q) - power(0, q + 2) * square * q) / (1 - q);
  }
  if (m == 1) return q == 2 ? frame_.log_ratio : between_ends(0, q - 2) / (2 - q);
  if (q >= 2) return power(m - 2, q - 2) - power(m - 2, q) * square;
  return (between_ends(m - 1, q - 2) - power(m - 2, q) * square * (m - 1)) / (m + 1 - q);
}

// |s|^-q is s^-q, for odd q times the sign of s: int s^p = s^(p+1)/(p+1), int |s| s^(p-1) = |s| s^p/(p+1).
Real SegmentMoments::power_on_line(int m, int q) const {
  const int p = m - q;
  if (p == -1) return q % 2 == 0 ? frame_.log_ratio : frame_.log_ratio * frame_.side;
  const auto at = [&](int end) {
    Real s = frame_.s[end];
    if (q % 2 != 0) arb_abs(s.raw(), s.raw());
    const Real rest = to_the(frame_.s[end], std::abs(p));
    return p < 0 ? s / rest : s * rest;
  };
  return (at(1) - at(0)) / (p + 1);
}

const Real& SegmentMoments::power(int m, int q) const {
  const auto known = powers_.find({m, q});
  if (known != powers_.end()) return known->second;
  return powers_[{m, q}] = frame_.on_line ? power_on_line(m, q) : power_off_line(m, q);
}

// d(s^(m+1) ln r) = ((m + 1) s^m ln r + s^(m+2) r^-2) ds, and r^2 = s^2 + d^2.
const Real& SegmentMoments::logarithm(int m, int q) const {
  const auto known = logarithms_.find({m, q});
  if (known != logarithms_.end()) return known->second;
  if (q > 0 || q % 2 != 0) throw std::logic_error("a kernel's logarithm stands over a power of the distance");
  if (q < 0)
    return logarithms_[{m, q}] = logarithm(m + 2, q + 2) + logarithm(m, q + 2) * (frame_.height * frame_.height);
  Real sum = -power(m + 2, 2);
  for (int end = 0; end < 2; ++end)
    if (!frame_.at_end[end]) sum += to_the(frame_.s[end], m + 1) * frame_.logarithms[end] * (end == 0 ? -1 : 1);
  return logarithms_[{m, q}] = sum / (m + 1);
}

Real SegmentMoments::moment(const Monomial& term, std::optional<int> corner) const {
  const auto plain = [&](int m) { return term.logarithms == 0 ? power(m, term.q) : logarithm(m, term.q); };
  const int m = term.powers[0];
  if (!corner) return plain(m);
  // Hat functions: (s1 - s)/length and (s - s0)/length.
  const Real hat = plain(m + 1) - plain(m) * frame_.s[1 - *corner];
  return hat / frame_.length * (*corner == 0 ? -1 : 1);
}

}  // namespace cageproof::quadrature_ref::certified
