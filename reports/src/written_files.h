// SPDX-License-Identifier: MIT
// The list, in a folder, of the files written into it. Other files there are somebody's, and nothing replaces them.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// The list's file, one path per line, relative to the folder.
inline constexpr const char* written_files_name = ".cageproof-files";

/// The files of a report that tell its verdict to machines: a run into its folder renames them as it begins.
inline constexpr std::array<std::string_view, 3> verdict_files{"summary.json.gz", "summary.md", "summary.json"};

/// The name of such a file from then on, until the run's own report replaces the folder.
inline std::string earlier_file(std::string_view name) { return "earlier." + std::string(name); }

/// The list for all that a folder holds. \throws InputError where it cannot be read
std::string list_of_files(const std::filesystem::path& folder);

/// The first entry of a folder that is not listed, not a folder of listed files and not a run's journal; empty where
/// there is none. Folders of earlier versions and of unfinished runs have no list: there it is a link, or anything in
/// folders of folders. \throws InputError where it cannot be read
std::string foreign_entry(const std::filesystem::path& folder);

}  // namespace cageproof::reports
