// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// phibar_t^k = int -Gamma_k x.n/(8 pi r), [T24] Eq 15.
struct BiharmonicDoubleLayer {
  static constexpr int corners = 3;
  template <Scalar R>
  static R factor() {
    return -1 / (8 * pi<R>());
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    height_power_jet<-1, Order>(node, scale, jet);
  }
};

const RegisterTriangleKernel registered{"triangle.biharmonic_double_layer", scalar_kernels<BiharmonicDoubleLayer>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
