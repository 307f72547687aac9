// SPDX-License-Identifier: MIT
// The energy of variational maps as [T24] Eq 37-40 print it, of what a map is at the places of constraints.
#pragma once

#include "cageproof/core/numbers/linear.h"

#include <vector>

namespace cageproof::second_routes {

/// A map's values, Jacobian or second derivatives at one point: [component][derivatives].
using MapTensor = std::vector<Mp50>;

/// A map at the places of constraints, or a direction in which it is changed.
struct MapAtConstraints {
  std::vector<MapTensor> positions, orientations, rotations, hessians;
};

struct VariationalEnergy {
  Mp50 alpha, beta, gamma;
  std::vector<MapTensor> targets;    ///< of positions
  std::vector<MapTensor> jacobians;  ///< of orientations
  std::vector<MapTensor> turns;      ///< R_r

  /// sum |f - target|^2 + alpha sum |Jf - jacobian|^2 + beta sum |Jf - R|^2 + gamma sum |Hf|^2.
  Mp50 of(const MapAtConstraints& map) const;
  /// The derivative along a direction by central differences, which are exact up to rounding for a quadratic energy.
  Mp50 slope(const MapAtConstraints& map, const MapAtConstraints& direction) const;
};

/// The rotation R with the largest sum R_cj J_cj, which is the nearest to J: in the plane by its angle, in space by the
/// eigenvector of the largest eigenvalue of a form of quaternions. \param similar whether it is made as large as J,
/// times that sum over the dimension
MapTensor nearest_turn(const MapTensor& jacobian, int dimension, bool similar);

}  // namespace cageproof::second_routes
