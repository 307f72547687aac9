// SPDX-License-Identifier: MIT
// A cage and the results computed with it: as geometry of its own, and as field data of a mesh.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// The elements that coordinates belong to: triangles that quads were split in, quads that were kept, or segments.
struct DescribedCage {
  int dimension = 3;
  std::vector<Vec3<double>> vertices;
  std::vector<std::vector<int>> elements;  ///< vertices of each, counter-clockwise seen from outside
  std::vector<int> faces;                  ///< of each element, the face of the cage that it is, or is part of
  std::vector<Vec3<double>> normals;       ///< unit, outward; of quads, of their area vectors
  std::vector<double> measures;            ///< areas, of quads those of their area vectors; in the plane lengths
  std::string metadata;                    ///< JSON
};

/// The field data array with the metadata, which marks a file as one of these.
inline constexpr std::string_view metadata_array = "cageproof_metadata";

/// The cage as a .vtp: polygons, in the plane lines, with `normal`, `area` or `length` and `face` of each cell, and the
/// metadata as field data.
std::string cage_vtp_text(const DescribedCage& cage);

/// A mesh as vtp_text writes it, with the cage and the metadata as field data: `cage_vertices`, `elements` (-1 where an
/// element has fewer corners than others), `element_faces`, `element_normals`, `element_areas` or `element_lengths`.
std::string vtp_text_with_cage(const MeshField& field, const DescribedCage& cage);

}  // namespace cageproof::reports
