// SPDX-License-Identifier: MIT
// The program as it runs beside foreign code: it starts the code in a session of its own, with limits, and ends
// whatever that leaves behind.
#pragma once

namespace cageproof::judge {

/// The first argument of a program that is to be a host; no user types it.
inline constexpr const char* host_argument = "judge-host";

/// Whether the program was started as a host.
bool is_host(int argc, const char* const* argv);

/// Keeps foreign code until it ends, or until the program that started the host goes away. \return the exit code
int run_host(int argc, const char* const* argv);

}  // namespace cageproof::judge
