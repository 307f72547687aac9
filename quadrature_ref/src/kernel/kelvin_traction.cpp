// SPDX-License-Identifier: MIT
#include "tensor_kernel.h"

namespace cageproof::quadrature_ref {
namespace {

/// T_t^k = int Gamma_k mu ((a - 2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5), [C23] Eq 4; a and b as in K_t, so that
/// mu cancels; in the plane T_s^k = int Gamma_k mu ((a - 2b)(x.n I + n x' - x n')/r^2 + 4b x.n x x'/r^4).
template <int Dim, class R>
class KelvinTraction {
 public:
  explicit KelvinTraction(std::span<const R> parameters)
      : shear_(shear_share(parameters[1]) / (kSphere * pi<R>())),
        bulk_(2 * Dim / (4 * kSphere * pi<R>() * (1 - parameters[1]))) {}

  template <int Order>
  void jets(const Node<R>& node, std::array<KernelJet<Dim, R>, Dim * Dim>& matrix) const {
    KernelJet<Dim, R> force, stretch;
    power_jet<-Dim, Order>(node, shear_, force);
    height_power_jet<-Dim - 2, Order>(node, bulk_, stretch);
    const KernelJet<Dim, R> diagonal = product<Order>(force, height_jet<Dim>(node));
    std::array<KernelJet<Dim, R>, Dim> pull;
    for (int i = 0; i < Dim; ++i) pull[i] = times_coordinate<Order>(force, node, i);
    for (int i = 0; i < Dim; ++i) {
      const KernelJet<Dim, R> row = times_coordinate<Order>(stretch, node, i);
      for (int j = i; j < Dim; ++j) {
        KernelJet<Dim, R>& entry = matrix[Dim * i + j];
        entry = times_coordinate<Order>(row, node, j);
        if (i == j) {
          add<Order>(diagonal, entry);
          continue;
        }
        // n_i x_j - x_i n_j, of the other sign below the diagonal.
        KernelJet<Dim, R> turned;
        add_scaled<Order>(pull[j], node.normal[i], turned);
        add_scaled<Order>(pull[i], R(-node.normal[j]), turned);
        matrix[Dim * j + i] = entry;
        add<Order>(turned, entry);
        add_scaled<Order>(turned, R(-1), matrix[Dim * j + i]);
      }
    }
  }

 private:
  // The unit sphere's area, or the unit circle's length, over pi.
  static constexpr int kSphere = Dim == 2 ? 2 : 4;

  // (a - 2b)/a, without the difference, which cancels where the medium is all but incompressible.
  static R shear_share(const R& nu) {
    using std::isinf;
    return isinf(nu) ? R(1) : R((R(1) / 2 - nu) / (1 - nu));
  }

  R shear_, bulk_;
};

const RegisterKernel register_kelvin_traction{"kelvin_traction", tensor_kernels<KelvinTraction, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
