// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// dG2/dn: -x.n/(8 pi r) in space, [T24] Eq 15; x.n (2 ln r - 1)/(8 pi) in the plane, [W12] Section 4.1 after the
/// errata.
struct BiharmonicDoubleLayer {
  template <int Dim, Scalar R>
  static R factor() {
    return Dim == 2 ? R(1 / (4 * pi<R>())) : R(-1 / (8 * pi<R>()));
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    if constexpr (Dim == 2) {
      KernelJet<Dim, R> logarithm;
      log_jet<Order>(node, scale, logarithm);
      logarithm.value -= scale / 2;
      jet = product<Order>(logarithm, height_jet<Dim>(node));
    } else {
      height_power_jet<-1, Order>(node, scale, jet);
    }
  }
};

const RegisterKernel register_biharmonic_double_layer{"biharmonic_double_layer",
                                                      scalar_kernels<BiharmonicDoubleLayer, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
