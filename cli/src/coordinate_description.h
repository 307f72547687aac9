// SPDX-License-Identifier: MIT
// Facts for someone who wants to apply coordinates and has only their file: the owner of each column, the elements
// used, their normals, and the conventions.
#pragma once

#include "coordinate_table.h"

#include "cageproof/reports/cage_vtp.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace cageproof::cli {

inline constexpr std::string_view coordinates_schema = "cageproof-coordinates";

/// Inputs of the command, for the description.
struct DescribedRun {
  std::string cage_file, points_file, triangulation, data_file;
  std::vector<double> parameters;  ///< in the order of parameters_of(kind); empty for their defaults
  int order = 0;
  double merge = std::numeric_limits<double>::quiet_NaN(), on = 0;  ///< of --merge and --on
};

/// The elements that coordinates belong to, as others take them; without metadata.
reports::DescribedCage described_cage(const CageCoordinates& coordinates, const Cage& cage, Triangulation rule);

/// All but the geometry: kind, parameters, evaluation, conventions, blocks, and where each of them stands in a row.
nlohmann::ordered_json description_of(const CageCoordinates& coordinates, const CoordinateColumns& table,
                                      const DescribedRun& run);

/// The geometry as JSON, for formats that have no place for it.
nlohmann::ordered_json geometry_json(const reports::DescribedCage& cage);

}  // namespace cageproof::cli
