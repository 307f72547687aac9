// SPDX-License-Identifier: MIT
// What help calls the values of options, and the names that each may be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cageproof::cli {

/// The names that completion offers for a value: of FORMULA, EVALUATION, REGIME, CHECK, KIND, METHOD, CAGE and SCALAR
/// those of the catalogue, of NAME all but evaluations; also under the plural, which is a list of names and globs. None
/// for other words.
std::vector<std::string> names_of_type(std::string_view type);

/// Whether a value of that name is a list of names and globs: NAMES, FORMULAS, EVALUATIONS, REGIMES, CHECKS.
bool is_list_type(std::string_view type);

/// Whether it is a file's name (FILE, and CAGE besides the embedded ones), and whether a folder's (FOLDER).
bool is_file_type(std::string_view type);
bool is_folder_type(std::string_view type);

}  // namespace cageproof::cli
