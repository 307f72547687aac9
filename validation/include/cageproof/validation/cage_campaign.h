// SPDX-License-Identifier: MIT
// The properties of cage coordinates on a whole cage, and closed form against truth there.
#pragma once

#include "cageproof/core/coordinates.h"
#include "cageproof/core/run_result.h"
#include "cageproof/validation/cage_points.h"

#include <functional>

namespace cageproof::validation {

struct CageCampaignOptions {
  std::string evaluation = "closed_form";
  std::string kinds = "*";
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 400;       ///< off the cage, for the properties
  int truth_points = 16;  ///< of these, compared with multiprecision
  bool properties_alone = false;  ///< only partition of unity and linear reproduction of values, off the cage
  int jobs = 0;
};

/// Errors of one kind of coordinates at one point. NaN: not asked there.
struct CageErrors {
  std::array<double, 3> partition;     ///< by order: |sum of phi - 1| (0 outside); derivatives over the sum of their norms
  std::array<double, 3> reproduction;  ///< by order: |sum - x| over the cage's size; derivatives over the sum of their norms
  double laplacian;  ///< norm-wise over a block: |trace of Hessian - partner| over |Hessian|; the worst block
};

/// Partition of unity and linear reproduction at one point.
/// All NaN where the kind says that points may have no coordinates, and this one has none.
/// \param expected 1 inside and on the cage (and anywhere for normalised kinds), 0 outside
CageErrors errors_at(const CageCoordinates& coordinates, const Cage& cage, const Vec3<double>& point, double expected,
                     int order);

/// What partition of unity and linear reproduction must give at a place: 1 inside and on the cage, 0 outside, but for normalised
/// kinds 1 everywhere.
double expected_sum(const CoordinateKind& kind, Place place);

/// Largest difference, in units of the cage's size, between the coordinates at a point on the cage (hat functions for interpolating kinds)
/// and those 1e-11 sizes inside it, which come from the formulas alone; NaN off the cage.
double inside_limit_error_at(const CageCoordinates& coordinates, const Cage& cage, const CageLocator& locator,
                             const Vec3<double>& point);

/// Rows of one cage: partition_of_unity, linear_reproduction, zero_outside, limit_from_inside, cage_laplacian, cage_truth.
std::vector<ResultRow> run_cage_campaign(const Cage& cage, const CageCampaignOptions& options);

/// Rows of partition of unity and linear reproduction at a mesh's points (place `mesh`), and the errors by point for a picture.
struct MeshErrors {
  std::vector<ResultRow> rows;
  MeshField field;  ///< without faces
};
MeshErrors run_mesh_campaign(const Cage& cage, const std::vector<Vec3<double>>& points, const CageCampaignOptions& options);

/// Truth at one point against the closed form: relative error, norm-wise, of the worst block, by order.
std::array<double, 3> truth_errors_at(const CageCoordinates& coordinates, const CageCoordinates& reference,
                                      const Vec3<double>& point, int order);

}  // namespace cageproof::validation
