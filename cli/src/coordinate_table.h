// SPDX-License-Identifier: MIT
// Coordinates of many points as one table, and its text in each file format.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/reports/cage_vtp.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cageproof::cli {

/// One row per point. Columns: block by block; in a block all values, then all first derivatives, then all second ones,
/// as far as they are asked for: `phi_0`, `phi_0_dx`, `phi_0_dxy`; of matrices `T_0_xy`, `T_0_xy_dz`, `T_0_xy_dzz`.
struct CoordinateColumns {
  std::vector<std::string> names;
  std::vector<double> values;  ///< row by row
  /// Consecutive columns that belong together: a block's tensors of one order.
  struct Group {
    std::string label;  ///< `phi`, `phi gradient`, `phi Hessian`
    std::size_t columns;
    std::string array = {};               ///< the same as one word: `phi`, `phi_gradient`, `phi_hessian`
    std::vector<std::size_t> shape = {};  ///< of a point's columns, as many as these multiply to: coordinates, axes
  };
  std::vector<Group> groups;
};

/// The columns of coordinates without values. \param order highest derivative
/// \throws InputError when the coordinates have no derivatives of that order
CoordinateColumns headed_columns(const CageCoordinates& coordinates, int order);

/// Takes rows of consecutive points, the first of them and the numbers.
using TakeRows = std::function<void(std::size_t first, std::size_t count, std::span<const double> rows)>;

/// Computes the rows of points [first, first + count) in blocks, which `take` gets as they are made, from any thread.
/// \param jobs threads; 0: all cores
void for_rows(const CageCoordinates& coordinates, std::span<const Vec3<double>> points, std::size_t first,
              std::size_t count, int order, int jobs, const TakeRows& take);

/// Points whose coordinates are computed together, because they share what evaluations prepare for an element: fewer
/// where rows are long.
std::size_t points_together(std::size_t columns);

/// A header, then one row per point.
std::string csv_text(const CoordinateColumns& table);
std::string csv_header(const CoordinateColumns& table);
/// Adds lines. \param columns numbers per line
void add_csv_rows(std::string& text, std::span<const double> rows, std::size_t columns);
/// points x columns.
std::string npy_text(const CoordinateColumns& table);
/// The header, which stands before the numbers.
std::string npy_header(std::size_t points, std::size_t columns);
/// The mesh with an array a group.
MeshField field_of(const CoordinateColumns& table, const Mesh& mesh);
/// The same as text.
std::string vtp_text(const CoordinateColumns& table, const Mesh& mesh);
/// The same with the cage as field data.
std::string vtp_text(const CoordinateColumns& table, const Mesh& mesh, const reports::DescribedCage& cage);

}  // namespace cageproof::cli
