// SPDX-License-Identifier: MIT
#include "radial.h"

namespace cageproof::quadrature_ref::certified {
namespace {

// With Q = s^2 w + d^2, d/ds (s^(k-1) Q^(1-q/2)) = (k-1) s^(k-2) Q^(1-q/2) + (2-q) w s^k Q^(-q/2), over [0, 1]:
//   r^(2-q) = (k+1-q) w H(k, q) + (k-1) d^2 H(k-2, q)          k >= 2      (1)
//   r^(2-q) - d^(2-q) = (2-q) w H(1, q)                                    (2)
//   r^(2-q) = (2-q) w H(k, q) + (k-1) H(k-2, q-2)              k >= 2      (3)
//   (q-2) d^2 H(k, q) = r^(2-q) + (q-3-k) H(k, q-2)            from (3) at k+2 and H(k, q-2) = w H(k+2, q) + d^2 H(k,
//   q)   (4)

// Upper bounds of |w|/d^2 below which the series is used: it converges below one. On real numbers speed decides.
double series_limit(const Real&) { return -2; }        // 1/4
double series_limit(const Complex&) { return -0.15; }  // 0.9

double log2_size(const Real& a) { return a.log2_size(); }
double log2_size(const Complex& a) { return upper_bound(a).log2_size(); }

Real widened(const Real& x, const Real& radius) { return x.widened(radius); }
Complex widened(const Complex& x, const Real& radius) {
  Complex y = x;
  acb_add_error_arb(y.raw(), radius.raw());
  return y;
}

bool strictly_below_one(const Real& bound) { return arb_lt(bound.raw(), Real(1).raw()) != 0; }

}  // namespace

template <class Number>
void RadialTable<Number>::set_powers(const Number& r) {
  const int lowest = range_.lowest_q();
  powers_.resize(range_.count());
  const Number inverse_square = Number(1) / (r * r);
  powers_[0] = lowest == 2 ? Number(1) : r * r * r;
  for (int i = 1; i < range_.count(); ++i) powers_[i] = powers_[i - 1] * inverse_square;
}

template <class Number>
void RadialTable<Number>::set(const Number& w, const Number& r, const Real& d) {
  set_powers(r);
  if (d.is_zero()) return set_without_height(r);
  const Number ratio = w / (d * d);
  const double log2_ratio = log2_size(ratio);
  if (log2_ratio < series_limit(ratio)) set_from_zero(w, ratio, log2_ratio, d);
  else set_from_elementary(w, r, d);
}

template <class Number>
void RadialTable<Number>::set_without_height(const Number& r) {
  const Number logarithm = log(r), inverse_square = Number(1) / (r * r);
  for (int q = range_.lowest_q(); q <= range_.highest_q; q += 2) {
    const Number p = power(q) * inverse_square;
    for (int k = 0; k <= range_.highest_k; ++k) at(k, q) = k + 1 == q ? p * logarithm : p / (k + 1 - q);
  }
}

// d^(-q) sum_j binomial(-q/2, j) (w/d^2)^j / (k+1+2j); the binomials are at most one, so that the rest is geometric.
template <class Number>
Number RadialTable<Number>::series(int k, const Number& ratio, double log2_ratio, const Real& scale) const {
  const int q = range_.lowest_q();
  const int terms = log2_ratio == -HUGE_VAL ? 1 : 2 + static_cast<int>(static_cast<double>(working_bits) / -log2_ratio);
  Number sum(0), power_of_ratio(1);
  for (int j = 0; j < terms; ++j) {
    sum += power_of_ratio / (k + 1 + 2 * j);
    power_of_ratio = power_of_ratio * ratio * (-q - 2 * j) / (2 * (j + 1));
  }
  const Real bound = upper_bound(ratio);
  Real rest(1), one(1);
  if (strictly_below_one(bound)) {
    arb_pow_ui(rest.raw(), bound.raw(), static_cast<ulong>(terms), working_bits);
    rest = rest / (one - bound);
  } else {
    arb_indeterminate(rest.raw());
  }
  return widened(sum, rest) * scale;
}

template <class Number>
void RadialTable<Number>::set_from_zero(const Number& w, const Number& ratio, double log2_ratio, const Real& d) {
  const int lowest = range_.lowest_q(), top = range_.highest_k;
  const Real square = d * d, scale = lowest == 2 ? Real(1) / square : d;
  for (const int k : {top, top - 1}) at(k, lowest) = series(k, ratio, log2_ratio, scale);
  for (int k = top; k >= 2; --k)  // (1)
    at(k - 2, lowest) = (power(lowest) - w * at(k, lowest) * (k + 1 - lowest)) / (square * (k - 1));
  for (int q = lowest + 2; q <= range_.highest_q; q += 2)  // (4)
    for (int k = 0; k <= top; ++k) at(k, q) = (power(q) + at(k, q - 2) * (q - 3 - k)) / (square * (q - 2));
}

template <class Number>
void RadialTable<Number>::set_from_elementary(const Number& w, const Number& r, const Real& d) {
  const int lowest = range_.lowest_q(), top = range_.highest_k;
  const Number rho = sqrt(w), inverse = Number(1) / w;
  const Real square = d * d;
  const bool odd = lowest == -1;
  // k = 0 by (4), whose terms are positive.
  if (odd) {
    at(0, 1) = log((rho + r) / d) / rho;
    at(0, -1) = (r + at(0, 1) * square) / 2;
  } else {
    at(0, 2) = angle(rho, d) / (rho * d);
  }
  for (int q = odd ? 3 : 4; q <= range_.highest_q; q += 2)
    at(0, q) = (power(q) + at(0, q - 2) * (q - 3)) / (square * (q - 2));
  Real power_of_height = odd ? square * d : Real(1);  // d^(2-q)
  for (int q = lowest; q <= range_.highest_q; q += 2) {
    at(1, q) = q == 2 ? log(r / d) * inverse : (power(q) - Number(power_of_height)) * inverse / (2 - q);  // (2)
    power_of_height = power_of_height / square;
    for (int k = 2; k <= top; ++k)
      at(k, q) = k + 1 == q ? (at(k - 2, q - 2) - power(q) / (q - 2)) * inverse                      // (3)
                            : (power(q) - at(k - 2, q) * square * (k - 1)) * inverse / (k + 1 - q);  // (1)
  }
}

template class RadialTable<Real>;
template class RadialTable<Complex>;

}  // namespace cageproof::quadrature_ref::certified
