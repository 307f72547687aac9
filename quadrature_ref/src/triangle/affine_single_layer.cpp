// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// psi_t^k = int Gamma_k/(4 pi r), [T24] Eq 43.
struct AffineSingleLayer {
  static constexpr int corners = 3;
  template <Scalar R>
  static R factor() {
    return 1 / (4 * pi<R>());
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    power_jet<-1, Order>(node, scale, jet);
  }
};

const RegisterTriangleKernel registered{"triangle.affine_single_layer", scalar_kernels<AffineSingleLayer>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
