// SPDX-License-Identifier: MIT
// The properties of cage coordinates on a whole cage, and the recommended evaluation against truth there.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/validation/measurement.h"

namespace cageproof::validation {

struct CageCampaignOptions {
  std::string evaluation;  ///< empty for each formula's recommended one
  std::string kinds = "*";
  Triangulation triangulation = Triangulation::Shortest;
  std::uint64_t seed = 1;
  int points = 400;               ///< off the cage, for the properties
  int truth_points = 16;          ///< of these, compared with multiprecision
  int mesh_points = 0;            ///< of a mesh, at most, spread evenly; 0: all
  int on_points = 0;              ///< on the cage, at most, spread evenly over each place; 0: all
  bool differences = true;        ///< whether derivatives are compared with differences in 100 digits
  bool signs = false;             ///< whether coordinates inside are asked whether they are negative
  bool one_per_place = false;     ///< off the cage, only the first of the points inside, and of those outside
  bool properties_alone = false;  ///< only partition of unity and linear reproduction of values, off the cage
  /// Kinds whose densities are solved for on samples of the cage are asked with at most so many elements.
  int solved_elements = 12;
  int jobs = 0;
};

/// Whether a campaign asks the kind, if it accepts the cage: preparing kinds that solve on samples takes the square of
/// the number of elements times that of samples.
bool is_affordable(const CoordinateKind& kind, const Cage& cage, const CageCampaignOptions& options);

/// One a kind that matches and has coordinates in the cage: partition_of_unity, linear_reproduction, zero_outside,
/// non_negativity (if signs are asked), limit_from_inside, cage_laplacian, cage_truth and what CageSymmetries asks.
/// \throws InputError when no kind does
Measurements cage_measurements(const std::shared_ptr<const Cage>& cage, const CageCampaignOptions& options);

/// Measures and judges them. \throws InputError as cage_measurements
std::vector<ResultRow> run_cage_campaign(const Cage& cage, const CageCampaignOptions& options);

/// The name in PartialResult::meshes of the mesh that a cage is tried at.
inline constexpr const char* mesh_measured = "mesh";

/// Its vertices and faces, found as PartialResult::meshes[mesh_measured].
std::unique_ptr<const Measurement> mesh_shape(std::shared_ptr<const Mesh> mesh);

/// Partition of unity and linear reproduction at a mesh's points (place `mesh`), and the errors by point as a field on
/// that mesh. \param place of the field in the report
std::unique_ptr<const Measurement> mesh_measurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind,
                                                    std::shared_ptr<const Mesh> mesh, const std::string& mesh_name,
                                                    int place, const CageCampaignOptions& options);

}  // namespace cageproof::validation
