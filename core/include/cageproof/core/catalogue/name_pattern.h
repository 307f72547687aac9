// SPDX-License-Identifier: MIT
// The one grammar for options that take several names: a list of names and globs between commas, "near-*,far".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

/// Whether `text` is one of a list's names, or matches one of its globs: `*` any characters, `?` one, `[ab]` one of
/// these. Blanks around commas do not count.
bool matches(std::string_view pattern, std::string_view text);

/// The names and globs of a list. \throws InputError where it is empty, or one between its commas is
std::vector<std::string> names_in(std::string_view pattern);

/// Whether it is a glob, and no plain name.
bool is_glob(std::string_view name);

/// Each name and glob of a list must be or match something.
/// \param what is named, for the message: "formula" \throws InputError as names_in, and as unknown_name
void require_known(std::string_view what, std::string_view pattern, const std::vector<std::string_view>& known);

}  // namespace cageproof
