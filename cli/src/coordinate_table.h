// SPDX-License-Identifier: MIT
// Coordinates of many points as one table, and its text in each file format.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/reports/cage_vtp.h"

#include <functional>
#include <string>
#include <vector>

namespace cageproof::cli {

/// A row a point. Columns: block by block; in a block all values, then all first derivatives, then all second ones, as
/// far as they are asked for: `phi_0`, `phi_0_dx`, `phi_0_dxy`; of matrices `T_0_xy`, `T_0_xy_dz`, `T_0_xy_dzz`.
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

/// \param order highest derivative \param jobs threads; 0: all cores \param progress called with the points that are
/// done, from any thread \throws InputError when the coordinates have no derivatives of that order
CoordinateColumns coordinate_columns(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points,
                                     int order, int jobs, const std::function<void(std::size_t)>& progress = {});

/// A header, then a row a point.
std::string csv_text(const CoordinateColumns& table);
/// points x columns.
std::string npy_text(const CoordinateColumns& table);
/// The mesh with an array a group.
MeshField field_of(const CoordinateColumns& table, const Mesh& mesh);
/// The same as text.
std::string vtp_text(const CoordinateColumns& table, const Mesh& mesh);
/// The same with the cage as field data.
std::string vtp_text(const CoordinateColumns& table, const Mesh& mesh, const reports::DescribedCage& cage);

}  // namespace cageproof::cli
