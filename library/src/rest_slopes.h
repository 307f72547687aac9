// SPDX-License-Identifier: MIT
// Derivatives of a kind's coordinates by the vertices of its cage.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <span>
#include <vector>

namespace cageproof::library {

/// \throws InputError unless the coordinates have derivatives by the cage's vertices, naming the kinds that have
void check_rest_slopes(const CageCoordinates& coordinates);

/// The change of coordinates of points along a change of the vertices: [point][coordinate], blocks one after another.
/// \pre check_rest_slopes()
void rest_jvp(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
              std::span<const Vec3<double>> change, int threads, std::span<double> values);

/// The transposed derivative times weights [point][coordinate]: one row per vertex, the same bits with any number of
/// threads.
std::vector<Vec3<double>> rest_vjp(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                                   std::span<const double> weights, int threads);

}  // namespace cageproof::library
