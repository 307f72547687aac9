// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// -G2 = r/(8 pi), [T24] Eq 9.
struct BiharmonicSingleLayer {
  template <int Dim, Scalar R>
  static R factor() {
    return 1 / (8 * pi<R>());
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    power_jet<1, Order>(node, scale, jet);
  }
};

const RegisterKernel register_biharmonic_single_layer{"biharmonic_single_layer",
                                                      scalar_kernels<BiharmonicSingleLayer, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
