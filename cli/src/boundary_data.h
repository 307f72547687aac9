// SPDX-License-Identifier: MIT
// Data that a user gives on a cage's boundary, and the functions that coordinates make of them.
#pragma once

#include "coordinate_table.h"

namespace cageproof::cli {

/// Numbers for every coordinate of a kind: [coordinate][function]; of kinds with several blocks one block after the
/// other, as values at vertices, then derivatives along edges' outward normals ([W12] Eq 4).
struct BoundaryData {
  std::vector<double> numbers;
  std::size_t functions = 0;
};

/// Text with one line per coordinate and numbers between commas or blanks, as many on each line. A first line without
/// numbers, empty lines and text after # are passed over. \throws InputError naming file and line for anything else,
/// for another number of lines than coordinates, and for coordinates that are matrices
BoundaryData read_boundary_data(const std::filesystem::path& file, const CageCoordinates& coordinates);

/// The columns of sums of coordinates times data, with derivatives: `f_0`, `f_0_dx` ..., one group per function and
/// order.
CoordinateColumns function_columns(const CageCoordinates& coordinates, int order, const BoundaryData& data);

/// Functions that are sums of coordinates times data. \param rows of all coordinates up to that order
std::vector<double> functions_of(std::span<const double> rows, const CageCoordinates& coordinates, int order,
                                 const BoundaryData& data);

}  // namespace cageproof::cli
