// SPDX-License-Identifier: MIT
// Enclosures of the nodes and weights of Gauss-Legendre rules, computed once.
#pragma once

#include "ball.h"

#include <memory>
#include <vector>

namespace cageproof::quadrature_ref::certified {

/// The positive half of a rule with an even number of nodes; the other half mirrors it.
struct HalfRule {
  std::vector<Real> nodes, weights;
};

/// The rule of n nodes at that many bits; safe to call from any thread. \pre n even, n >= 2
std::shared_ptr<const HalfRule> half_rule(int n, slong bits);

}  // namespace cageproof::quadrature_ref::certified
