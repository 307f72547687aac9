// SPDX-License-Identifier: MIT
// Words for the values of options in help, and the names that each value may be.
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

/// Whether a value is a file's name (FILE, and CAGE except the embedded ones), and whether it is a folder's (FOLDER).
bool is_file_type(std::string_view type);
bool is_folder_type(std::string_view type);

}  // namespace cageproof::cli
