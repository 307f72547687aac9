// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// w_t^k = int Gamma_k x.n/r^4, [T18] Eq 11.
struct MeanValue {
  static constexpr int corners = 3;
  template <Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    height_power_jet<-4, Order>(node, scale, jet);
  }
};

const RegisterTriangleKernel registered{"triangle.mean_value", scalar_kernels<MeanValue>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
