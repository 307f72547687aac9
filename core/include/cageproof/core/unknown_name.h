// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/input_error.h"

#include <string_view>
#include <vector>

namespace cageproof {

/// The error to throw for a name that nothing has: "unknown check 'x'; see `cageproof list`".
/// \param what is named: "formula" \param known all names that there are, when they are few and the catalogue does not
/// list them: "unknown scalar 'x'; known: float, double"
InputError unknown_name(std::string_view what, std::string_view name, const std::vector<std::string_view>& known = {});

}  // namespace cageproof
