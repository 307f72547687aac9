// SPDX-License-Identifier: MIT
// How a pose turns and stretches vertices and elements ([C23] Section 4.2).
#pragma once

#include "cageproof/deformation/deformer.h"

#include <functional>

namespace cageproof::deformation {

/// A vector in as many dimensions as the space has.
template <Scalar R>
Eigen::Matrix<R, Eigen::Dynamic, 1> in(int dimension, const Vec3<R>& v) {
  return v.head(dimension);
}

template <Scalar R>
std::vector<Vec3<R>> over(std::vector<Vec3<R>> points, const R& unit) {
  for (Vec3<R>& p : points) p /= unit;
  return points;
}

/// The area of a triangle whose vertices are elsewhere, or the length of a segment.
template <Scalar R>
R measure(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element);

/// A rotation a vertex and element, and a stretch an element.
template <Scalar R>
struct Turns {
  std::vector<Matrix<R>> of_vertices, of_elements;
  std::vector<R> stretches;
};

/// Those of one similarity for all (blend 0), of each element and, nearest to the sum of its elements', of each vertex
/// (blend 1), or between these. \param from, posed in a unit of about the cage's size
/// \param stretches of elements, asked for where they are needed \param warnings takes rotations that are not unique
template <Scalar R>
Turns<R> turns_of(const CageElements& rest, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed,
                  const std::function<std::vector<R>()>& stretches, double blend, std::vector<std::string>& warnings);

/// Those of each vertex alone, for a blend of one. \throws InputError for an element without a normal
template <Scalar R>
std::vector<Matrix<R>> vertex_rotations(const CageElements& rest, const std::vector<Vec3<R>>& posed,
                                        std::vector<std::string>& warnings);

}  // namespace cageproof::deformation
