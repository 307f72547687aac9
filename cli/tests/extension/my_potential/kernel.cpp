// SPDX-License-Identifier: MIT
// Second edit: the kernel.
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// 1/r.
struct MyPotential {
  template <int Dim, Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    power_jet<-1, Order>(node, scale, jet);
  }
};

const RegisterKernel registered{"my_potential", scalar_kernels<MyPotential, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
