// SPDX-License-Identifier: MIT
#include "../finish.h"
#include "../gauss_nodes.h"
#include "segment_frame.h"

#include "segment_rules.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
void segment::integrate_gauss(const Integrand& integrand, int n, const Batch<R>& batch, const BatchOutput<R>& output) {
  static thread_local std::vector<Node<R>> nodes;
  const GaussNodes<R>& rule = gauss_nodes<R>(n);
  const Kernel<R>& kernel = integrand.kernel<R>();
  const KernelTask<R> task = integrand.task(batch.parameters, batch.order);
  nodes.resize(n);
  for (int i = 0; i < n; ++i) nodes[i].hat = {R(1 - rule.nodes[i]), rule.nodes[i], R(0), R(0)};
  const auto add = [&](const SegmentFrame<R>& s, Result<R>& sums) {
    set_flat(nodes, n, s.normal, s.height, log_of_unit<R>(s.exponent));
    for (int i = 0; i < n; ++i) {
      for (int c = 0; c < 2; ++c) nodes[i].x[c] = s.corners[0][c] + rule.nodes[i] * s.edges[0][c];
      nodes[i].weight = s.extent * rule.weights[i];
    }
    kernel.accumulate(nodes, task, sums);
    sums.nodes += n;
  };
  integrate_block<R>(
      integrand, batch, output, [&](const Vec3<R>& point) { return segment_frame(batch.corners, point); }, add);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void segment::integrate_gauss<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
