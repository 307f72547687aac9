// SPDX-License-Identifier: MIT
#include "cageproof/quadrature_ref/tensor_kernel.h"
#include "cageproof/quadrature_ref/triangle_rules.h"

namespace cageproof::quadrature_ref {
namespace {

/// T_t^k = int Gamma_k mu ((a - 2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5), [C23] Eq 4; a and b as in K_t, so that mu cancels.
template <class R>
class KelvinTraction {
 public:
  static constexpr int corners = 3;
  explicit KelvinTraction(std::span<const R> parameters)
      : shear_((1 - 1 / (2 * (1 - parameters[1]))) / (4 * pi<R>())),
        bulk_(6 / (16 * pi<R>() * (1 - parameters[1]))) {}

  template <int Order>
  void jets(const Node<R>& node, std::array<Jet<R>, 9>& matrix) const {
    Jet<R> cube, fifth;
    power_jet<-3, Order>(node, shear_, cube);
    height_power_jet<-5, Order>(node, bulk_, fifth);
    const Jet<R> diagonal = product<Order>(cube, height_jet(node));
    for (int i = 0; i < 3; ++i) {
      const Jet<R> row = product<Order>(fifth, coordinate_jet(node, i));
      for (int j = i; j < 3; ++j) {
        Jet<R>& entry = matrix[3 * i + j];
        entry = product<Order>(row, coordinate_jet(node, j));
        if (i == j) {
          add_scaled<Order>(diagonal, R(1), entry);
          continue;
        }
        // n_i x_j - x_i n_j, of the other sign below the diagonal.
        Jet<R> turn;
        add_scaled<Order>(coordinate_jet(node, j), node.normal[i], turn);
        add_scaled<Order>(coordinate_jet(node, i), R(-node.normal[j]), turn);
        const Jet<R> turned = product<Order>(cube, turn);
        matrix[3 * j + i] = entry;
        add_scaled<Order>(turned, R(1), entry);
        add_scaled<Order>(turned, R(-1), matrix[3 * j + i]);
      }
    }
  }

 private:
  R shear_, bulk_;
};

const RegisterTriangleKernel registered{"triangle.kelvin_traction", tensor_kernels<KelvinTraction>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
