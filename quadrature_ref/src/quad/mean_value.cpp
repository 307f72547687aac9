// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/quad_rules.h"
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// w_q^k = int Phi_k N.x/r^4 du dv, [T18] Eq 11.
struct MeanValue {
  static constexpr int corners = 4;
  template <Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    height_power_jet<-4, Order>(node, scale, jet);
  }
};

const RegisterQuadKernel registered{"quad.mean_value", scalar_kernels<MeanValue>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
