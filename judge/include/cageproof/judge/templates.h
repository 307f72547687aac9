// SPDX-License-Identifier: MIT
// Complete examples of foreign code, for users to begin with.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::judge {

/// The languages of the examples: "c", "cpp", "python".
const std::vector<std::string_view>& template_languages();

/// File names and contents of an example. \pre language is one of template_languages()
std::vector<std::pair<std::string_view, std::string_view>> template_files(std::string_view language);

}  // namespace cageproof::judge
