// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/mp.h"

#include "cageproof/core/numbers/mp_number.h"

#ifdef CAGEPROOF_NO_MPFR
#include "mp_by_boost.h"
#else
#include "mp_by_mpfr.h"
#endif

#include <limits>
#include <new>
#include <ostream>

namespace cageproof {
namespace {

namespace bm = boost::multiprecision;

// The common beginning of all constructors.
template <unsigned D, class... Values>
void construct(void* storage, const Values&... values) {
  static_assert(sizeof(MpNumber<D>) <= sizeof(Mp<D>) && alignof(MpNumber<D>) <= alignof(Mp<D>));
  static_assert(Mp<D>::bits == unsigned(std::numeric_limits<MpNumber<D>>::digits));
#ifndef CAGEPROOF_NO_MPFR
  static_assert(std::is_standard_layout_v<typename MpNumber<D>::backend_type> &&
                std::is_standard_layout_v<MpNumber<D>>);
  static_assert(std::numeric_limits<Mp<D>>::max_digits10 == std::numeric_limits<MpNumber<D>>::max_digits10);
#endif
  new (storage) MpNumber<D>(values...);
}

}  // namespace

#ifdef CAGEPROOF_NO_MPFR
template <unsigned D>
Mp<D>::Mp() {
  construct<D>(&number_);
}
template <unsigned D>
Mp<D>::Mp(const Mp& other) {
  construct<D>(&number_, number_of(other));
}
template <unsigned D>
Mp<D>& Mp<D>::operator=(const Mp& other) {
  number_of(*this) = number_of(other);
  return *this;
}
#else
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
mpfr_ptr Mp<D>::data() {
  return std::launder(reinterpret_cast<mpfr_ptr>(&number_));
}
template <unsigned D>
mpfr_srcptr Mp<D>::data() const {
  return std::launder(reinterpret_cast<mpfr_srcptr>(&number_));
}
#endif

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
  return mp_work::nearest<double>(*this);
}
template <unsigned D>
long double Mp<D>::to_long_double() const {
  return mp_work::nearest<long double>(*this);
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
std::int64_t Mp<D>::exponent() const {
  return mp_work::exponent(*this);
}

template <unsigned D>
Mp<D>& Mp<D>::operator+=(const Mp& b) {
  mp_work::add(*this, *this, b);
  return *this;
}
template <unsigned D>
Mp<D>& Mp<D>::operator-=(const Mp& b) {
  mp_work::subtract(*this, *this, b);
  return *this;
}
template <unsigned D>
Mp<D>& Mp<D>::operator*=(const Mp& b) {
  mp_work::multiply(*this, *this, b);
  return *this;
}
template <unsigned D>
Mp<D>& Mp<D>::operator/=(const Mp& b) {
  mp_work::divide(*this, *this, b);
  return *this;
}

template <unsigned D>
Mp<D> operator+(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mp_work::add(result, a, b);
  return result;
}
template <unsigned D>
Mp<D> operator-(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mp_work::subtract(result, a, b);
  return result;
}
template <unsigned D>
Mp<D> operator*(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mp_work::multiply(result, a, b);
  return result;
}
template <unsigned D>
Mp<D> operator/(const Mp<D>& a, const Mp<D>& b) {
  Mp<D> result;
  mp_work::divide(result, a, b);
  return result;
}
template <unsigned D>
Mp<D> operator-(const Mp<D>& a) {
  Mp<D> result;
  mp_work::negate(result, a);
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

#define CAGEPROOF_MP_DEFINE(name)                                          \
  template <unsigned D>                                                    \
  Mp<D> name(const Mp<D>& x) {                                             \
    return from_number<D>(mp_work::narrow<D>(bm::name(mp_work::wide(x)))); \
  }
CAGEPROOF_MP_FUNCTIONS(CAGEPROOF_MP_DEFINE)
#undef CAGEPROOF_MP_DEFINE

template <unsigned D>
Mp<D> pow(const Mp<D>& x, const Mp<D>& y) {
  return from_number<D>(mp_work::narrow<D>(bm::pow(mp_work::wide(x), mp_work::wide(y))));
}
template <unsigned D>
Mp<D> pow(const Mp<D>& x, int n) {
  return from_number<D>(mp_work::narrow<D>(bm::pow(mp_work::wide(x), n)));
}
template <unsigned D>
Mp<D> atan2(const Mp<D>& y, const Mp<D>& x) {
  return from_number<D>(mp_work::narrow<D>(bm::atan2(mp_work::wide(y), mp_work::wide(x))));
}
template <unsigned D>
Mp<D> hypot(const Mp<D>& x, const Mp<D>& y) {
  Mp<D> result;
  mp_work::hypot(result, x, y);
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
// No formula's scalars: they have what closed forms call.
#define CAGEPROOF_MP_WIDE_FUNCTIONS(apply) apply(abs) apply(sqrt) apply(log) apply(log1p) apply(asinh) apply(atanh)
CAGEPROOF_MP_WIDE_FUNCTIONS(CAGEPROOF_MP_400)
CAGEPROOF_MP_WIDE_FUNCTIONS(CAGEPROOF_MP_800)
CAGEPROOF_MP_WIDE_FUNCTIONS(CAGEPROOF_MP_2000)
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
