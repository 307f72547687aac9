// SPDX-License-Identifier: MIT
// One line per check that says what it compares, for readers who see its name in a table.
#pragma once

#include <string>
#include <string_view>

namespace cageproof::reports {

/// "the vertices' coordinates sum to one"; empty for a check that is not known. docs/errors.md has the definitions.
std::string_view words_of_check(std::string_view check);

/// A check's name as HTML, which may break after an underscore: "partition_<wbr>of_<wbr>unity".
std::string breakable(std::string_view name);

}  // namespace cageproof::reports
