// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// -G2: r/(8 pi) in space, [T24] Eq 9; -r^2 (ln r - 1)/(8 pi) in the plane, [W12] Section 4.1 after the errata.
struct BiharmonicSingleLayer {
  template <int Dim, Scalar R>
  static R factor() {
    return (Dim == 2 ? -1 : 1) / (8 * pi<R>());
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    if constexpr (Dim == 2) square_log_jet<Order>(node, scale, R(-1), jet);
    else power_jet<1, Order>(node, scale, jet);
  }
};

const RegisterKernel register_biharmonic_single_layer{"biharmonic_single_layer",
                                                      scalar_kernels<BiharmonicSingleLayer, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
