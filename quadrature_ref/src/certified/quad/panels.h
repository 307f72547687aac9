// SPDX-License-Identifier: MIT
// The stretches of v that a quad is cut into, with Gauss-Legendre's nodes and truncation error in each.
#pragma once

#include "integrand.h"

#include <optional>

namespace cageproof::quadrature_ref::certified {

struct QuadPanel {
  QuadStretch stretch;
  int depth;                 ///< bisections that made it
  int nodes = 0;             ///< even
  Real rho;                  ///< sum of an ellipse's semi-axes over half, the foci at the panel's ends
  std::vector<Real> errors;  ///< per order, an upper bound of each integral's truncation error
};

/// \param goal truncation error wanted, in bits below the largest contribution: a wish
/// \param work_left CertifiedEffort::most_work's unit; what is spent is taken off
/// \return nothing where the point is too close to the quad, or on it, or work_left would not suffice
std::optional<std::vector<QuadPanel>> quad_panels(const SeenQuad& quad, QuadIntegrand& integrand, int goal,
                                                  double& work_left);

}  // namespace cageproof::quadrature_ref::certified
