// SPDX-License-Identifier: MIT
// The second route of a deformer, chosen by its parameters.
#pragma once

#include "deformer_checks.h"
#include "second_routes/layer_route.h"

#include <optional>

namespace cageproof::validation {

/// The method that the variant's route solves; nothing for methods and variants without a route.
std::optional<second_routes::LayerMethod> layer_method_of(const DeformerVariant& variant, double cage_size);

}  // namespace cageproof::validation
