// SPDX-License-Identifier: MIT
// Names for files that are written next to their place and renamed into it, and removal of those of killed processes.
#pragma once

#include <filesystem>

namespace cageproof::reports {

/// ".NAME.partial-PID-<n>@HOST" next to `path`: this process and machine, so that others can tell whether its maker
/// lives.
std::filesystem::path aside(const std::filesystem::path& path, int n);

/// Name of a folder between the two steps of its replacement, where it cannot be exchanged in one.
std::filesystem::path earlier(const std::filesystem::path& aside);

/// Removes what processes of this machine that are gone left next to `path`. A folder that such a process had moved out
/// of its place, and did not live to replace, goes back into it.
void remove_leftovers(const std::filesystem::path& path);

}  // namespace cageproof::reports
