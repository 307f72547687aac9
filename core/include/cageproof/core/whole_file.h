// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace cageproof {

/// Reads a whole file, which may be empty.
/// \throws InputError "cannot read <path>: <reason>"
std::string read_file(const std::filesystem::path& path);

}  // namespace cageproof
