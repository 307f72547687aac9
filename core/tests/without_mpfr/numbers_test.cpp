// SPDX-License-Identifier: MIT
// The multiprecision numbers against MPFR's own functions: the same bits. `scripts/check_numbers` builds it with
// Boost's numbers and with MPFR's.
#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/numbers/mp.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "geometry/exact_signs.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>

namespace cageproof {
namespace {

// One of MPFR's numbers, of as many bits as R has.
template <class R>
class Known {
 public:
  Known() { mpfr_init2(number_, R::bits); }
  // By pieces that doubles hold.
  explicit Known(const R& x) : Known() {
    if (!isfinite(x) || x.is_zero()) {
      mpfr_set_d(number_, static_cast<double>(x), MPFR_RNDN);
      return;
    }
    mpfr_set_zero(number_, 1);
    mpfr_t part;
    mpfr_init2(part, std::numeric_limits<double>::digits);
    for (R rest = x; !rest.is_zero();) {
      // Near one, lest it leaves double's range.
      const auto exponent = static_cast<int>(rest.exponent());
      const auto piece = static_cast<double>(R(ldexp(rest, -exponent)));
      mpfr_set_d(part, piece, MPFR_RNDN);
      mpfr_mul_2si(part, part, exponent, MPFR_RNDN);
      EXPECT_EQ(mpfr_add(number_, number_, part, MPFR_RNDN), 0) << "a piece that does not fit";
      rest -= ldexp(R(piece), exponent);
    }
    mpfr_clear(part);
  }
  Known(const Known&) = delete;
  Known& operator=(const Known&) = delete;
  ~Known() { mpfr_clear(number_); }

  mpfr_ptr get() { return number_; }

 private:
  mpfr_t number_;
};

template <class R>
void expect_same(const R& ours, Known<R>& known, const char* what, const R& of) {
  Known<R> found(ours);
  EXPECT_TRUE((mpfr_nan_p(found.get()) && mpfr_nan_p(known.get())) ||
              (mpfr_equal_p(found.get(), known.get()) && mpfr_signbit(found.get()) == mpfr_signbit(known.get())))
      << what << " of " << of << " is " << ours << ", not " << mpfr_get_ld(known.get(), MPFR_RNDN);
}

// A number of random limbs, many of which are all zeros or all ones, so that ties and carries are met.
template <class R>
R of_random_limbs(RandomStream& random, int exponent) {
  R x = 1;
  for (unsigned limb = 1; limb <= (R::bits + 63) / 64; ++limb) {
    const R unit = ldexp(R(1), -64 * static_cast<int>(limb));
    const int kind = random.below(5);
    if (kind == 1) x += (ldexp(R(1), 64) - 1) * unit;
    else if (kind == 2) x += ldexp(unit, random.below(64));
    else if (kind > 2) x += R(random.uniform()) * ldexp(unit, 64);
  }
  return ldexp(R(random.below(2) == 0 ? x : -x), exponent);
}

// How often to ask: less often where a number has thousands of bits.
template <class R>
constexpr int times(int often) {
  return R::bits > 1000 ? often / 8 : often;
}

template <class R>
class without_mpfr : public testing::Test {};
using Types = testing::Types<Mp50, Mp100, Mp200, Mp400, Mp2000>;
TYPED_TEST_SUITE(without_mpfr, Types);

TYPED_TEST(without_mpfr, arithmetic_has_the_same_bits) {
  using R = TypeParam;
  std::vector<R> values;
  for (const double x : {0., -0., 1., -1., .5, 3., 1e300, -1e-300, 0x1p-1074, HUGE_VAL, -HUGE_VAL, double(NAN)})
    values.emplace_back(x), values.push_back(R(x) / 3);
  RandomStream random(5, "mp", 0);
  for (int i = 0; i < times<R>(40); ++i) values.push_back(of_random_limbs<R>(random, random.below(9) - 4));
  Known<R> result;
  for (const R& a : values) {
    Known<R> p(a);
    mpfr_sqrt(result.get(), p.get(), MPFR_RNDN);
    expect_same(R(sqrt(a)), result, "root", a);
    mpfr_neg(result.get(), p.get(), MPFR_RNDN);
    expect_same(R(-a), result, "negative", a);
    for (const R& b : values) {
      Known<R> q(b);
      mpfr_add(result.get(), p.get(), q.get(), MPFR_RNDN);
      expect_same(R(a + b), result, "sum", a);
      mpfr_sub(result.get(), p.get(), q.get(), MPFR_RNDN);
      expect_same(R(a - b), result, "difference", a);
      mpfr_mul(result.get(), p.get(), q.get(), MPFR_RNDN);
      expect_same(R(a * b), result, "product", a);
      mpfr_div(result.get(), p.get(), q.get(), MPFR_RNDN);
      expect_same(R(a / b), result, "quotient", a);
      EXPECT_EQ(a < b, mpfr_less_p(p.get(), q.get()) != 0);
      EXPECT_EQ(a >= b, mpfr_greaterequal_p(p.get(), q.get()) != 0);
      EXPECT_EQ(a == b, mpfr_equal_p(p.get(), q.get()) != 0);
    }
  }
}

TYPED_TEST(without_mpfr, builtin_numbers_are_the_nearest) {
  using R = TypeParam;
  const auto check = [](const R& x) {
    Known<R> known(x);
    const double narrow = mpfr_get_d(known.get(), MPFR_RNDN);
    const float narrowest = mpfr_get_flt(known.get(), MPFR_RNDN);
    const long double wide = mpfr_get_ld(known.get(), MPFR_RNDN);
    EXPECT_EQ(static_cast<double>(x), narrow) << x;
    EXPECT_EQ(static_cast<float>(x), narrowest) << x;
    EXPECT_EQ(static_cast<long double>(x), wide) << x;
  };
  RandomStream random(7, "mp", 0);
  for (const int middle : {0, -126, -149, 127, -1022, -1074, 1023, -16382, -16445, 16383, 40000})
    for (int i = 0; i < times<R>(100); ++i) check(of_random_limbs<R>(random, middle + random.below(9) - 4));
}

TYPED_TEST(without_mpfr, logarithms_have_the_same_bits) {
  using R = TypeParam;
  RandomStream random(9, "mp", 0);
  Known<R> result;
  for (const int exponent : {-1100, -200, -60, -3, -2, 0, 1, 40, 1000})
    for (int i = 0; i < std::max(1, times<R>(4)); ++i) {
      const R x = abs(of_random_limbs<R>(random, exponent));
      Known<R> p(x);
      mpfr_log(result.get(), p.get(), MPFR_RNDN);
      expect_same(R(log(x)), result, "log", x);
      mpfr_log1p(result.get(), p.get(), MPFR_RNDN);
      expect_same(R(log1p(x)), result, "log1p", x);
      mpfr_atanh(result.get(), p.get(), MPFR_RNDN);
      expect_same(R(atanh(x)), result, "atanh", x);
      const R y = of_random_limbs<R>(random, exponent / 2);
      Known<R> q(y);
      mpfr_atan2(result.get(), q.get(), p.get(), MPFR_RNDN);
      expect_same(R(atan2(y, x)), result, "atan2", y);
      mpfr_hypot(result.get(), q.get(), p.get(), MPFR_RNDN);
      expect_same(R(hypot(y, x)), result, "hypot", y);
    }
}

template <class R>
class without_mpfr_formulas : public testing::Test {};
using Scalars = testing::Types<Mp50, Mp100, Mp200>;
TYPED_TEST_SUITE(without_mpfr_formulas, Scalars);

int mpfr_fabs(mpfr_ptr result, mpfr_srcptr x, mpfr_rnd_t way) { return mpfr_abs(result, x, way); }

TYPED_TEST(without_mpfr_formulas, functions_have_the_same_bits) {
  using R = TypeParam;
  Known<R> result;
#undef mpfr_floor
#undef mpfr_ceil
#undef mpfr_trunc
#undef mpfr_round
#define mpfr_floor mpfr_rint_floor
#define mpfr_ceil mpfr_rint_ceil
#define mpfr_trunc mpfr_rint_trunc
#define mpfr_round mpfr_rint_round
  for (const double x : {-.75, -1e-20, 0., 1e-30, .3, .999, 1., 1.5, 7., 100., 1e10, HUGE_VAL, double(NAN)}) {
    const R a = R(x) / 3;
    Known<R> p(a);
#define CAGEPROOF_EXPECT(name)                   \
  mpfr_##name(result.get(), p.get(), MPFR_RNDN); \
  expect_same(R(name(a)), result, #name, a);
    CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_EXPECT)
#undef CAGEPROOF_EXPECT
    mpfr_pow_si(result.get(), p.get(), 5, MPFR_RNDN);
    expect_same(R(pow(a, 5)), result, "pow", a);
  }
  mpfr_const_pi(result.get(), MPFR_RNDN);
  expect_same(pi<R>(), result, "pi", R(1));
  mpfr_const_log2(result.get(), MPFR_RNDN);
  expect_same(ln_two<R>(), result, "the logarithm", R(2));
}

TYPED_TEST(without_mpfr_formulas, text_is_read_and_written_alike) {
  using R = TypeParam;
  Known<R> result;
  for (const char* text :
       {"0.1", "-2.5", "1e-320", "12345678.75", "+5", ".5", "5.", "-0", "6.02214076e23", "0x1.8p-3", "-0X.8P4", "inf",
        "-inf", "1e400", "0x1.fffffffffffffffffffffffffffffffffffffffffffffffff"}) {
    const auto found = parse_scalar<R>(text);
    ASSERT_TRUE(found) << text;
    mpfr_set_str(result.get(), text, 0, MPFR_RNDN);
    expect_same(*found, result, text, R(0));
    if (!isfinite(*found)) continue;
    char written[300];
    mpfr_snprintf(written, sizeof written, "%.*Re", std::numeric_limits<R>::max_digits10 - 1, result.get());
    EXPECT_EQ(format_scalar(*found), written);
  }
  for (const char* text : {"1e", "one", "1..2", "0x", "1e5.", "--1", "1p3", "e5", "."})
    EXPECT_FALSE(parse_scalar<R>(text)) << text;
#ifdef CAGEPROOF_NO_MPFR
  EXPECT_FALSE(parse_scalar<R>("1e99999999999"));
#endif
  // From more digits with one rounding.
  RandomStream random(3, "mp", 0);
  for (int i = 0; i < 100; ++i) {
    const auto wide = of_random_limbs<Mp800>(random, random.below(9));
    Known<Mp800> known(wide);
    mpfr_set(result.get(), known.get(), MPFR_RNDN);
    expect_same(R(wide), result, "fewer digits", R(0));
  }
}

TEST(without_mpfr, quotients_of_integers_are_the_nearest) {
  RandomStream random(4, "mp", 0);
  Known<Mp200> result;
  for (int i = 0; i < 200; ++i) {
    const double a = random.uniform(-1, 1) * std::pow(10, random.uniform(-30, 30)), b = random.uniform(.5, 1e9);
    Known<Mp200> p{Mp200(a)};
    mpfr_div_d(result.get(), p.get(), b, MPFR_RNDN);
    expect_same(exact::to_mp(exact::Rational(a) / exact::Rational(b)), result, "quotient", Mp200(a));
    const auto x = of_random_limbs<Mp200>(random, random.below(600) - 300);
    EXPECT_EQ(exact::to_mp(exact::from(x)), x);
  }
  // Ties go to the even one, and no further than to the next power of two.
  const exact::Integer one = 1, half = one << Mp200::bits;
  const Mp200 unit = ldexp(Mp200(1), 1 - static_cast<int>(Mp200::bits));
  const auto nearest = [&](const exact::Integer& x) {
    return exact::nearest<Mp200>(x, -static_cast<long>(Mp200::bits));
  };
  EXPECT_EQ(nearest(half + 1), 1);
  EXPECT_EQ(nearest(half + 3), 1 + 2 * unit);
  EXPECT_EQ(nearest((half << 1) - 1), 2);
  // A third of a unit more than a tie.
  EXPECT_EQ(exact::to_mp(exact::Rational(exact::Integer((half + 1) * 3 + 1), exact::Integer(half * 3))), 1 + unit);
}

// Coordinates whose digits are far apart, which integers hold.
TEST(without_mpfr, volumes_are_rounded_once) {
  RandomStream random(6, "mp", 0);
  for (int i = 0; i < 50; ++i) {
    const auto any = [&] { return ldexp(Mp200(random.uniform(-1, 1)), random.below(400) - 200); };
    const auto vector = [&] { return Vec3<Mp200>(any(), any(), any()); };
    const Triangle<Mp200> t{vector(), vector(), vector()};
    const Vec3<Mp200> point = vector();
    const auto wide = [](const Vec3<Mp200>& v) { return Vec3<Mp2000>(Mp2000(v[0]), Mp2000(v[1]), Mp2000(v[2])); };
    const Vec3<Mp2000> a = wide(t[1]) - wide(t[0]), b = wide(t[2]) - wide(t[1]), p = wide(t[0]) - wide(point);
    EXPECT_EQ(ExactTriangleIn<Mp200>(t, point).volume, Mp200(a.cross(b).dot(p)));
  }
}

}  // namespace
}  // namespace cageproof
