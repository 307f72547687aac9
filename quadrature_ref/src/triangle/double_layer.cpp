// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// phi_t^k = int Gamma_k x.n/(4 pi r^3), [T24] Eq 3.
struct DoubleLayer {
  static constexpr int corners = 3;
  template <Scalar R>
  static R factor() {
    return 1 / (4 * pi<R>());
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    height_power_jet<-3, Order>(node, scale, jet);
  }
};

const RegisterTriangleKernel registered{"triangle.double_layer", scalar_kernels<DoubleLayer>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
