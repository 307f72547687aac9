// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// x.n/r^3, positive inside, [T24] Appendix A with the sign of the definition.
struct SolidAngle {
  template <int Dim, Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-3, Order>(node, scale, jet);
  }
};

const RegisterKernel register_solid_angle{"solid_angle", scalar_kernels<SolidAngle, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
