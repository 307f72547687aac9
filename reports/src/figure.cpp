// SPDX-License-Identifier: MIT
#include "figure.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace cageproof::reports {

std::string short_error(double error) {
  if (std::isnan(error)) return "nan";
  if (std::isinf(error)) return "inf";
  if (error <= 0) return "0";
  int exponent = static_cast<int>(std::floor(std::log10(error)));
  // A value that equals two digits up to its last bits stays as it is.
  const long double scaled = error / std::pow(10.0L, exponent - 1) * (1 - 1e-9L);
  int digits = static_cast<int>(std::ceil(scaled));
  if (digits >= 100) digits = 10, ++exponent;
  if (exponent >= 1 && exponent <= 2) return fmt::format("{}", exponent == 1 ? digits : digits * 10);
  std::string mantissa =
      digits % 10 == 0 ? fmt::format("{}", digits / 10) : fmt::format("{}.{}", digits / 10, digits % 10);
  if (exponent == 0) return mantissa;
  if (exponent == -1) return digits % 10 == 0 ? fmt::format("0.{}", digits / 10) : fmt::format("0.{}", digits);
  return fmt::format("{}e{}", mantissa, exponent);
}

std::string digits_kept(double relative, std::string_view scalar) {
  if (!std::isfinite(relative)) return "0";
  if (relative < std::ldexp(1.0, scalar == "float" ? -24 : -53)) return "all";
  return fmt::format("{:.3g}", std::max(0.0, std::floor(-10 * std::log10(relative)) / 10));
}

std::string short_number(double x) {
  if (!std::isfinite(x) || x == 0) return fmt::format("{}", x);
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
  if (exponent >= -2 && exponent <= 3) return fmt::format("{:.4g}", x);
  const std::string mantissa = fmt::format("{:.4g}", static_cast<double>(x / std::pow(10.0L, exponent)));
  if (mantissa.ends_with("10")) return fmt::format("{}e{}", mantissa.substr(0, mantissa.size() - 1), exponent + 1);
  return fmt::format("{}e{}", mantissa, exponent);
}

std::string grouped(std::uint64_t count) {
  std::string text = fmt::format("{}", count);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3) text.insert(i, 1, ',');
  return text;
}

std::string_view order_name(int order) {
  constexpr std::array<std::string_view, 3> names{"value", "gradient", "Hessian"};
  return order >= 0 && order < 3 ? names[order] : "?";
}

std::string file_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    result += plain ? c : '-';
  }
  if (result.empty() || result.front() == '.') result.insert(0, 1, '_');
  return result;
}

}  // namespace cageproof::reports
