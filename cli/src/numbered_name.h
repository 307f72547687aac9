// SPDX-License-Identifier: MIT
// Names of files that have a place for a number: {n}, or {n:03d} for at least three digits, with zeros in front.
#pragma once

#include <cstddef>
#include <string>

namespace cageproof::cli {

/// The name with the number in every such place. \pre require_marks takes the name
std::string numbered(const std::string& name, std::size_t number);

/// The name without such places.
std::string without_marks(const std::string& name);

/// Whether it has such a place.
bool has_mark(const std::string& name);

/// \throws InputError naming the option, for a place of another form, such as {n:3}
void require_marks(const std::string& option, const std::string& name);

}  // namespace cageproof::cli
