// SPDX-License-Identifier: MIT
// Vertices that lie near each other, as one: for meshes that were written with one vertex per corner.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

namespace cageproof {

/// The numbers of a mesh's vertices before and after vertices were merged.
struct Merging {
  std::vector<int> number;  ///< the new number of each vertex
  std::vector<int> first;   ///< the old number of each new vertex, whose place it has: the lowest of those merged
};

/// Joins vertices that lie within a distance of each other, and those that a chain of such ones connects. New vertices
/// stand in the order of the first old ones. \param distance 0 or more, in the unit of the coordinates; 0: equal places
Merging merging_of(const std::vector<Vec3<double>>& vertices, double distance);

/// The mesh with merged vertices. Equal corners that follow each other become one; faces of fewer than three corners
/// and segments of one are left out. Says how many, and how many vertices are left, in a warning.
Mesh merged(Mesh mesh, const Merging& merging, const std::filesystem::path& path);

/// The vertices of another pose of the same mesh. \param path of the
/// pose, for messages \throws InputError for another number of vertices, or where vertices that are one lie further
/// than `distance` from the first of them
std::vector<Vec3<double>> merged_pose(const std::vector<Vec3<double>>& posed, const Merging& merging, double distance,
                                      const std::filesystem::path& path);

}  // namespace cageproof
