// SPDX-License-Identifier: MIT
// The sources, compiler and options that this program was built from.
#pragma once

#include <string_view>

namespace cageproof {

/// The commit of the sources, with "-dirty" where they differed from it; "unknown" where they came without one.
std::string_view build_commit();

/// Build type and compiler flags that hold for all sources: "Release: -O3 -DNDEBUG -ffp-contract=off ...".
std::string_view build_flags();

}  // namespace cageproof
