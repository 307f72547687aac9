// SPDX-License-Identifier: MIT
// The deformers of [T24] that solve for densities, with all that they solve for found another way: from the printed
// normal equations, in 200 digits.
#pragma once

#include "alignment_route.h"

#include <optional>

namespace cageproof::second_routes {

/// How long posed normals are that nothing is solved for, of the singular values of an element's map to the posed one:
/// one, or the root of their mean square, their mean, the root of their product.
enum class NormalLength { Unit, Rms, Mean, Area };

struct LayerMethod {
  DensityMethod densities;
  NormalLength length = NormalLength::Unit;
  std::optional<AlignmentMethod> alignment = {};  ///< solves normal derivatives, if any
};

/// f = phi V' + psi N' + phibar L' + psibar D' for one pose.
class LayerRoute {
 public:
  /// \param layers in 50 digits, taken as given; outlive the route \param posed the cage's vertices
  LayerRoute(const CageCoordinates& layers, const LayerMethod& method, const std::vector<Vec3<double>>& posed);
  Vec3<Wide> image_of(const Vec3<double>& point) const;

 private:
  const CageCoordinates& layers_;
  Table<Wide> vertices_, normals_, densities_;
};

}  // namespace cageproof::second_routes
