// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// x.n/r^2, positive inside: the plane's solid angle.
struct WindingAngle {
  template <int Dim, Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-2, Order>(node, scale, jet);
  }
};

const RegisterKernel register_winding_angle{"winding_angle", scalar_kernels<WindingAngle, 2>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
