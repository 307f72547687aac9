// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/mp.h"

#include "cageproof/core/numbers/mp_number.h"

#include <boost/math/constants/constants.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <ostream>

namespace cageproof {
namespace {

namespace bm = boost::multiprecision;

// The common beginning of all constructors.
template <unsigned D, class... Values>
void construct(void* storage, const Values&... values) {
  static_assert(sizeof(MpNumber<D>) == sizeof(Mp<D>) && alignof(MpNumber<D>) <= alignof(Mp<D>));
  static_assert(std::is_standard_layout_v<typename MpNumber<D>::backend_type> &&
                std::is_standard_layout_v<MpNumber<D>>);
  static_assert(Mp<D>::bits == unsigned(std::numeric_limits<MpNumber<D>>::digits));
  static_assert(std::numeric_limits<Mp<D>>::max_digits10 == std::numeric_limits<MpNumber<D>>::max_digits10);
  new (storage) MpNumber<D>(values...);
}

double by_mpfr(mpfr_srcptr x, double) { return mpfr_get_d(x, MPFR_RNDN); }
long double by_mpfr(mpfr_srcptr x, long double) { return mpfr_get_ld(x, MPFR_RNDN); }

// The number of that sign that is digits * 2^(exponent - 53), of 53 bits, or 2^53 itself.
double assembled(std::uint64_t digits, mpfr_exp_t exponent, bool negative, double) {
  constexpr int bias = 1023;
  // The highest of the digits, which is not stored, adds one to the exponent, as does what 53 bits do not hold.
  const std::uint64_t bits = (static_cast<std::uint64_t>(exponent + bias - 2) << 52) + digits;
  return std::bit_cast<double>(bits | static_cast<std::uint64_t>(negative) << 63);
}
// As above, of 64 bits, of which 2^64 is zero.
long double assembled(std::uint64_t digits, mpfr_exp_t exponent, bool negative, long double) {
  constexpr int bias = 16383;
  constexpr std::uint64_t highest = std::uint64_t{1} << 63;
  const auto head = static_cast<std::uint16_t>((exponent + bias - (digits == 0 ? 0 : 1)) | (negative ? 1 << 15 : 0));
  if (digits == 0) digits = highest;
  long double number = 0;
  std::memcpy(&number, &digits, sizeof digits);
  std::memcpy(reinterpret_cast<std::byte*>(&number) + sizeof digits, &head, sizeof head);
  return number;
}

// The nearest of F's numbers, ties to even. MPFR's own functions make a number of F's precision first, and the one for
// long double asks for memory, which takes as long as six products in 50 digits.
template <class F>
F nearest(mpfr_srcptr x) {
  using Limits = std::numeric_limits<F>;
  constexpr int digits = Limits::digits;
  static_assert(GMP_NUMB_BITS == 64);
  // IEEE's double, and the extended one of x86.
  constexpr bool is_known = std::endian::native == std::endian::little &&
                            ((digits == 53 && Limits::max_exponent == 1024 && sizeof(F) == 8) ||
                             (digits == 64 && Limits::max_exponent == 16384 && sizeof(F) >= 10));
  if constexpr (is_known) {
    // Numbers that are not F's normal ones, nor become so by rounding, are left to MPFR.
    const mpfr_exp_t exponent = mpfr_regular_p(x) != 0 ? mpfr_get_exp(x) : std::numeric_limits<mpfr_exp_t>::max();
    if (exponent > Limits::min_exponent && exponent < Limits::max_exponent) {
      const auto* const limbs = static_cast<const std::uint64_t*>(mpfr_custom_get_significand(x));
      const auto last = static_cast<std::size_t>((mpfr_get_prec(x) - 1) / 64);
      constexpr int unused = 64 - digits;
      std::uint64_t top = limbs[last], half = 0, below = 0;
      std::size_t whole = last;  // limbs that only tell whether anything is below
      if constexpr (unused > 0) {
        half = top >> (unused - 1) & 1;
        below = top & ((std::uint64_t{1} << (unused - 1)) - 1);
        top >>= unused;
      } else if (last > 0) {
        whole = last - 1;
        half = limbs[whole] >> 63;
        below = limbs[whole] << 1;
      }
      for (std::size_t i = 0; i < whole; ++i) below |= limbs[i];
      const std::uint64_t up = half & static_cast<std::uint64_t>(below != 0 || (top & 1) != 0);
      return assembled(top + up, exponent, mpfr_signbit(x) != 0, F());
    }
  }
  return by_mpfr(x, F());
}

}  // namespace

// Numbers are made and copied some fifty times per computed one, so these functions do without MPFR's calls: they copy
// a number's bytes, and then set the pointer to its own limbs.
template <unsigned D>
Mp<D>::Mp() {
  static_assert(sizeof(__mpfr_struct) == kHead);
  mpfr_custom_init_set(data(), MPFR_ZERO_KIND, 0, bits, limbs());
}
template <unsigned D>
Mp<D>::Mp(const Mp& other) : number_(other.number_) {
  mpfr_custom_move(data(), limbs());
}
template <unsigned D>
Mp<D>& Mp<D>::operator=(const Mp& other) {
  number_ = other.number_;
  mpfr_custom_move(data(), limbs());
  return *this;
}
template <unsigned D>
template <unsigned More>
Mp<D>::Mp(const Mp<More>& other) {
  construct<D>(&number_, number_of(other));
}
template <unsigned D>
Mp<D>::Mp(const char* text) {
  construct<D>(&number_, text);
}
template <unsigned D>
Mp<D>::Mp(Exactly, double value) {
  construct<D>(&number_, value);
}
template <unsigned D>
Mp<D>::Mp(Exactly, long double value) {
  construct<D>(&number_, value);
}
template <unsigned D>
Mp<D>::Mp(Exactly, long long value) {
  construct<D>(&number_, value);
}
template <unsigned D>
Mp<D>::Mp(Exactly, unsigned long long value) {
  construct<D>(&number_, value);
}

template <unsigned D>
float Mp<D>::to_float() const {
  return static_cast<float>(number_of(*this));
}
template <unsigned D>
double Mp<D>::to_double() const {
  return nearest<double>(data());
}
template <unsigned D>
long double Mp<D>::to_long_double() const {
  return nearest<long double>(data());
}
template <unsigned D>
long long Mp<D>::to_integer() const {
  return static_cast<long long>(number_of(*this));
}
template <unsigned D>
unsigned long long Mp<D>::to_unsigned() const {
  return static_cast<unsigned long long>(number_of(*this));
}
template <unsigned D>
bool Mp<D>::is_zero() const {
  return number_of(*this).is_zero();
}

template <unsigned D>
mpfr_ptr Mp<D>::data() {
  return std::launder(reinterpret_cast<mpfr_ptr>(&number_));
}
template <unsigned D>
mpfr_srcptr Mp<D>::data() const {
  return std::launder(reinterpret_cast<mpfr_srcptr>(&number_));
}

template <unsigned D>
Mp<D>& Mp<D>::operator+=(const Mp& b) {
  mpfr_add(data(), data(), b.data(), MPFR_RNDN);
  return *this;
}
template <unsigned D>
Mp<D>& Mp<D>::operator-=(const Mp& b) {
  mpfr_sub(data(), data(), b.data(), MPFR_RNDN);
  return *this;
}
template <unsigned D>
Mp<D>& Mp<D>::operator*=(const Mp& b) {
  mpfr_mul(data(), data(), b.data(), MPFR_RNDN);
  return *this;
}
template <unsigned D>
Mp<D>& Mp<D>::operator/=(const Mp& b) {
  mpfr_div(data(), data(), b.data(), MPFR_RNDN);
  return *this;
}

template <unsigned D>
Mp<D> operator+(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mpfr_add(result.data(), a.data(), b.data(), MPFR_RNDN);
  return result;
}
template <unsigned D>
Mp<D> operator-(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mpfr_sub(result.data(), a.data(), b.data(), MPFR_RNDN);
  return result;
}
template <unsigned D>
Mp<D> operator*(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mpfr_mul(result.data(), a.data(), b.data(), MPFR_RNDN);
  return result;
}
template <unsigned D>
Mp<D> operator/(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mpfr_div(result.data(), a.data(), b.data(), MPFR_RNDN);
  return result;
}
template <unsigned D>
Mp<D> operator-(const Mp<D>& a) {
  Mp<D> result;
  mpfr_neg(result.data(), a.data(), MPFR_RNDN);
  return result;
}
template <unsigned D>
bool operator==(const Mp<D>& a, const Mp<D>& b) {
  return number_of(a) == number_of(b);
}
template <unsigned D>
std::partial_ordering operator<=>(const Mp<D>& a, const Mp<D>& b) {
  if (isnan(a) || isnan(b)) return std::partial_ordering::unordered;
  return number_of(a).compare(number_of(b)) <=> 0;
}

#define CAGEPROOF_MP_DEFINE(name)                  \
  template <unsigned D>                            \
  Mp<D> name(const Mp<D>& x) {                     \
    return from_number<D>(bm::name(number_of(x))); \
  }
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_DEFINE)
#undef CAGEPROOF_MP_DEFINE

template <unsigned D>
Mp<D> pow(const Mp<D>& x, const Mp<D>& y) {
  return from_number<D>(bm::pow(number_of(x), number_of(y)));
}
template <unsigned D>
Mp<D> pow(const Mp<D>& x, int n) {
  return from_number<D>(bm::pow(number_of(x), n));
}
template <unsigned D>
Mp<D> atan2(const Mp<D>& y, const Mp<D>& x) {
  return from_number<D>(bm::atan2(number_of(y), number_of(x)));
}
template <unsigned D>
Mp<D> hypot(const Mp<D>& x, const Mp<D>& y) {
  Mp<D> result;
  mpfr_hypot(result.data(), x.data(), y.data(), MPFR_RNDN);
  return result;
}
template <unsigned D>
Mp<D> copysign(const Mp<D>& x, const Mp<D>& sign) {
  return from_number<D>(bm::copysign(number_of(x), number_of(sign)));
}
template <unsigned D>
Mp<D> ldexp(const Mp<D>& x, int exponent) {
  return from_number<D>(bm::ldexp(number_of(x), exponent));
}
template <unsigned D>
Mp<D> frexp(const Mp<D>& x, int* exponent) {
  return from_number<D>(bm::frexp(number_of(x), exponent));
}
template <unsigned D>
int ilogb(const Mp<D>& x) {
  return static_cast<int>(bm::ilogb(number_of(x)));
}
template <unsigned D>
bool isnan(const Mp<D>& x) {
  return bm::isnan(number_of(x));
}
template <unsigned D>
bool isinf(const Mp<D>& x) {
  return bm::isinf(number_of(x));
}
template <unsigned D>
bool isfinite(const Mp<D>& x) {
  return bm::isfinite(number_of(x));
}
template <unsigned D>
bool signbit(const Mp<D>& x) {
  return bm::signbit(number_of(x)) != 0;
}

template <unsigned D>
std::ostream& operator<<(std::ostream& out, const Mp<D>& x) {
  return out << number_of(x);
}

#define CAGEPROOF_MP_CONSTANT(name, value)                 \
  template <unsigned D>                                    \
  const Mp<D>& MpConstants<D>::name() {                    \
    static const Mp<D> constant = from_number<D>((value)); \
    return constant;                                       \
  }
CAGEPROOF_MP_CONSTANT(pi, boost::math::constants::pi<MpNumber<D>>())
CAGEPROOF_MP_CONSTANT(ln_two, boost::math::constants::ln_two<MpNumber<D>>())
CAGEPROOF_MP_CONSTANT(epsilon, std::numeric_limits<MpNumber<D>>::epsilon())
CAGEPROOF_MP_CONSTANT(smallest, (std::numeric_limits<MpNumber<D>>::min)())
CAGEPROOF_MP_CONSTANT(largest, (std::numeric_limits<MpNumber<D>>::max)())
CAGEPROOF_MP_CONSTANT(infinity, std::numeric_limits<MpNumber<D>>::infinity())
CAGEPROOF_MP_CONSTANT(nan, std::numeric_limits<MpNumber<D>>::quiet_NaN())
#undef CAGEPROOF_MP_CONSTANT

#define CAGEPROOF_MP_50(name) template Mp<50> name(const Mp<50>&);
#define CAGEPROOF_MP_100(name) template Mp<100> name(const Mp<100>&);
#define CAGEPROOF_MP_200(name) template Mp<200> name(const Mp<200>&);
#define CAGEPROOF_MP_400(name) template Mp<400> name(const Mp<400>&);
#define CAGEPROOF_MP_800(name) template Mp<800> name(const Mp<800>&);
#define CAGEPROOF_MP_2000(name) template Mp<2000> name(const Mp<2000>&);
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_50)
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_100)
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_200)
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_400)
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_800)
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_2000)
#define CAGEPROOF_MP_INSTANCE(R)                                  \
  template R operator+(const R&, const R&);                       \
  template R operator-(const R&, const R&);                       \
  template R operator*(const R&, const R&);                       \
  template R operator/(const R&, const R&);                       \
  template R operator-(const R&);                                 \
  template bool operator==(const R&, const R&);                   \
  template std::partial_ordering operator<=>(const R&, const R&); \
  template R pow(const R&, const R&);                             \
  template R pow(const R&, int);                                  \
  template R atan2(const R&, const R&);                           \
  template R hypot(const R&, const R&);                           \
  template R copysign(const R&, const R&);                        \
  template R ldexp(const R&, int);                                \
  template R frexp(const R&, int*);                               \
  template int ilogb(const R&);                                   \
  template bool isnan(const R&);                                  \
  template bool isinf(const R&);                                  \
  template bool isfinite(const R&);                               \
  template bool signbit(const R&);                                \
  template std::ostream& operator<<(std::ostream&, const R&);
CAGEPROOF_MP_INSTANCE(Mp<50>)
CAGEPROOF_MP_INSTANCE(Mp<100>)
CAGEPROOF_MP_INSTANCE(Mp<200>)
CAGEPROOF_MP_INSTANCE(Mp<400>)
CAGEPROOF_MP_INSTANCE(Mp<800>)
CAGEPROOF_MP_INSTANCE(Mp<2000>)
template class Mp<50>;
template class Mp<100>;
template class Mp<200>;
template class Mp<400>;
template class Mp<800>;
template class Mp<2000>;
template struct MpConstants<50>;
template struct MpConstants<100>;
template struct MpConstants<200>;
template struct MpConstants<400>;
template struct MpConstants<800>;
template struct MpConstants<2000>;
template Mp<50>::Mp(const Mp<100>&);
template Mp<50>::Mp(const Mp<200>&);
template Mp<100>::Mp(const Mp<50>&);
template Mp<100>::Mp(const Mp<200>&);
template Mp<200>::Mp(const Mp<50>&);
template Mp<200>::Mp(const Mp<100>&);
template Mp<50>::Mp(const Mp<400>&);
template Mp<100>::Mp(const Mp<400>&);
template Mp<200>::Mp(const Mp<400>&);
template Mp<400>::Mp(const Mp<50>&);
template Mp<400>::Mp(const Mp<100>&);
template Mp<400>::Mp(const Mp<200>&);
template Mp<50>::Mp(const Mp<800>&);
template Mp<100>::Mp(const Mp<800>&);
template Mp<200>::Mp(const Mp<800>&);
template Mp<200>::Mp(const Mp<2000>&);
template Mp<800>::Mp(const Mp<50>&);
template Mp<800>::Mp(const Mp<100>&);
template Mp<800>::Mp(const Mp<200>&);
template Mp<2000>::Mp(const Mp<200>&);

}  // namespace cageproof
