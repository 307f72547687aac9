// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::cli {

/// Where a file is, whatever links lead to it; of pipes, which have no place, the name that is given.
std::filesystem::path place_of(const std::filesystem::path& file);

/// A folder is written anew, and must not hold what is read. \param inputs files or folders, which may be empty, and
/// the options that name them \throws InputError names the option
void require_outside(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& inputs);

/// Standard input can be read once. \param inputs files and the options that name them
/// \throws InputError naming two options that read it
void require_one_reader_of_input(const std::vector<std::pair<std::string, std::string>>& inputs);

}  // namespace cageproof::cli
