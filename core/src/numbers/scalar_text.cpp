// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/scalar_text.h"

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
  const std::string copy(text);
  char* end = nullptr;
  R x{};
  if constexpr (std::same_as<R, float>) x = std::strtof(copy.c_str(), &end);
  else if constexpr (std::same_as<R, double>) x = std::strtod(copy.c_str(), &end);
  else mpfr_strtofr(x.data(), copy.c_str(), &end, 0, MPFR_RNDN);
  if (end != copy.c_str() + copy.size()) return std::nullopt;
  return x;
}

namespace {

template <Scalar R>
std::string scientific(const R& x, int digits) {
  std::array<char, 256> text{};
  mpfr_snprintf(text.data(), text.size(), "%.*Re", digits - 1, x.data());
  return text.data();
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
