// SPDX-License-Identifier: MIT
// Meshes deformed by posed cages: images of points, and what there is to say of them.
#pragma once

#include "coordinate_table.h"

#include "cageproof/deformation/deformer.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace cageproof::cli {

/// What becomes of points that have no image: those outside the cage, of coordinates that mean nothing there, and
/// those without coordinates.
enum class OutsidePolicy { Error, Rest, Nan };

/// A mesh under one pose.
struct Deformed {
  Mesh mesh;                ///< as at rest, vertices moved
  CoordinateColumns table;  ///< `x`, `y`, `z`, `x_dx` ..., a row a point
  std::size_t without_image = 0;
  std::unique_ptr<const deformation::Posed<double>> posed;
};

/// The mesh under each pose. Coordinates are computed once a point, whatever the number of poses.
/// \param poses vertices of the cage, and the name of where they come from, for messages
/// \throws InputError for a pose that the method does not take, and, by that policy, for points without images
std::vector<Deformed> deform(const deformation::Deformer<double>& deformer, const Cage& cage, const Mesh& mesh,
                             const std::vector<std::pair<std::string, std::vector<Vec3<double>>>>& poses, int order,
                             OutsidePolicy outside, int jobs);

/// Schema "cageproof-deformation", version 1: displacements over the cage's size, volumes of cage and mesh over those
/// at rest, singular values of the Jacobians where they are asked for, what was solved, figures and warnings.
nlohmann::ordered_json deformation_json(const deformation::Deformer<double>& deformer, const Cage& cage,
                                        const Mesh& rest, const std::vector<Vec3<double>>& posed,
                                        const Deformed& deformed, int order);

}  // namespace cageproof::cli
