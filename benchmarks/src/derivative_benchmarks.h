// SPDX-License-Identifier: MIT
// Products with derivatives by the cage's vertices, in turns with the values that they are derivatives of.
#pragma once

#include "deformer_benchmarks.h"

namespace cageproof::benchmarks {

/// Registers, for every method that takes the cage and has derivatives by the posed cage,
///   `derivative/<cage>/<method>/pose`  the derivative of the pose, once
///   `derivative/<cage>/<method>/jvp`   its product with a change of the vertices, at all points
///   `derivative/<cage>/<method>/vjp`   its transposed product with weights of all points
/// from coordinates that are there already, and for every kind that has derivatives by its own cage
///   `derivative/<cage>/<kind>/rest_jvp`, `derivative/<cage>/<kind>/rest_vjp`
/// on as many points, spread evenly, as make some ten thousand pairs. One thread. Counters: `ns_per_point` (processor
/// time), and `ratio`, that time over the time of the images from the same coordinates, or of the coordinates' values
/// by their quickest evaluation, measured in turns. \returns the names, in order of registration
std::vector<std::string> register_derivative_benchmarks(const std::shared_ptr<const DeformedCage>& what);

}  // namespace cageproof::benchmarks
