// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/tensor_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// K_t = int (a - b)/r I + b x x'/r^3 with a = 1/(4 pi mu), b = a/(4 (1 - nu)), [C23] Eq 3, [T24] Eq 47.
template <class R>
class KelvinDisplacement {
 public:
  static constexpr int corners = 0;
  explicit KelvinDisplacement(std::span<const R> parameters)
      : a_(1 / (4 * pi<R>() * parameters[0])), b_(a_ / (4 * (1 - parameters[1]))) {}

  template <int Order>
  void jets(const Node<R>& node, std::array<Jet<R>, 9>& matrix) const {
    Jet<R> potential, cube;
    power_jet<-1, Order>(node, R(a_ - b_), potential);
    power_jet<-3, Order>(node, b_, cube);
    for (int i = 0; i < 3; ++i) {
      const Jet<R> row = product<Order>(cube, coordinate_jet(node, i));
      for (int j = 0; j < 3; ++j) {
        matrix[3 * i + j] = product<Order>(row, coordinate_jet(node, j));
        if (i == j) add_scaled<Order>(potential, R(1), matrix[3 * i + j]);
      }
    }
  }

 private:
  R a_, b_;
};

const RegisterTriangleKernel registered{"triangle.kelvin_displacement", tensor_kernels<KelvinDisplacement>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
