// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// dG1/dn: x.n/(4 pi r^3) in space, [T24] Eq 3; x.n/(2 pi r^2) in the plane, [W12] Section 3.
struct DoubleLayer {
  template <int Dim, Scalar R>
  static R factor() {
    return 1 / ((Dim == 2 ? 2 : 4) * pi<R>());
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-Dim, Order>(node, scale, jet);
  }
};

const RegisterKernel register_double_layer{"double_layer", scalar_kernels<DoubleLayer, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
