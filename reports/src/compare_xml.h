// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace cageproof::reports {

/// Text as XML has it, in attributes and between tags. Control characters, which XML cannot hold, become spaces.
inline std::string xml_text(std::string_view text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&') xml += "&amp;";
    else if (c == '<') xml += "&lt;";
    else if (c == '>') xml += "&gt;";
    else if (c == '"') xml += "&quot;";
    else xml += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return xml;
}

}  // namespace cageproof::reports
