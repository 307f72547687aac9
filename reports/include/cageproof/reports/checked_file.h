// SPDX-License-Identifier: MIT
// Files that are written as a whole, with every step checked.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// Writes a whole file.
/// \throws InputError "cannot write <path>: <reason>"
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Writes a whole file aside and renames it into place: whoever reads it finds the old one or the new one, whole.
/// \throws InputError as write_file
void replace_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cageproof::reports
