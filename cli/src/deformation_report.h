// SPDX-License-Identifier: MIT
// What there is to say of a deformed mesh.
#pragma once

#include "cageproof/core/mesh_io.h"
#include "cageproof/deformation/point_images.h"

#include <nlohmann/json_fwd.hpp>

namespace cageproof::cli {

/// Schema "cageproof-deformation", version 1, without its heading: displacements over the cage's size, volumes of cage
/// and mesh over those at rest, singular values of the Jacobians where they were asked for, what was solved, figures,
/// energies of steps and warnings.
/// \param map of these images, counted from 0 \param posed the cage's vertices, empty where a map has no posed cage
/// \param prepared of the method \param pose of the map
nlohmann::ordered_json deformation_json(const CageCoordinates& coordinates, const Cage& cage, const Mesh& rest,
                                        const std::vector<Vec3<double>>& posed, const deformation::PointImages& images,
                                        std::size_t map, int order, const deformation::DeformationReport& prepared,
                                        const deformation::DeformationReport& pose, bool found_itself);

}  // namespace cageproof::cli
