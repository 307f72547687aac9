// SPDX-License-Identifier: MIT
// Posed elements that numbers are too small for.
#pragma once

#include "cageproof/core/input_error.h"
#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/numbers/scalar.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof::deformation {

/// \param edge the largest number of an element's posed edges \throws InputError, naming the element, where it is not
/// finite, as differences of finite numbers may be
template <Scalar R>
void check_range(const CageElements& rest, std::size_t element, const R& edge) {
  if (edge - edge == 0) return;
  throw InputError(fmt::format(
      "the posed {} {} (vertices {}) has edges that are longer than the largest number of double, 1.8e308; scale the "
      "pose down",
      rest.type(element).name, element, fmt::join(rest.vertices_of(element), ", ")));
}

}  // namespace cageproof::deformation
