// SPDX-License-Identifier: MIT
// Derivatives of single and double layers by the corners of their element.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>

namespace cageproof::fast {

/// Gradients by each of the element's corners; in the plane of two corners, and with third numbers of zero.
struct LayerSlopes {
  std::array<Vec3<double>, 3> single = {};                  ///< [by corner], of the single layer
  std::array<std::array<Vec3<double>, 3>, 3> doubled = {};  ///< [corner of the hat function][by corner]
};

/// Slopes of the triangle's `triangle.single_layer` and `triangle.double_layer`, by Stokes' theorem: with u a corner's
/// hat function, constant along the normal n, u dG/dn - G du/dn has a flux without divergence, so that moving the
/// triangle changes it by line integrals over the sides (of G and 1/r^3 with hat functions), and by what u changes. Far
/// away the terms cancel, and a product Gauss rule takes their place. On sides and corners NaN: there is no derivative.
/// \param single, doubled the layers at the point \pre the corners are not in line
LayerSlopes triangle_layer_slopes(const std::array<Vec3<double>, 3>& corners, const Vec3<double>& point, double single,
                                  const std::array<double, 3>& doubled);

/// Slopes of `segment.single_layer` and `segment.double_layer`, likewise; integrals over sides are values at ends.
LayerSlopes segment_layer_slopes(const std::array<Vec3<double>, 2>& corners, const Vec3<double>& point, double single,
                                 const std::array<double, 2>& doubled);

}  // namespace cageproof::fast
