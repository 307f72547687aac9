// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace cageproof::cli {

/// The catalogue as JSON text, with scalars, ranges and descriptions.
std::string catalogue_json();

}  // namespace cageproof::cli
