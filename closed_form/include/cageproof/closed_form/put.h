// SPDX-License-Identifier: MIT
// Puts a jet where a batch wants it.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/core/catalogue/batch.h"

namespace cageproof::closed_form {

/// Puts the jet of point `point` into the output, orders 0 to `order`.
template <Scalar R, int C, int D>
void put(const Jet<R, C, D>& jet, int order, std::size_t point, const BatchOutput<R>& output) {
  output.put(point, 0, jet.value);
  if (order < 1) return;
  std::array<R, C * D> gradient;
  for (int c = 0; c < C; ++c)
    for (int i = 0; i < D; ++i) gradient[D * c + i] = jet.gradient[c][i];
  output.put(point, 1, gradient);
  if (order < 2) return;
  std::array<R, C * D * D> hessian;
  for (int c = 0; c < C; ++c)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) hessian[D * (D * c + i) + j] = jet.hessian[c](i, j);
  output.put(point, 2, hessian);
}

}  // namespace cageproof::closed_form
