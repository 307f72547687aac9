// SPDX-License-Identifier: MIT
// How far coordinates at a point are from what they must give: partition of unity, linear reproduction, the truth.
#pragma once

#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/cage_terms.h"

#include <array>
#include <optional>

namespace cageproof::validation {

/// Errors of one kind of coordinates at one point. NaN: not asked there.
struct CageErrors {
  /// By order: |sum of phi - 1| (0 outside); relative ones of derivatives over the sum of their norms.
  std::array<CageError, 3> partition;
  /// By order: |sum - x|, relative ones over the cage's size; of derivatives over the sum of their norms.
  std::array<CageError, 3> reproduction;
  /// Norm-wise over a block: |trace of Hessian - partner|, relative ones over |Hessian|; the worst block.
  CageError laplacian;
  /// How far below zero the least coordinate of a vertex is, zero where none is; of kinds with one number per vertex.
  CageError negative;
};

/// Partition of unity and linear reproduction at one point.
/// All NaN where the kind says that points may have no coordinates, and this one has none.
/// \param expected 1 inside and on the cage (and anywhere for normalised kinds), 0 outside
/// \param terms of the kind in the cage; null where nobody asks for roundings, and on the cage: then the coordinates
/// themselves are the terms
CageErrors errors_at(const CageCoordinates& coordinates, const Cage& cage, const Vec3<double>& point, double expected,
                     int order, const CageTerms* terms = nullptr);

/// The same of coordinates that were computed there, without terms. \param blocks of the point, up to that order
CageErrors errors_of(const CageCoordinates& coordinates, const Cage& cage, const std::vector<Result<double>>& blocks,
                     const Vec3<double>& point, double expected, int order);

/// How far solved coordinates are from the data that they were solved for, in values and in gradients, as
/// SolvedSystem says it; nothing of kinds that do not measure it.
std::array<std::optional<double>, 2> boundary_residuals(const CageCoordinates& coordinates);

/// The coordinates that a positive kind is made from, of kinds that points inside may lack
/// (CoordinateKind::missing_because, not inside_alone).
std::optional<CageCoordinates> prior_of(const Cage& cage, const CoordinateKind& kind, Triangulation rule);

/// Whether a point may have no coordinates: of kinds that points may lack, where not all of the prior's are positive.
/// Elsewhere the point is a mean of all vertices with positive weights, and so in the convex hull that the kind needs.
/// \param prior prior_of() the kind
bool may_be_missing(const std::optional<CageCoordinates>& prior, const Vec3<double>& point);

/// The sum that partition of unity and linear reproduction must give at a place: 1 inside and on the cage, 0 outside.
/// Normalised kinds sum to 1 everywhere.
double expected_sum(const CoordinateKind& kind, Place place);

/// The same at a point off the cage whose faces may cross each other: the number of times that it winds around the
/// point.
double expected_sum(const CoordinateKind& kind, const CageLocator& locator, const Vec3<double>& point);

/// Truth at one point against the recommended evaluation: error, norm-wise, of the worst block, by order.
/// \param terms as of errors_at
std::array<CageError, 3> truth_errors_at(const CageCoordinates& coordinates, const CageCoordinates& reference,
                                         const Vec3<double>& point, int order, const CageTerms* terms = nullptr);

}  // namespace cageproof::validation
