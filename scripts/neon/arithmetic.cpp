// SPDX-License-Identifier: MIT
// The functions that kernels take of vectors of points, against long double, which AArch64 has with 113 bits. Compiled
// as kernels are: with -DCAGEPROOF_PAIRS and without contraction those of double-doubles, else those of doubles.
#include "../../closed_form/src/batch/pair.h"

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace {

using namespace cageproof::closed_form::batch;
using namespace cageproof::closed_form::batch::CAGEPROOF_SIMD;

#if defined(CAGEPROOF_PAIRS)
using Number = Pair;
constexpr double kUnit = 0x1p-106;
#else
using Number = Lanes;
constexpr double kUnit = 0x1p-53;
#endif

// Xorshift, the same numbers everywhere.
std::uint64_t random_bits() {
  static std::uint64_t state = 88172645463325252U;
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return state;
}
double uniform() { return static_cast<double>(random_bits() >> 11) * 0x1p-53; }

// Positive, over 2^-range to 2^range; every fourth a small integer.
double positive(int range) {
  if (random_bits() % 4 == 0) return static_cast<double>(1 + random_bits() % 8);
  const int exponent = static_cast<int>(random_bits() % static_cast<unsigned>(2 * range + 1)) - range;
  return std::ldexp(1 + uniform(), exponent);
}
double signed_number(int range) { return random_bits() % 2 == 0 ? positive(range) : -positive(range); }

long double lane(const Lanes& a, int i) { return a[i]; }
[[maybe_unused]] long double lane(const Pair& a, int i) { return static_cast<long double>(a.high[i]) + a.low[i]; }

// A number of its own in each lane, with a tail where there is place for one.
Number number(double (*draw)(int), int range) {
  Lanes high{};
  for (int i = 0; i < kLanes; ++i) high[i] = draw(range);
#if defined(CAGEPROOF_PAIRS)
  Lanes low{};
  for (int i = 0; i < kLanes; ++i) low[i] = random_bits() % 4 == 0 ? 0 : high[i] * 0x1p-54 * (2 * uniform() - 1);
  return {high, low};
#else
  return high;
#endif
}

int failures = 0;

// The largest error of one function in units of rounding, and what it may be.
class Check {
 public:
  Check(const char* name, double most) : name_(name), most_(most) {}
  ~Check() {
    const bool good = worst_ <= most_ && count_ > 0;
    if (!good) ++failures;
    std::printf("%-20s %9.3g of %g units of rounding%s\n", name_, worst_, most_, good ? "" : "  FAILED");
  }
  Check(const Check&) = delete;
  Check& operator=(const Check&) = delete;

  void take(long double found, long double exact, long double size) {
    ++count_;
    if (found == exact && std::signbit(found) == std::signbit(exact)) return;
    const long double error = fabsl(found - exact) / (fabsl(size) * kUnit);
    worst_ = std::isnan(error) ? HUGE_VAL : std::fmax(worst_, static_cast<double>(error));
  }

 private:
  const char* name_;
  double most_, worst_ = 0;
  long count_ = 0;
};

constexpr int kDraws = 200000;

// Bounds. Of doubles: the roundings on the way to the result, each worth a unit at most. Of double-doubles: 2^-100,
// which pair.h promises of an operation, is 64 units; four times that for a logarithm and an angle, as of the scalar
// ones.
#if defined(CAGEPROOF_PAIRS)
constexpr double kOfRoot = 64, kOfLogarithm = 256, kOfAngle = 256;
#else
constexpr double kOfRoot = 1, kOfLogarithm = 5, kOfAngle = 6;
#endif

void roots() {
  Check check("root", kOfRoot);
  for (int n = 0; n < kDraws; ++n) {
    const Number a = number(positive, 300);
    const Number r = root(a);
    for (int i = 0; i < kLanes; ++i) check.take(lane(r, i), sqrtl(lane(a, i)), sqrtl(lane(a, i)));
  }
}

void logarithms() {
  Check check("logarithm", kOfLogarithm);
  for (int n = 0; n < kDraws; ++n) {
    // Sums and differences of 20 bits are exact, so that the quotient is that of the lengths as well.
    Lanes length{}, sum{};
    for (int i = 0; i < kLanes; ++i) {
      sum[i] = static_cast<double>(2 + random_bits() % (1U << 20));
      length[i] = static_cast<double>(1 + random_bits() % static_cast<std::uint64_t>(sum[i] - 1));
      if (n % 2 == 0) length[i] *= std::ldexp(1, -static_cast<int>(random_bits() % 12));
    }
    const Number found = log_of_quotient(Number(sum + length), Number(sum - length), Number(length), Number(sum));
    for (int i = 0; i < kLanes; ++i) {
      const long double exact = 2 * atanhl(lane(length, i) / lane(sum, i));
      check.take(lane(found, i), exact, exact);
    }
  }
}

void angles() {
  Check check("angle", kOfAngle);
  for (int n = 0; n < kDraws; ++n) {
    const int range = n % 2 == 0 ? 3 : 100;
    Number x = number(signed_number, range);
    const Number y = number(signed_number, range);
    if (n % 16 == 0) x = Number(Lanes{});
    const Number found = angle_of(y, x);
    for (int i = 0; i < kLanes; ++i) {
      const long double exact = atan2l(lane(y, i), lane(x, i));
      check.take(lane(found, i), exact, exact);
    }
  }
  // Along the axis, on both sides of the cut.
  const Number ahead = angle_of(Number(Lanes{}), Number(Lanes{1, -1}));
  check.take(lane(ahead, 0), 0, 0);
  check.take(lane(ahead, 1), atan2l(0, -1), 1);
}

#if defined(CAGEPROOF_PAIRS)
void operations() {
  Check exact("exact sum, product", 0), sums("sum", 64), products("product", 64), quotients("quotient", 64);
  for (int n = 0; n < kDraws; ++n) {
    const Pair a = number(signed_number, 25), b = number(signed_number, 25);
    const Pair s = exact_sum(a.high, b.high), p = exact_product(a.high, b.high);
    const Pair sum = a + b, product = a * b, quotient = a / b;
    for (int i = 0; i < kLanes; ++i) {
      const long double u = a.high[i], v = b.high[i], x = lane(a, i), y = lane(b, i);
      exact.take(lane(s, i), u + v, u + v);
      exact.take(lane(p, i), u * v, u * v);
      sums.take(lane(sum, i), x + y, fabsl(x) + fabsl(y));
      products.take(lane(product, i), x * y, fabsl(x * y));
      quotients.take(lane(quotient, i), x / y, fabsl(x / y));
    }
  }
}
#else
void operations() {}
#endif

}  // namespace

int main() {
  if (LDBL_MANT_DIG != 113 || kLanes != 2) {
    std::puts("this is not AArch64: long double has other than 113 bits, or a vector other than 128");
    return 2;
  }
  operations();
  roots();
  logarithms();
  angles();
  return failures == 0 ? 0 : 1;
}
