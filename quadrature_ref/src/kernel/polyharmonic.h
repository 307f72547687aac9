// SPDX-License-Identifier: MIT
// Green functions of powers of the Laplacian in the plane, which two kernels integrate.
#pragma once

#include "cageproof/quadrature_ref/scalar_kernel.h"

namespace cageproof::quadrature_ref {

/// r^(2 power) (log ln r + plain) with its derivatives: the chain rule brings g'/r of the same shape.
template <class R>
struct RadialFunction {
  int power;
  R log, plain;

  RadialFunction slope() const { return {power - 1, R(2 * power) * log, R(2 * power) * plain + log}; }

  template <int Dim>
  R at(const Node<R>& node) const {
    using std::log;
    const R square = squared_distance<Dim>(node.x);
    R value = power == 0 && this->log == 0 ? plain : R(this->log * (log(square) / 2 + node.log_unit) + plain);
    for (int i = 0; i < power; ++i) value *= square;
    for (int i = 0; i > power; --i) value /= square;
    return value;
  }

  /// scale times it, up to Order.
  template <int Order, int Dim>
  void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) const {
    jet.value = scale * at<Dim>(node);
    if constexpr (Order >= 1) {
      const R first = scale * slope().template at<Dim>(node);
      set_radial_gradient(node.x, first, jet);
      if constexpr (Order >= 2)
        set_radial_hessian(node.x, first, R(scale * slope().slope().template at<Dim>(node)), jet);
    }
  }
};

/// 2 pi G_s = r^(2(s - 1)) (a_s ln r - b_s), [W12] Appendix B with the errata's exponent and b_i:
/// a_i = a_(i-1)/(4 (i-1)^2), b_i = (a_(i-1)/(i-1) + b_(i-1))/(4 (i-1)^2). \param s from 1 on, a whole number
template <class R>
RadialFunction<R> green_function_of_order(const R& s) {
  const int order = static_cast<int>(static_cast<double>(s));
  R a = 1, b = 0;
  for (int i = 1; i < order; ++i) {
    const R square = R(4 * i * i);
    b = (a / R(i) + b) / square;
    a /= square;
  }
  return {order - 1, a, R(-b)};
}

}  // namespace cageproof::quadrature_ref
