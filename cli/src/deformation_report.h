// SPDX-License-Identifier: MIT
// The report on a deformed mesh.
#pragma once

#include "cageproof/deformation/mesh_measures.h"

#include <nlohmann/json_fwd.hpp>

namespace cageproof::cli {

/// Schema "cageproof-deformation", version 1, without its heading: displacements over the cage's size, volumes of cage
/// and mesh over those at rest, singular values of the Jacobians where they were asked for, what was solved, figures,
/// energies of steps and warnings.
/// \param points of the mesh, their number \param found the posed cage's vertices, of maps that find them themselves;
/// else empty \param prepared of the method \param pose of the map
nlohmann::ordered_json deformation_json(const deformation::MeshMeasures& measures, std::size_t points, double cage_size,
                                        const std::vector<Vec3<double>>& found, int dimension,
                                        const deformation::DeformationReport& prepared,
                                        const deformation::DeformationReport& pose);

}  // namespace cageproof::cli
