// SPDX-License-Identifier: MIT
// The properties of cage coordinates on a whole cage, and the recommended evaluation against truth there.
#pragma once

#include "cageproof/core/coordinates.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/validation/cage_points.h"
#include "cageproof/validation/cage_terms.h"
#include "cageproof/validation/measurement.h"

#include <optional>

namespace cageproof::validation {

struct CageCampaignOptions {
  std::string evaluation;  ///< empty for each formula's recommended one
  std::string kinds = "*";
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 400;               ///< off the cage, for the properties
  int truth_points = 16;          ///< of these, compared with multiprecision
  int mesh_points = 0;            ///< of a mesh, at most, spread evenly; 0: all
  int on_points = 0;              ///< on the cage, at most, spread evenly; 0: all
  bool differences = true;        ///< whether derivatives are compared with differences in 100 digits
  bool properties_alone = false;  ///< only partition of unity and linear reproduction of values, off the cage
  /// Kinds whose densities are solved for on samples of the cage are asked with at most so many elements.
  int solved_elements = 12;
  int jobs = 0;
};

/// Whether a campaign asks the kind, if it accepts the cage: preparing kinds that solve on samples takes the square of
/// the number of elements times that of samples.
bool is_affordable(const CoordinateKind& kind, const Cage& cage, const CageCampaignOptions& options);

/// Errors of one kind of coordinates at one point. NaN: not asked there.
struct CageErrors {
  /// By order: |sum of phi - 1| (0 outside); relative ones of derivatives over the sum of their norms.
  std::array<CageError, 3> partition;
  /// By order: |sum - x|, relative ones over the cage's size; of derivatives over the sum of their norms.
  std::array<CageError, 3> reproduction;
  /// Norm-wise over a block: |trace of Hessian - partner|, relative ones over |Hessian|; the worst block.
  CageError laplacian;
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

/// What partition of unity and linear reproduction must give at a place: 1 inside and on the cage, 0 outside, but for
/// normalised kinds 1 everywhere.
double expected_sum(const CoordinateKind& kind, Place place);

/// The same at a point off the cage whose faces may cross each other: the number of times that it winds around the
/// point.
double expected_sum(const CoordinateKind& kind, const CageLocator& locator, const Vec3<double>& point);

/// For each order up to `order` the largest difference, in units of the cage's size, between the coordinates at a point
/// on the cage (hat functions for interpolating kinds) and those 1e-11 sizes inside it, which come from the formulas
/// alone; NaN off the cage. Those of derivatives of order k are multiplied by the (k + 1)th power of the distance to
/// the rest of the cage, in its sizes: derivatives change that much faster next to edges. Derivatives that the
/// coordinates do not have on the cage, NaN or infinite, are not compared. Nothing for orders of which none is left,
/// and for all where the rest of the cage is so near, within 1e-4 sizes, that coordinates change over that step, where
/// the inside overlaps another part, and where it is so sharp that a thousand directions miss it.
std::array<std::optional<double>, 3> inside_limit_errors_at(const CageCoordinates& coordinates, const Cage& cage,
                                                            const CageLocator& locator, const Vec3<double>& point,
                                                            int order);

/// One a kind that matches and has coordinates in the cage: partition_of_unity, linear_reproduction, zero_outside,
/// limit_from_inside, cage_laplacian, cage_truth and what CageSymmetries asks. \throws InputError when no kind does
Measurements cage_measurements(const std::shared_ptr<const Cage>& cage, const CageCampaignOptions& options);

/// Measures and judges them. \throws InputError as cage_measurements
std::vector<ResultRow> run_cage_campaign(const Cage& cage, const CageCampaignOptions& options);

/// The name in Findings::meshes of the mesh that a cage is tried at.
inline constexpr const char* mesh_measured = "mesh";

/// Its vertices and faces, found as Findings::meshes[mesh_measured].
std::unique_ptr<const Measurement> mesh_shape(std::shared_ptr<const Mesh> mesh);

/// Partition of unity and linear reproduction at a mesh's points (place `mesh`), and the errors by point as a field on
/// that mesh. \param place of the field in the report
std::unique_ptr<const Measurement> mesh_measurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind,
                                                    std::shared_ptr<const Mesh> mesh, const std::string& mesh_name,
                                                    int place, const CageCampaignOptions& options);

/// Truth at one point against the recommended evaluation: error, norm-wise, of the worst block, by order.
/// \param terms as of errors_at
std::array<CageError, 3> truth_errors_at(const CageCoordinates& coordinates, const CageCoordinates& reference,
                                         const Vec3<double>& point, int order, const CageTerms* terms = nullptr);

}  // namespace cageproof::validation
