// SPDX-License-Identifier: MIT
// The collapsed-square rule on a triangle in its frame, shared by the Gauss and the multiprecision evaluation.
#pragma once

#include "../finish.h"
#include "../gauss_nodes.h"
#include "triangle_frame.h"

namespace cageproof::quadrature_ref {

/// Adds the n x n rule: xi = v0 + s (v1 - v0) + s q (v2 - v1), dA = 2 area s ds dq.
/// \param row memory for nodes
template <Scalar R>
void add_gauss(const TriangleFrame<R>& t, const Kernel<R>& kernel, const KernelTask<R>& task, const GaussNodes<R>& rule,
               std::vector<Node<R>>& row, Result<R>& sums) {
  const std::size_t n = rule.nodes.size();
  set_flat(row, n, t.normal, t.height, log_of_unit<R>(t.exponent));
  for (std::size_t i = 0; i < n; ++i) {
    const R& s = rule.nodes[i];
    const R row_weight = t.twice_area * s * rule.weights[i];
    Vec3<R> start;
    for (int c = 0; c < 3; ++c) start[c] = t.corners[0][c] + s * t.edges[0][c];
    for (std::size_t j = 0; j < n; ++j) {
      const R sq = s * rule.nodes[j];
      Node<R>& node = row[j];
      for (int c = 0; c < 3; ++c) node.x[c] = start[c] + sq * t.edges[1][c];
      node.hat[0] = 1 - s;
      node.hat[1] = s - sq;
      node.hat[2] = sq;
      node.weight = row_weight * rule.weights[j];
    }
    kernel.accumulate(row, task, sums);
  }
  sums.nodes += n * n;
}

}  // namespace cageproof::quadrature_ref
