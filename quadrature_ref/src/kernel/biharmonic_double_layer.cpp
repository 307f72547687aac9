// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// dG2/dn = -x.n/(8 pi r), [T24] Eq 15.
struct BiharmonicDoubleLayer {
  template <int Dim, Scalar R>
  static R factor() {
    return -1 / (8 * pi<R>());
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-1, Order>(node, scale, jet);
  }
};

const RegisterKernel register_biharmonic_double_layer{"biharmonic_double_layer",
                                                      scalar_kernels<BiharmonicDoubleLayer, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
