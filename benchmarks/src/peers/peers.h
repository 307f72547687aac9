// SPDX-License-Identifier: MIT
// Whole coordinates as others write them: published forms, point by point and element by element, without any care
// about cancellation; and a public library's. `batched` is timed in turns with them.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/coordinates/coordinates.h"

#include <functional>

namespace cageproof::benchmarks {

/// Coordinates of points. \param values [point][coordinate], blocks of the kind one after the other
using PeerFill = std::function<void(std::span<const Vec3<double>> points, std::span<double> values)>;

struct Peer {
  std::string_view kind;    ///< whose values it computes
  std::string_view name;    ///< of the form, or of the library
  std::string_view source;  ///< who published it
  int dimension;
  /// Prepares the form for a cage, whose quads are split at their shorter diagonal.
  PeerFill (*prepare)(const CageElements& elements);
};

/// Green and mean value coordinates in space, and green, mean value and Cauchy coordinates in the plane.
const std::vector<Peer>& peers();

// A file each.
PeerFill green_by_edges(const CageElements& triangles);
PeerFill mean_value_by_angles(const CageElements& triangles);
PeerFill mean_value_by_vtk(const CageElements& triangles);
PeerFill plane_green_by_edges(const CageElements& segments);
PeerFill plane_mean_value_by_tangents(const CageElements& segments);
PeerFill cauchy_by_logarithms(const CageElements& segments);

}  // namespace cageproof::benchmarks
