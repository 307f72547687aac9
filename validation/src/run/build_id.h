// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace cageproof::validation {

/// The linker's hash of the program: different programs have different ones; "unknown" where the linker made none.
std::string build_id();

}  // namespace cageproof::validation
