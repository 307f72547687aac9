// SPDX-License-Identifier: MIT
// Distance of a kind's scheme from the kind that it approximates (CoordinateKind::approximates). Rounding is negligible
// in it, and its own measure is good to worst_truth.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <optional>

namespace cageproof::validation {

/// Largest error of the measure of schemes in its own data: a tenth of the usual error of schemes.
inline constexpr double worst_truth = 1e-3;

/// Coordinates that the kind approximates in the cage. Nothing where it approximates no kind, or one that refuses the
/// cage or is itself farther than worst_truth from its data on the boundary.
std::optional<CageCoordinates> approximated_by(const Cage& cage, const CoordinateKind& kind, Triangulation rule);

/// By order the largest difference of a coordinate, in units of the cage's size to the power of its degree less the
/// order.
std::array<double, 3> scheme_errors_at(const CageCoordinates& coordinates, const CageCoordinates& approximated,
                                       const Cage& cage, const Vec3<double>& point, int order);

/// Errors of a polygon's coordinates at a point on it, in the data that define them ([W12] Eq 7). Values are hat
/// functions in the first block and zero in others. Normal derivatives, in units of values over the cage's size, are
/// one for the edge's own coordinate in the second block and zero for all others; only within edges, and for kinds with
/// such a block. Laplacians are not compared. Nothing at points that are not exactly on the cage.
std::optional<std::array<std::optional<double>, 2>> boundary_data_errors_at(const CageCoordinates& coordinates,
                                                                            const Cage& cage,
                                                                            const Vec3<double>& point);

}  // namespace cageproof::validation
