// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// psibar_t = int r/(8 pi), [T24] Eq 9.
struct BiharmonicSingleLayer {
  static constexpr int corners = 0;
  template <Scalar R>
  static R factor() {
    return 1 / (8 * pi<R>());
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    power_jet<1, Order>(node, scale, jet);
  }
};

const RegisterTriangleKernel registered{"triangle.biharmonic_single_layer", scalar_kernels<BiharmonicSingleLayer>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
