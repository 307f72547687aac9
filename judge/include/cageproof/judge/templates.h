// SPDX-License-Identifier: MIT
// Complete examples of foreign code, for users to begin with.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::judge {

/// The languages of the examples: "c", "cpp", "python"; "python-cage" has coordinates of whole cages.
const std::vector<std::string_view>& template_languages();

/// File names and contents of an example. Those of segment.winding_angle and mean_value are clean, that of
/// triangle.solid_angle is wrong on edges, and says so; others decline all inputs until a user's function is put in,
/// and say so. \param subject a formula, for "python-cage" a kind of coordinates or kSides; empty for the usual one
/// \pre language is one of template_languages() \throws InputError for another subject
std::vector<std::pair<std::string_view, std::string>> template_files(std::string_view language,
                                                                     std::string_view subject = {});

}  // namespace cageproof::judge
