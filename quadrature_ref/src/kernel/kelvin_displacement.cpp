// SPDX-License-Identifier: MIT
#include "tensor_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// K_t = int (a - b)/r I + b x x'/r^3 with a = 1/(4 pi mu), b = a/(4 (1 - nu)), [C23] Eq 3, [T24] Eq 47; in the plane
/// K_s = int -(a - b) ln r I + b x x'/r^2 with a = 1/(2 pi mu).
template <int Dim, class R>
class KelvinDisplacement {
 public:
  explicit KelvinDisplacement(std::span<const R> parameters)
      : a_(1 / ((Dim == 2 ? 2 : 4) * pi<R>() * parameters[0])), b_(a_ / (4 * (1 - parameters[1]))) {}

  template <int Order>
  void jets(const Node<R>& node, std::array<KernelJet<Dim, R>, Dim * Dim>& matrix) const {
    KernelJet<Dim, R> potential, bend;
    if constexpr (Dim == 2) log_jet<Order>(node, R(b_ - a_), potential);
    else power_jet<-1, Order>(node, R(a_ - b_), potential);
    power_jet<-Dim, Order>(node, b_, bend);
    for (int i = 0; i < Dim; ++i) {
      const KernelJet<Dim, R> row = times_coordinate<Order>(bend, node, i);
      for (int j = i; j < Dim; ++j) {
        matrix[Dim * i + j] = times_coordinate<Order>(row, node, j);
        if (i == j) add<Order>(potential, matrix[Dim * i + j]);
        else matrix[Dim * j + i] = matrix[Dim * i + j];
      }
    }
  }

 private:
  R a_, b_;
};

const RegisterKernel register_kelvin_displacement{"kelvin_displacement", tensor_kernels<KelvinDisplacement, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
