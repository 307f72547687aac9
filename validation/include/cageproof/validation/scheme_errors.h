// SPDX-License-Identifier: MIT
// How far the scheme of a kind is from what it approximates (CoordinateKind::approximates). Rounding has no share in
// it that would be seen, and what it is measured with is good to worst_truth.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <optional>

namespace cageproof::validation {

/// Of what schemes are measured with: how far it may be from its own data, a tenth of what schemes miss by.
inline constexpr double worst_truth = 1e-3;

/// What the kind approximates, in the cage; nothing where it approximates no kind, or one that refuses the cage or that
/// is itself farther than worst_truth from its data on the boundary.
std::optional<CageCoordinates> approximated_by(const Cage& cage, const CoordinateKind& kind, Triangulation rule);

/// By order the largest difference of a coordinate, in units of the cage's size to the power of its degree less the
/// order.
std::array<double, 3> scheme_errors_at(const CageCoordinates& coordinates, const CageCoordinates& approximated,
                                       const Cage& cage, const Vec3<double>& point, int order);

/// What the coordinates of a polygon miss at a point on it, of the data that define them ([W12] Eq 7): of values, which
/// are hat functions in the first block and zero in others; of normal derivatives, in units of values over the cage's
/// size, which are zero but for one on each edge of its own in the second block: only within edges, and of kinds that
/// have such a block. Laplacians are not looked at. Nothing at points that are not exactly on the cage.
std::optional<std::array<std::optional<double>, 2>> boundary_data_errors_at(const CageCoordinates& coordinates,
                                                                            const Cage& cage,
                                                                            const Vec3<double>& point);

}  // namespace cageproof::validation
