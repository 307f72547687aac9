// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cageproof::cli {

/// A folder is written anew, and must not hold what is read. \param inputs files or folders, which may be empty, and
/// the options that name them \throws InputError names the option
void require_outside(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& inputs);

}  // namespace cageproof::cli
