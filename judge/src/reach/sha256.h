// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace cageproof::judge {

/// SHA-256 (FIPS 180-4) of some bytes, as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace cageproof::judge
