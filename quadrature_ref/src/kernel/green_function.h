// SPDX-License-Identifier: MIT
// -G1, which two kernels integrate: alone, and weighted with the basis functions.
#pragma once

#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {

/// 1/(4 pi r) in space, [T24] Eq 3; -ln r/(2 pi) in the plane, [W12] Section 3 after the errata.
struct NegativeGreenFunction {
  template <int Dim, Scalar R>
  static R factor() {
    return Dim == 2 ? R(-1 / (2 * pi<R>())) : R(1 / (4 * pi<R>()));
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    if constexpr (Dim == 2) log_jet<Order>(node, scale, jet);
    else power_jet<-1, Order>(node, scale, jet);
  }
};

}  // namespace cageproof::quadrature_ref
