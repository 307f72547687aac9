// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// omega_t = int x.n/r^3, positive inside, [T24] Appendix A with the sign of the definition.
struct SolidAngle {
  static constexpr int corners = 0;
  template <Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, Scalar R>
  static void jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
    height_power_jet<-3, Order>(node, scale, jet);
  }
};

const RegisterTriangleKernel registered{"triangle.solid_angle", scalar_kernels<SolidAngle>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
