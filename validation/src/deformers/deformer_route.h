// SPDX-License-Identifier: MIT
// Which second route a deformer has, by what its parameters mean.
#pragma once

#include "deformer_checks.h"
#include "second_routes/layer_route.h"

#include <optional>

namespace cageproof::validation {

/// What the variant's route solves; nothing for methods, and for variants, that have none.
std::optional<second_routes::LayerMethod> layer_method_of(const DeformerVariant& variant, double cage_size);

}  // namespace cageproof::validation
