// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// 1/r^2.
struct InverseSquare {
  template <int Dim, Scalar R>
  static R factor() {
    return R(1);
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    power_jet<-2, Order>(node, scale, jet);
  }
};

const RegisterKernel registered{"inverse_square", scalar_kernels<InverseSquare, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
