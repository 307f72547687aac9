// SPDX-License-Identifier: MIT
// Parts of the files of test vectors.
#pragma once

#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::judge {

/// A list of hexadecimal doubles.
inline std::string point_json(const Vec3<double>& p, int dim) {
  std::string text = "[";
  for (int k = 0; k < dim; ++k) text += fmt::format("{}\"{}\"", k ? "," : "", format_hex(p[k]));
  return text + "]";
}

inline std::string decimals(const std::vector<Mp100>& numbers, int digits) {
  std::string text = "[";
  for (const Mp100& x : numbers) text += fmt::format("{}\"{}\"", text.size() > 1 ? "," : "", format_digits(x, digits));
  return text + "]";
}

inline std::string json_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// x as a sum of two doubles, which keeps 31 digits.
inline std::array<double, 2> split(const Mp100& x) {
  const double high = static_cast<double>(x);
  return {high, static_cast<double>(x - Mp100(high))};
}

}  // namespace cageproof::judge
