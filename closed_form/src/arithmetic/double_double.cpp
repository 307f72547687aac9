// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/arithmetic/double_double.h"

#include "cageproof/closed_form/batch/pair.h"

namespace cageproof::closed_form {
namespace {

namespace vectors = batch::CAGEPROOF_SIMD;

// Between these, quotients and squares are normal numbers.
bool is_ordinary(double x) { return std::abs(x) > 0x1p-400 && std::abs(x) < 0x1p400; }

Mp50 wide(const DoubleDouble& a) { return Mp50(a.high) + a.low; }

// The functions of vectors, of one number in all of their places.
vectors::Pair pair(const DoubleDouble& a) { return vectors::Pair(batch::TwoDoubles{a.high, a.low}); }
DoubleDouble first(const vectors::Pair& a) { return DoubleDouble::sum(a.high[0], a.low[0]); }
DoubleDouble log_of(const DoubleDouble& num, const DoubleDouble& den, const DoubleDouble& length,
                    const DoubleDouble& sum) {
  return first(vectors::log_of_quotient(pair(num), pair(den), pair(length), pair(sum)));
}

}  // namespace

DoubleDouble log(const DoubleDouble& a) {
  if (!(a.high > 0) || !is_ordinary(a.high)) return DoubleDouble(Mp50(log(wide(a))));
  // Below one the quotient is turned over, since small results are taken for positive ones.
  if (a.high < 1) return -log_of(1., a, DoubleDouble(1) - a, DoubleDouble(1) + a);
  return log_of(a, 1., a - DoubleDouble(1), a + DoubleDouble(1));
}

DoubleDouble atanh(const DoubleDouble& a) {
  if (!is_ordinary(a.high) || !(std::abs(a.high) < 0.99)) return DoubleDouble(Mp50(atanh(wide(a))));
  if (a.high < 0) return -atanh(-a);
  const DoubleDouble twice = log_of(DoubleDouble(1) + a, DoubleDouble(1) - a, a, 1.);
  return {twice.high / 2, twice.low / 2};
}

DoubleDouble atan2(const DoubleDouble& y, const DoubleDouble& x) {
  if (!is_ordinary(y.high) || !is_ordinary(x.high)) return DoubleDouble(Mp50(atan2(wide(y), wide(x))));
  return first(vectors::angle_of(pair(y), pair(x)));
}

}  // namespace cageproof::closed_form
