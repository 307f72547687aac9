// SPDX-License-Identifier: MIT
// Names that end in a number: gauss-16, line-12.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace cageproof {

/// The number after `prefix` in `name`, at least one, written without sign or leading zeros; nothing for other names.
inline std::optional<int> number_after(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix)) return std::nullopt;
  const std::string_view digits = name.substr(prefix.size());
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.starts_with('0') || number < 1)
    return std::nullopt;
  return number;
}

}  // namespace cageproof
