// SPDX-License-Identifier: MIT
#include "command_numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cageproof::cli {
namespace {

// Above this number all doubles are whole, so that a number that is read may differ from the text.
constexpr double most_exact = 9007199254740992.;

// All of the text, or nothing.
template <class Number>
std::optional<Number> read(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> read_double(std::string_view text) {
  const auto value = read<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

std::string NumberBounds::words() const {
  std::string text = whole ? "a whole number" : "a finite number";
  if (std::isfinite(lowest) && std::isfinite(highest)) text += fmt::format(" from {} to {}", lowest, highest);
  return text;
}

std::string make_plain(std::string& text, const NumberBounds& bounds) {
  const auto value = read_double(text);
  const bool good = value && bounds.lowest <= *value && *value <= bounds.highest &&
                    (!bounds.whole || (std::floor(*value) == *value && std::abs(*value) <= most_exact));
  if (!good) return fmt::format("'{}' is not {}", text, bounds.words());
  text = bounds.whole ? fmt::format("{}", static_cast<std::int64_t>(*value)) : fmt::format("{}", *value);
  return {};
}

std::string make_plain_seed(std::string& text) {
  if (const auto value = read<std::uint64_t>(text)) {
    text = fmt::format("{}", *value);
    return {};
  }
  const auto value = read_double(text);
  if (!value || !(0 <= *value && *value <= most_exact) || std::floor(*value) != *value)
    return fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
  text = fmt::format("{}", static_cast<std::uint64_t>(*value));
  return {};
}

}  // namespace cageproof::cli
