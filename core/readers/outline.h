// SPDX-License-Identifier: MIT
// Polylines that are written as places, one after the other, and become the vertices and segments of a mesh.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

namespace cageproof::mesh_files {

/// A vertex, and the line of the file that it, or what it belongs to, stands in.
struct OutlineVertex {
  Vec3<double> at;
  std::size_t line;
};

/// Adds the polyline, closed when told, or when its last vertex lies where its first one does: then that is no vertex
/// of its own. A segment's line is that of its end.
inline void add_outline(std::vector<OutlineVertex> outline, bool closed, Mesh& mesh) {
  if (outline.empty()) return;
  const std::size_t closing_line = outline.back().line;
  if (outline.size() > 2 && outline.front().at == outline.back().at) {
    outline.pop_back();
    closed = true;
  }
  const int first = static_cast<int>(mesh.vertices.size()), count = static_cast<int>(outline.size());
  for (int k = 0; k < count; ++k) {
    mesh.vertices.push_back(outline[k].at);
    if (k == 0) continue;
    mesh.segments.push_back({first + k - 1, first + k});
    mesh.segment_lines.push_back(outline[k].line);
  }
  if (!closed || count < 2) return;
  mesh.segments.push_back({first + count - 1, first});
  mesh.segment_lines.push_back(closing_line);
}

}  // namespace cageproof::mesh_files
