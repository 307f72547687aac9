// SPDX-License-Identifier: MIT
#pragma once

#include <vtksys/Base64.h>

#include <string>
#include <string_view>

namespace cageproof::reports {

/// Bytes as text that a page can hold.
inline std::string base64(std::string_view bytes) {
  std::string text(bytes.size() / 3 * 4 + 8, '\0');
  text.resize(vtksysBase64_Encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                                  reinterpret_cast<unsigned char*>(text.data()), 0));
  return text;
}

}  // namespace cageproof::reports
