// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace cageproof::validation {

/// What the linker hashed the program to: programs that differ differ here; "unknown" where it did not.
std::string build_id();

}  // namespace cageproof::validation
