// SPDX-License-Identifier: MIT
// The multiprecision type against Boost.Multiprecision's own numbers, whose work it hands on.
#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/numbers/mp_number.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>

namespace cageproof {
namespace {

template <class R>
class mp : public testing::Test {
 protected:
  static constexpr unsigned digits = std::numeric_limits<R>::digits10;

  static void expect_same(const R& ours, const MpNumber<digits>& boosts, const char* what) {
    EXPECT_TRUE((isnan(ours) && isnan(boosts)) ||
                (number_of(ours) == boosts && signbit(ours) == (signbit(boosts) != 0)))
        << what << ": " << ours << ", not " << boosts;
  }
};
using Types = testing::Types<Mp50, Mp100, Mp200>;
TYPED_TEST_SUITE(mp, Types);

// A number of random limbs, many of which are all zeros or all ones, so that ties and carries are met.
template <class R>
R of_random_limbs(RandomStream& random, int exponent) {
  R x = 1;
  for (int limb = 0; limb < (std::numeric_limits<R>::digits + 63) / 64; ++limb) {
    const R unit = ldexp(R(1), -64 * (limb + 1));
    const int kind = random.below(5);
    if (kind == 0) continue;
    if (kind == 1) x += (ldexp(R(1), 64) - 1) * unit;
    else if (kind == 2) x += ldexp(unit, random.below(64));
    else x += R(random.uniform()) * ldexp(unit, 64);
  }
  return ldexp(R(random.below(2) == 0 ? x : -x), exponent);
}

TYPED_TEST(mp, builtin_numbers_are_the_nearest) {
  const auto expect_nearest = [](const TypeParam& x) {
    const double narrow = mpfr_get_d(x.data(), MPFR_RNDN);
    const long double wide = mpfr_get_ld(x.data(), MPFR_RNDN);
    const auto found = static_cast<double>(x);
    const auto found_wide = static_cast<long double>(x);
    EXPECT_TRUE((std::isnan(narrow) && std::isnan(found)) ||
                (narrow == found && std::signbit(narrow) == std::signbit(found)))
        << x << ": " << found << ", not " << narrow;
    EXPECT_TRUE((std::isnan(wide) && std::isnan(found_wide)) ||
                (wide == found_wide && std::signbit(wide) == std::signbit(found_wide)))
        << x << ": " << found_wide << ", not " << wide;
  };
  for (const double x : {0., -0., 1., HUGE_VAL, -HUGE_VAL, static_cast<double>(NAN)}) expect_nearest(TypeParam(x));
  RandomStream random(7, "mp", 0);
  // Both ends of both ranges, and beyond.
  for (const int middle : {0, -1022, -1074, 1023, -16382, -16445, 16383, 40000})
    for (int i = 0; i < 2000; ++i) expect_nearest(of_random_limbs<TypeParam>(random, middle + random.below(9) - 4));
}

TYPED_TEST(mp, arithmetic_is_boosts) {
  using Number = MpNumber<TestFixture::digits>;
  std::vector<double> values{0, -0., 1, -1, .5, 3, 1e300, -1e-300, 0x1p-1074, HUGE_VAL, NAN};
  RandomStream random(5, "mp", 0);
  for (int i = 0; i < 20; ++i) values.push_back(random.uniform(-2, 2) * std::pow(10, random.uniform(-40, 40)));
  for (const double x : values)
    for (const double y : values) {
      // Thirds need all of the digits.
      const TypeParam a = TypeParam(x) / 3, b = TypeParam(y) / 7;
      const Number p = Number(x) / 3, q = Number(y) / 7;
      this->expect_same(a + b, p + q, "+");
      this->expect_same(a - b, p - q, "-");
      this->expect_same(a * b, p * q, "*");
      this->expect_same(a / b, p / q, "/");
      this->expect_same(-a, -p, "negation");
      this->expect_same(2 * a + y, 2 * p + y, "built-in numbers");
      // Boost's own difference 0 - 0 is -0 where the first is built in.
      this->expect_same(y - a / 3, Number(y) - p / 3, "built-in numbers first");
      TypeParam c = a;
      c += b, c *= a, c -= 1, c /= b;
      Number r = p;
      r += q, r *= p, r -= 1, r /= q;
      this->expect_same(c, r, "in place");
      EXPECT_EQ(a < b, p < q);
      EXPECT_EQ(a <= b, p <= q);
      EXPECT_EQ(a > y, p > y);
      EXPECT_EQ(x >= b, x >= q);
      EXPECT_EQ(a == b, p == q);
      EXPECT_EQ(a != y, p != y);
      this->expect_same(atan2(a, b), atan2(p, q), "atan2");
      this->expect_same(copysign(a, b), copysign(p, q), "copysign");
    }
}

// Factors and divisors are given to MPFR without their limbs that are zero: the results are the same to the last bit.
TYPED_TEST(mp, arithmetic_is_mpfrs_whatever_limbs_are_zero) {
  RandomStream random(11, "mp", 0);
  mpfr_t expected;
  mpfr_init2(expected, TypeParam::bits);
  const auto expect_expected = [&](const TypeParam& found, const char* what) {
    EXPECT_TRUE(mpfr_equal_p(found.data(), expected) != 0 && mpfr_signbit(found.data()) == mpfr_signbit(expected))
        << what << ": " << found;
  };
  for (int i = 0; i < 5000; ++i) {
    // Exponents that are equal, neighbours, as far apart as there are bits, and further.
    const int apart = std::array{0, 1, 3, 400, 1200}[random.below(5)];
    const TypeParam a = of_random_limbs<TypeParam>(random, 0);
    TypeParam b = of_random_limbs<TypeParam>(random, random.below(2 * apart + 1) - apart);
    if (i % 8 == 0) b = a + ldexp(a, -random.below(TypeParam::bits + 8));
    mpfr_add(expected, a.data(), b.data(), MPFR_RNDN);
    expect_expected(a + b, "+");
    mpfr_sub(expected, a.data(), b.data(), MPFR_RNDN);
    expect_expected(a - b, "-");
    mpfr_mul(expected, a.data(), b.data(), MPFR_RNDN);
    expect_expected(a * b, "*");
    TypeParam c = a;
    expect_expected(c *= b, "* in place");
    mpfr_sqr(expected, b.data(), MPFR_RNDN);
    c = b;
    expect_expected(c *= c, "the square in place");
    mpfr_div(expected, a.data(), b.data(), MPFR_RNDN);
    expect_expected(a / b, "/");
    c = a;
    expect_expected(c /= b, "/ in place");
    mpfr_mul_d(expected, a.data(), 0.1, MPFR_RNDN);
    expect_expected(a * 0.1, "* a double");
    mpfr_div_si(expected, a.data(), -7, MPFR_RNDN);
    expect_expected(a / -7, "/ an integer");
  }
  mpfr_clear(expected);
}

TYPED_TEST(mp, functions_are_boosts) {
  using Number = MpNumber<TestFixture::digits>;
  for (const double x : {-.75, -1e-20, 0., 1e-30, .3, .999, 1., 1.5, 7., 1e10}) {
    const TypeParam a = TypeParam(x) / 3;
    const Number p = Number(x) / 3;
#define CAGEPROOF_EXPECT(name) this->expect_same(name(a), Number(boost::multiprecision::name(p)), #name);
    CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_EXPECT)
#undef CAGEPROOF_EXPECT
    this->expect_same(pow(a, 5), Number(pow(p, 5)), "pow");
    this->expect_same(ldexp(a, -70), Number(ldexp(p, -70)), "ldexp");
    int exponent = 0, boosts = 0;
    this->expect_same(frexp(a, &exponent), Number(frexp(p, &boosts)), "frexp");
    EXPECT_EQ(exponent, boosts);
    if (x != 0) {
      EXPECT_EQ(ilogb(a), ilogb(p));
    }
  }
}

TYPED_TEST(mp, converts_as_boosts_does) {
  using Number = MpNumber<TestFixture::digits>;
  for (const char* text : {"0.1", "-2.5", "1e-320", "12345678.75"}) {
    const TypeParam a(text);
    const Number p(text);
    this->expect_same(a, p, text);
    EXPECT_EQ(static_cast<double>(a), static_cast<double>(p));
    EXPECT_EQ(static_cast<float>(a), static_cast<float>(p));
    EXPECT_EQ(static_cast<int>(a), static_cast<int>(p));
    std::ostringstream ours, boosts;
    ours << a;
    boosts << p;
    EXPECT_EQ(ours.str(), boosts.str());
  }
  EXPECT_THROW(TypeParam("one"), std::runtime_error);
  EXPECT_EQ(static_cast<double>(TypeParam()), 0);
  EXPECT_EQ(static_cast<long long>(TypeParam(-9007199254740993LL)), -9007199254740993LL);
  EXPECT_EQ(static_cast<unsigned long>(TypeParam(~0UL)), ~0UL);
  EXPECT_EQ(static_cast<bool>(TypeParam(.5)), true);
  // From fewer digits exactly, from more with one rounding.
  const Mp200 third = Mp200(1) / 3;
  EXPECT_EQ(static_cast<double>(Mp200(static_cast<Mp50>(third)) - third) == 0, false);
  EXPECT_EQ(static_cast<Mp50>(third), Mp50(1) / 3);
  EXPECT_EQ(Mp200(TypeParam(1) / 3) * 3 == Mp200(1), std::numeric_limits<TypeParam>::digits10 == 200);
}

TYPED_TEST(mp, copies_are_their_own) {
  TypeParam a = TypeParam(1) / 3;
  std::vector<TypeParam> many(3, a);
  many.resize(100, TypeParam(2));
  const TypeParam b = a;
  a *= 3;
  EXPECT_EQ(b, many[0]);
  EXPECT_NE(a, b);
  std::swap(many[0], many[99]);
  EXPECT_EQ(many[0], 2);
  EXPECT_EQ(many[99], b);
  const TypeParam& same = a;
  a = same;
  EXPECT_LT(abs(a - 1), std::numeric_limits<TypeParam>::epsilon());
}

TYPED_TEST(mp, limits_and_constants_are_boosts) {
  using Number = MpNumber<TestFixture::digits>;
  using Ours = std::numeric_limits<TypeParam>;
  using Boosts = std::numeric_limits<Number>;
  EXPECT_EQ(Ours::digits, Boosts::digits);
  EXPECT_EQ(Ours::max_digits10, Boosts::max_digits10);
  this->expect_same(Ours::epsilon(), Boosts::epsilon(), "epsilon");
  this->expect_same((Ours::max)(), (Boosts::max)(), "max");
  this->expect_same((Ours::min)(), (Boosts::min)(), "min");
  this->expect_same(Ours::lowest(), Boosts::lowest(), "lowest");
  EXPECT_TRUE(isinf(Ours::infinity()) && isnan(Ours::quiet_NaN()) && !isfinite(Ours::infinity()));
  // Machin's formula, by Boost's arc tangent.
  const Number machin = 16 * atan(Number(Number(1) / 5)) - 4 * atan(Number(Number(1) / 239));
  EXPECT_LT(abs(TypeParam(pi<TypeParam>() - from_number(machin))), 64 * Ours::epsilon());
}

TYPED_TEST(mp, works_in_eigens_matrices) {
  const Vec3<TypeParam> v = convert<TypeParam>(Vec3<double>(1, 2, 2));
  EXPECT_EQ(v.norm(), 3);
  EXPECT_EQ((2 * v - v).dot(v), 9);
  const Mat3<TypeParam> m = v * v.transpose();
  EXPECT_EQ((m * v)[0], 9);
  EXPECT_EQ(v.cross(Vec3<TypeParam>(0, 0, 1))[0], 2);
  EXPECT_TRUE(v.allFinite());
}

}  // namespace
}  // namespace cageproof
