// SPDX-License-Identifier: MIT
// Powers and the logarithm of the distance with their derivatives with respect to the point: what kernels are made of.
#pragma once

#include "cageproof/quadrature_ref/kernel.h"

#include <array>
#include <cmath>

namespace cageproof::quadrature_ref {

/// A scalar function's value, gradient and Hessian (entries i <= j, row by row) with respect to eta.
template <int Dim, Scalar R>
struct KernelJet {
  R value{};
  std::array<R, Dim> gradient{};
  std::array<R, Dim*(Dim + 1) / 2> hessian{};
};

/// |x|^2.
template <int Dim, Scalar R>
R squared_distance(const Vec3<R>& x) {
  R square = x[0] * x[0];
  for (int i = 1; i < Dim; ++i) square += x[i] * x[i];
  return square;
}

/// The powers r^M, r^(M - 2) and r^(M - 4), which a jet of order 2 needs.
template <int M, int Dim, Scalar R>
struct Powers {
  explicit Powers(const Vec3<R>& x) {
    using std::sqrt;
    const R r2 = squared_distance<Dim>(x);
    const R inverse = 1 / r2;
    R power = M % 2 == 0 ? R(1) : R(sqrt(r2));
    for (int m = M % 2 == 0 ? 0 : 1; m < M; m += 2) power *= r2;
    for (int m = M % 2 == 0 ? 0 : 1; m > M; m -= 2) power *= inverse;
    first = power;
    second = first * inverse;
    third = second * inverse;
  }
  R first, second, third;
};

/// The gradient -slope x and the Hessian slope I + bend x x' of a function of only the distance.
template <int Dim, Scalar R>
void set_radial_gradient(const Vec3<R>& x, const R& slope, KernelJet<Dim, R>& jet) {
  for (int i = 0; i < Dim; ++i) jet.gradient[i] = -(slope * x[i]);
}
template <int Dim, Scalar R>
void set_radial_hessian(const Vec3<R>& x, const R& slope, const R& bend, KernelJet<Dim, R>& jet) {
  std::array<R, Dim> y;
  for (int i = 0; i < Dim; ++i) y[i] = bend * x[i];
  for (int i = 0, entry = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j, ++entry) jet.hessian[entry] = i == j ? x[i] * y[i] + slope : R(x[i] * y[j]);
}

/// jet = scale * r^M and its derivatives up to Order (0, 1, 2).
template <int M, int Order, int Dim, Scalar R>
void power_jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
  const Powers<M, Dim, R> r(node.x);
  jet.value = scale * r.first;
  if constexpr (Order >= 1) {
    const R slope = scale * r.second * M;
    set_radial_gradient(node.x, slope, jet);
    if constexpr (Order >= 2) set_radial_hessian(node.x, slope, R(scale * r.third * (M * (M - 2))), jet);
  }
}

/// jet = scale * log r, r in the input's unit of length, and its derivatives up to Order.
template <int Order, int Dim, Scalar R>
void log_jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
  using std::log;
  const R r2 = squared_distance<Dim>(node.x);
  jet.value = scale * (log(r2) / 2 + node.log_unit);
  if constexpr (Order >= 1) {
    const R inverse = 1 / r2;
    const R slope = scale * inverse;
    set_radial_gradient(node.x, slope, jet);
    if constexpr (Order >= 2) set_radial_hessian(node.x, slope, R(-2 * slope * inverse), jet);
  }
}

/// jet = scale * r^2 (log r + constant), r in the input's unit of length where it is in the logarithm, and its
/// derivatives up to Order.
template <int Order, int Dim, Scalar R>
void square_log_jet(const Node<R>& node, const R& scale, const R& constant, KernelJet<Dim, R>& jet) {
  using std::log;
  const R r2 = squared_distance<Dim>(node.x);
  const R logarithm = log(r2) / 2 + node.log_unit + constant;
  jet.value = scale * r2 * logarithm;
  if constexpr (Order >= 1) {
    const R slope = scale * (2 * logarithm + 1);
    set_radial_gradient(node.x, slope, jet);
    if constexpr (Order >= 2) set_radial_hessian(node.x, slope, R(2 * scale / r2), jet);
  }
}

/// jet = scale * (x.n) r^M and its derivatives up to Order; d(x.n)/d eta = -n.
template <int M, int Order, int Dim, Scalar R>
void height_power_jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
  const Vec3<R>& x = node.x;
  const Vec3<R>& n = node.normal;
  const Powers<M, Dim, R> r(x);
  const R power = scale * r.first;
  jet.value = node.height * power;
  if constexpr (Order >= 1) {
    const R slope = scale * r.second * M;
    const R height_slope = node.height * slope;
    for (int i = 0; i < Dim; ++i) jet.gradient[i] = -(n[i] * power + height_slope * x[i]);
    if constexpr (Order >= 2) {
      // The sum of slope (n x' + x n') and bend x x' is x y' + y x'.
      const R half_bend = scale * r.third * node.height * (M * (M - 2)) / 2;
      std::array<R, Dim> y;
      for (int i = 0; i < Dim; ++i) y[i] = slope * n[i] + half_bend * x[i];
      for (int i = 0, entry = 0; i < Dim; ++i)
        for (int j = i; j < Dim; ++j, ++entry)
          jet.hessian[entry] = i == j ? 2 * (x[i] * y[i]) + height_slope : R(x[i] * y[j] + x[j] * y[i]);
    }
  }
}

/// The product of two jets, up to Order.
template <int Order, int Dim, Scalar R>
KernelJet<Dim, R> product(const KernelJet<Dim, R>& a, const KernelJet<Dim, R>& b) {
  KernelJet<Dim, R> p;
  p.value = a.value * b.value;
  if constexpr (Order >= 1)
    for (int i = 0; i < Dim; ++i) p.gradient[i] = a.value * b.gradient[i] + b.value * a.gradient[i];
  if constexpr (Order >= 2)
    for (int i = 0, entry = 0; i < Dim; ++i)
      for (int j = i; j < Dim; ++j, ++entry)
        p.hessian[entry] = a.value * b.hessian[entry] + b.value * a.hessian[entry] +
                           (a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i]);
  return p;
}

/// x.n, whose value the rule states.
template <int Dim, Scalar R>
KernelJet<Dim, R> height_jet(const Node<R>& node) {
  KernelJet<Dim, R> jet;
  jet.value = node.height;
  for (int i = 0; i < Dim; ++i) jet.gradient[i] = -node.normal[i];
  return jet;
}

}  // namespace cageproof::quadrature_ref
