// SPDX-License-Identifier: MIT
// Files that are written as a whole, with every step checked.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::reports {

/// Writes a whole file.
/// \throws InputError "cannot write <path>: <reason>"
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Checks result files before the work: that their folders exist and may be written to, that no file is a folder
/// itself, and that no two are the same file.
/// \throws InputError as write_file
void require_writable(const std::vector<std::filesystem::path>& paths);

/// Writes a whole file aside and renames it into place: whoever reads it finds the old one or the new one, whole. A
/// symbolic link stays, and what it leads to is replaced; a device, a pipe or an open file, as /dev/stdout, is written
/// to. \throws InputError as write_file
void replace_file(const std::filesystem::path& path, std::string_view bytes);

/// The same of several: none is renamed into place before all are written, and devices and pipes are written to last.
/// \throws InputError as well where two are the same file
void replace_files(const std::vector<std::pair<std::filesystem::path, std::string>>& files);

}  // namespace cageproof::reports
