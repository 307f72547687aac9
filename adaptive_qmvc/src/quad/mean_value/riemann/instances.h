// SPDX-License-Identifier: MIT
// The paper's scheme for a block of points; each scalar is compiled in a file of its own.
#pragma once

#include "quad/mean_value/riemann/riemann.h"
#include "cageproof/core/catalogue/batch.h"

namespace cageproof::adaptive_qmvc {

/// quad_weights at each point of the batch.
template <Scalar R>
void riemann_batch(const Batch<R>& batch, int n, const PoleGuard& guard, const BatchOutput<R>& output);

}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_RIEMANN_WEIGHTS(R)                                                                    \
  template <>                                                                                           \
  void cageproof::adaptive_qmvc::riemann_batch<R>(const Batch<R>& batch, int n, const PoleGuard& guard, \
                                                  const BatchOutput<R>& output) {                       \
    thread_local RiemannWorkspace<R> work;                                                              \
    const Quad<R> q{batch.corners[0], batch.corners[1], batch.corners[2], batch.corners[3]};            \
    for (std::size_t p = 0; p < batch.points.size(); ++p) {                                             \
      const Vec4<R> w = quad_weights<R>(q, batch.points[p], n, work, guard);                            \
      output.put(p, 0, {w.data(), 4});                                                                  \
      output.state(p, {.nodes = static_cast<std::size_t>(2 * n + 1) * (2 * n + 1)});                    \
    }                                                                                                   \
  }
