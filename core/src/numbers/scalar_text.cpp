// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/scalar_text.h"

#ifdef CAGEPROOF_NO_MPFR
#include "geometry/exact_signs.h"
#endif

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace cageproof {
namespace {

// Rejects text that strtod and mpfr_strtofr must not see: blanks, which they skip, "nan(...)" or "infinity", which they
// accept, and "0b1", which only MPFR accepts.
bool looks_like_number(std::string_view text) {
  if (text == "nan" || text == "inf" || text == "-inf") return true;
  const std::string_view digits = text.substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
  if (digits.starts_with("0b") || digits.starts_with("0B")) return false;
  return text.find_first_not_of("+-.0123456789abcdefABCDEFxXpP") == std::string_view::npos &&
         text.find_first_of("0123456789") != std::string_view::npos;
}

#ifdef CAGEPROOF_NO_MPFR

// Takes digits with at most one point among them off the text, as an integer in units of base^-`after`; whether there
// are any.
bool take_digits(std::string_view& text, int base, exact::Integer& integer, long& after) {
  bool any = false, point = false;
  for (; !text.empty(); text.remove_prefix(1)) {
    const char c = text.front();
    if (c == '.' && !point) {
      point = true;
      continue;
    }
    int digit = 0;
    if (std::from_chars(&c, &c + 1, digit, base).ec != std::errc()) break;
    integer = integer * base + digit;
    after += point ? 1 : 0;
    any = true;
  }
  return any;
}

// The number that the text is, as mpfr_strtofr reads it.
template <class R>
std::optional<R> parsed(std::string_view text) {
  using Limits = std::numeric_limits<R>;
  if (text == "nan") return Limits::quiet_NaN();
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text == "inf") return negative ? -Limits::infinity() : Limits::infinity();
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  exact::Integer integer;
  long after = 0, exponent = 0;
  if (!take_digits(text, hexadecimal ? 16 : 10, integer, after)) return std::nullopt;
  if (!text.empty()) {
    if (text.front() != (hexadecimal ? 'p' : 'e') && text.front() != (hexadecimal ? 'P' : 'E')) return std::nullopt;
    text.remove_prefix(text.starts_with("e+") || text.starts_with("E+") || text.starts_with("p+") ? 2 : 1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
    // A power with millions of digits is nobody's number, and takes minutes.
    constexpr long largest = 1'000'000;
    if (error != std::errc() || end != text.data() + text.size() || std::abs(exponent) > largest) return std::nullopt;
  }
  R size;
  if (hexadecimal) {
    size = exact::nearest<R>(integer, exponent - 4 * after);
  } else {
    exponent -= after;
    const exact::Integer power =
        boost::multiprecision::pow(exact::Integer(10), static_cast<unsigned>(std::abs(exponent)));
    size = exponent >= 0 ? exact::nearest<R>(integer * power, 0) : exact::nearest_ratio<R>(integer, power);
  }
  return negative ? -size : size;
}

#endif

}  // namespace

template <Scalar R>
std::optional<R> parse_scalar(std::string_view text) {
  if (!looks_like_number(text)) return std::nullopt;
  if constexpr (std::same_as<R, double>) {
    // Decimal numbers within range; what else the next ones know: signs in front, hexadecimal digits, infinities.
    double x = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (error == std::errc() && end == text.data() + text.size()) return x;
  }
#ifdef CAGEPROOF_NO_MPFR
  if constexpr (is_multiprecision<R>) return parsed<R>(text);
#endif
  const std::string copy(text);
  char* end = nullptr;
  R x{};
  if constexpr (std::same_as<R, float>) x = std::strtof(copy.c_str(), &end);
  else if constexpr (std::same_as<R, double>) x = std::strtod(copy.c_str(), &end);
#ifndef CAGEPROOF_NO_MPFR
  else mpfr_strtofr(x.data(), copy.c_str(), &end, 0, MPFR_RNDN);
#endif
  if (end != copy.c_str() + copy.size()) return std::nullopt;
  return x;
}

namespace {

template <Scalar R>
std::string scientific(const R& x, int digits) {
#ifdef CAGEPROOF_NO_MPFR
  return number_of(x).str(digits - 1, std::ios_base::scientific);
#else
  std::array<char, 256> text{};
  mpfr_snprintf(text.data(), text.size(), "%.*Re", digits - 1, x.data());
  return text.data();
#endif
}

}  // namespace

std::string format_digits(const Mp100& x, int digits) { return isfinite(x) ? scientific(x, digits) : format_scalar(x); }

template <Scalar R>
std::string format_scalar(const R& x) {
  using std::isfinite, std::isnan;
  if (isnan(x)) return "nan";
  if (!isfinite(x)) return x > 0 ? "inf" : "-inf";
  if constexpr (is_multiprecision<R>) {
    return scientific(x, std::numeric_limits<R>::max_digits10);
  } else {
    return fmt::format("{}", x);
  }
}

std::string format_hex(double x) { return std::isfinite(x) ? fmt::format("{:a}", x) : format_scalar(x); }

#define CAGEPROOF_INSTANTIATE(R)                               \
  template std::optional<R> parse_scalar<R>(std::string_view); \
  template std::string format_scalar<R>(const R&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof
