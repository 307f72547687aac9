// SPDX-License-Identifier: MIT
#include "polyharmonic.h"

namespace cageproof::quadrature_ref {
namespace {

/// -G_s.
template <class R>
class PolyharmonicSingleLayer {
 public:
  explicit PolyharmonicSingleLayer(std::span<const R> parameters)
      : green_(green_function_of_order<R>(parameters[0])), factor_(-1 / (2 * pi<R>())) {}
  template <int Order, int Dim>
  void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) const {
    green_.template jet<Order>(node, R(factor_ * scale), jet);
  }

 private:
  RadialFunction<R> green_;
  R factor_;
};

const RegisterKernel register_polyharmonic_single_layer{"polyharmonic_single_layer",
                                                        parametric_kernels<PolyharmonicSingleLayer, 2>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
