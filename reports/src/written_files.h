// SPDX-License-Identifier: MIT
// What was written into a folder, kept in it: what else is there is somebody's, and nothing replaces it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// The list's file, one path a line, relative to the folder.
inline constexpr const char* written_files_name = ".cageproof-files";

/// Of a report the files that tell its verdict to machines: a run into its folder renames them as it begins.
inline constexpr std::array<std::string_view, 3> verdict_files{"summary.json.gz", "summary.md", "summary.json"};

/// What such a file is called from then on, until the run's own report replaces the folder.
inline std::string earlier_file(std::string_view name) { return "earlier." + std::string(name); }

/// The list for all that a folder holds. \throws InputError where it cannot be read
std::string list_of_files(const std::filesystem::path& folder);

/// The first entry of a folder that is not on its list, nor a folder of such, nor a run's journal; empty where there is
/// none. Without a list, as earlier versions and runs that are under way have none: a link, or anything in folders of
/// folders. \throws InputError where it cannot be read
std::string foreign_entry(const std::filesystem::path& folder);

}  // namespace cageproof::reports
