// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace cageproof::reports {

/// A field of a CSV line, quoted where RFC 4180 asks for it.
inline std::string csv_field(std::string_view field) {
  if (field.find_first_of(",\"\r\n") == field.npos) return std::string(field);
  std::string result = "\"";
  for (const char c : field) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace cageproof::reports
