// SPDX-License-Identifier: MIT
// The collapsed-square rule on a triangle in local coordinates, shared by the Gauss and the multiprecision evaluation.
#pragma once

#include "local_triangle.h"

#include "cageproof/core/gauss_legendre.h"

namespace cageproof::quadrature_ref {

/// Adds the n x n rule: xi = v0 + s (v1 - v0) + s q (v2 - v1), dA = 2 area s ds dq.
template <Scalar R>
void add_gauss(const LocalTriangle<R>& t, const Kernel<R>& kernel, std::span<const R> parameters, int n, int order,
               Result<R>& sums) {
  const GaussLegendre<R>& rule = gauss_legendre<R>(n);
  std::vector<Node<R>> row;
  grow_flat(row, n, t.normal, t.height);
  for (int i = 0; i < n; ++i) {
    const R& s = rule.nodes[i];
    const R row_weight = t.twice_area * s * rule.weights[i];
    for (int j = 0; j < n; ++j) {
      const R sq = s * rule.nodes[j];
      Node<R>& node = row[j];
      for (int c = 0; c < 3; ++c) node.x[c] = t.corners[0][c] + s * t.edges[0][c] + sq * t.edges[1][c];
      node.hat[0] = 1 - s;
      node.hat[1] = s - sq;
      node.hat[2] = sq;
      node.weight = row_weight * rule.weights[j];
    }
    kernel.accumulate(row, parameters, order, sums);
  }
  sums.nodes += static_cast<std::size_t>(n) * n;
}

}  // namespace cageproof::quadrature_ref
