// SPDX-License-Identifier: MIT
// The process that a library is loaded into.
#pragma once

namespace cageproof::judge {

/// Exit code of a library that cannot be loaded; standard error has the reason.
inline constexpr int cannot_load = 120;

/// Loads a library and answers requests through the shared memory, until there are no more. \return the exit code
int serve_library(const char* path);

}  // namespace cageproof::judge
