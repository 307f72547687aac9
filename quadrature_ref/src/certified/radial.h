// SPDX-License-Identifier: MIT
// The radial integrals H(k, q) = int_0^1 s^k (s^2 w + d^2)^(-q/2) ds, elementary functions of w, in real and complex
// balls.
#pragma once

#include "ball.h"

#include <array>
#include <vector>

namespace cageproof::quadrature_ref::certified {

/// Powers q of one parity, from lowest_q() to highest_q, and exponents k from 0 to highest_k.
struct RadialRange {
  int highest_q;
  int highest_k;  ///< >= 3
  /// Where the recurrences start: -1 or 2, whose binomial coefficients (-q/2 over j) are at most one.
  int lowest_q() const { return highest_q % 2 == 0 ? 2 : -1; }
  int count() const { return (highest_q - lowest_q()) / 2 + 1; }
  int index(int q) const { return (q - lowest_q()) / 2; }
};

/// H(k, q) for all k and q of a range, analytic in w and r = sqrt(w + d^2) wherever finite.
///
/// d > 0: the integral itself. d = 0: minus the part beyond s = 1 (a part that does not depend on |y| times |y|^(-k-1)
/// left out), r^(-q)/(k+1-q) or, at k+1 = q, r^(-q) log r; for k+1 > q that is the integral too.
template <class Number>
class RadialTable {
 public:
  explicit RadialTable(const RadialRange& range) : range_(range), table_(range.count() * (range.highest_k + 1)) {}

  /// \param r a root of w + d^2, positive on the real line
  void set(const Number& w, const Number& r, const Real& d);
  const Number& operator()(int k, int q) const { return table_[range_.index(q) * (range_.highest_k + 1) + k]; }

 private:
  Number& at(int k, int q) { return table_[range_.index(q) * (range_.highest_k + 1) + k]; }
  void set_without_height(const Number& r);
  void set_from_zero(const Number& w, const Number& ratio, double log2_ratio, const Real& d);
  void set_from_elementary(const Number& w, const Number& r, const Real& d);
  Number series(int k, const Number& ratio, double log2_ratio, const Real& scale) const;
  void set_powers(const Number& r);
  const Number& power(int q) const { return powers_[range_.index(q)]; }  // r^(2-q)

  RadialRange range_;
  std::vector<Number> table_;
  std::vector<Number> powers_;
};

extern template class RadialTable<Real>;
extern template class RadialTable<Complex>;

}  // namespace cageproof::quadrature_ref::certified
