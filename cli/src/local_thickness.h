// SPDX-License-Identifier: MIT
// How much maps of the plane stretch a drawing across its outline.
#pragma once

#include "cageproof/deformation/deformer.h"

#include <nlohmann/json_fwd.hpp>

namespace cageproof::cli {

/// [W12] Eq 21, n'.(J n), on each edge: n is the rest edge's outward unit normal, n' the posed one's, J
/// the map's Jacobian from inside. Members: `where` J is taken, as a
/// share of the edge: its middle, or the middle of its middle piece where edges are solved in pieces, between which
/// derivatives have no limit; `from`, `least` and `largest`, and `edges` in their order, null
/// where J or n' does not exist. J is the limit where coordinates have limits, else it is taken 1e-6 of the edge's
/// length inside.
/// \param posed vertices of the polygon \param pieces that edges are solved in, at least 1 \pre coordinates of a
/// polygon, which have derivatives
nlohmann::ordered_json local_thickness(const CageCoordinates& coordinates, const deformation::Posed<double>& map,
                                       const std::vector<Vec3<double>>& posed, int pieces);

}  // namespace cageproof::cli
