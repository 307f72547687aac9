// SPDX-License-Identifier: MIT
#include "polyharmonic.h"

namespace cageproof::quadrature_ref {
namespace {

/// dG_s/dn = x.n G_s'/r.
template <class R>
class PolyharmonicDoubleLayer {
 public:
  explicit PolyharmonicDoubleLayer(std::span<const R> parameters)
      : slope_(green_function_of_order<R>(parameters[0]).slope()), factor_(1 / (2 * pi<R>())) {}
  template <int Order, int Dim>
  void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) const {
    KernelJet<Dim, R> radial;
    slope_.template jet<Order>(node, R(factor_ * scale), radial);
    jet = product<Order>(radial, height_jet<Dim>(node));
  }

 private:
  RadialFunction<R> slope_;
  R factor_;
};

const RegisterKernel register_polyharmonic_double_layer{"polyharmonic_double_layer",
                                                        parametric_kernels<PolyharmonicDoubleLayer, 2>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
