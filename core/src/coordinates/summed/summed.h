// SPDX-License-Identifier: MIT
// Coordinates that are sums over a cage's elements.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof {

/// \throws InputError as CageCoordinates's constructor for evaluations and parameters
std::shared_ptr<const PreparedCoordinates> prepare_sum(const CoordinateKind& kind,
                                                       std::shared_ptr<const CageElements> elements,
                                                       const CoordinateOptions& options);

}  // namespace cageproof
