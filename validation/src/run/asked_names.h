// SPDX-License-Identifier: MIT
// Whether the names that a run is asked for exist.
#pragma once

#include "cageproof/validation/verify.h"

namespace cageproof::validation {

/// Each name and glob of the options must mean something: of evaluations, something that one of the formulas asked for
/// has, or that computes coordinates which sum one of them. \throws InputError says what would have been right
void require_known_names(const VerifyOptions& options);

}  // namespace cageproof::validation
