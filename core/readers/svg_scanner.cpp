// SPDX-License-Identifier: MIT
#include "svg_scanner.h"

#include "cage/mesh_files.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cageproof::svg {
namespace {

using exact::Integer;

constexpr std::string_view kBlanks = " \t\n\f\r", kDigits = "0123456789";

// A number's parts as they are written.
struct Decimal {
  bool negative = false;
  std::string digits;  // without the point
  long exponent = 0;   // of the last digit
};

Rational value_of(const Decimal& number) {
  // A leading zero would make the digits octal.
  const std::size_t first = number.digits.find_first_not_of('0');
  if (first == std::string::npos) return 0;
  const Integer digits(number.digits.substr(first));
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(number.exponent)));
  const Rational value = number.exponent < 0 ? Rational(digits, power) : Rational(digits * power);
  return number.negative ? Rational(-value) : value;
}

}  // namespace

bool Scanner::at_end() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  return rest_.empty();
}

bool Scanner::take(char expected) {
  if (at_end() || rest_.front() != expected) return false;
  skip();
  return true;
}

std::string_view Scanner::take_word() {
  at_end();
  const auto end =
      std::ranges::find_if_not(rest_, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
  const std::string_view word = rest_.substr(0, end - rest_.begin());
  rest_.remove_prefix(word.size());
  return word;
}

void Scanner::separate() {
  take(',');
  at_end();
}

bool Scanner::has_number() { return !at_end() && std::string_view("+-.0123456789").find(rest_.front()) != rest_.npos; }

std::size_t Scanner::digits_from(std::size_t begin) const {
  return std::min(rest_.find_first_not_of(kDigits, begin), rest_.size());
}

Rational Scanner::number() {
  if (at_end()) throw Fault{"a number is missing at the end"};
  const auto next_is = [&](std::size_t at, std::string_view any) {
    return at < rest_.size() && any.find(rest_[at]) != any.npos;
  };
  Decimal parts{rest_.front() == '-', "", 0};
  const std::size_t whole = next_is(0, "+-") ? 1 : 0, point = digits_from(whole);
  std::size_t end = point;
  parts.digits = rest_.substr(whole, point - whole);
  // "1." is a number of CSS no more than of SVG 1.1, but programs write it.
  if (next_is(point, ".")) {
    end = digits_from(point + 1);
    const std::string_view fraction = rest_.substr(point + 1, end - point - 1);
    parts.digits += fraction;
    parts.exponent = -static_cast<long>(fraction.size());
  }
  if (parts.digits.empty()) throw Fault{"a number is missing at " + shown()};
  const std::size_t after_e = next_is(end + 1, "+-") ? end + 2 : end + 1;
  const bool has_exponent = next_is(end, "eE") && next_is(after_e, kDigits);
  const std::size_t last = has_exponent ? digits_from(after_e) : end;
  const std::string_view token = rest_.substr(0, last);
  const std::optional<double> rounded = parse_scalar<double>(token);
  if (!rounded || !std::isfinite(*rounded)) throw Fault{mesh_files::shown(token) + " is beyond the range of double"};
  if (has_exponent) {
    const std::string_view digits = rest_.substr(end + 1, last - end - 1);
    long exponent = 0;
    std::from_chars(digits.data() + (digits.front() == '+' ? 1 : 0), digits.data() + digits.size(), exponent);
    parts.exponent += exponent;
  }
  rest_.remove_prefix(last);
  // A number that rounds to zero in double is taken as zero, because its power of ten may not fit in memory.
  return *rounded == 0 ? Rational(0) : value_of(parts);
}

std::string Scanner::shown() const {
  constexpr std::size_t longest = 20;
  return mesh_files::shown(std::string(rest_.substr(0, longest)) + (rest_.size() > longest ? "..." : ""));
}

}  // namespace cageproof::svg
