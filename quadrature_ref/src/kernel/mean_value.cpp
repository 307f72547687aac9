// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// x.n/r^4 in space, [T18] Eq 11; x.n/r^3 in the plane.
struct MeanValue {
  template <int Dim, Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-(Dim + 1), Order>(node, scale, jet);
  }
};

const RegisterKernel register_mean_value{"mean_value", scalar_kernels<MeanValue, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
