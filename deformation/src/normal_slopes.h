// SPDX-License-Identifier: MIT
// The derivatives of posed normals by posed vertices.
#pragma once

#include "row_slopes.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {

/// Returns the slopes of stretched_normals(). Each row takes the vertices of its element. Exact to rounding; of rest
/// triangles whose edges are next to in line in 50 digits, as the normals are. \throws InputError, naming the element,
/// where a posed element has no area or length and its normal no derivative
template <Scalar R>
RowSlopes<R> stretched_normal_slopes(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices);

/// Slopes of quad_normals(), which are rows `row` to `row + 3`, added to the others.
template <Scalar R>
void add_quad_normal_slopes(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                            std::size_t element, std::size_t row, RowSlopes<R>& slopes);

/// Slopes of corner_normals(), whose rows take all vertices around their own.
template <Scalar R>
RowSlopes<R> corner_normal_slopes(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices);

/// \throws InputError that says that the normal has no derivative
[[noreturn]] void refuse_slope(const CageElements& rest, std::size_t element);

}  // namespace cageproof::deformation
