// SPDX-License-Identifier: MIT
// Powers of the distance with their derivatives with respect to the point: what kernels are made of.
#pragma once

#include "cageproof/quadrature_ref/kernel.h"

#include <array>
#include <cmath>

namespace cageproof::quadrature_ref {

/// A scalar function's value, gradient and Hessian (xx, xy, xz, yy, yz, zz) with respect to eta.
template <Scalar R>
struct Jet {
  R value{};
  std::array<R, 3> gradient{};
  std::array<R, 6> hessian{};
};

/// r^m for the consecutive powers M, M - 2, M - 4 that a jet of order 2 needs.
template <int M, Scalar R>
struct Powers {
  explicit Powers(const Vec3<R>& x) {
    using std::sqrt;
    const R r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
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

/// jet = scale * r^M and its derivatives up to Order (0, 1, 2).
template <int M, int Order, Scalar R>
void power_jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
  const Vec3<R>& x = node.x;
  const Powers<M, R> r(x);
  jet.value = scale * r.first;
  if constexpr (Order >= 1) {
    const R slope = scale * r.second * M;
    for (int i = 0; i < 3; ++i) jet.gradient[i] = -(slope * x[i]);
    if constexpr (Order >= 2) {
      const R bend = scale * r.third * (M * (M - 2));
      const std::array<R, 3> y{bend * x[0], bend * x[1], bend * x[2]};
      jet.hessian = {x[0] * y[0] + slope, x[0] * y[1], x[0] * y[2],
                     x[1] * y[1] + slope, x[1] * y[2], x[2] * y[2] + slope};
    }
  }
}

/// jet = scale * (x.n) r^M and its derivatives up to Order; d(x.n)/d eta = -n.
template <int M, int Order, Scalar R>
void height_power_jet(const Node<R>& node, const R& scale, Jet<R>& jet) {
  const Vec3<R>& x = node.x;
  const Vec3<R>& n = node.normal;
  const Powers<M, R> r(x);
  const R power = scale * r.first;
  jet.value = node.height * power;
  if constexpr (Order >= 1) {
    const R slope = scale * r.second * M;
    const R height_slope = node.height * slope;
    for (int i = 0; i < 3; ++i) jet.gradient[i] = -(n[i] * power + height_slope * x[i]);
    if constexpr (Order >= 2) {
      // The sum of slope (n x' + x n') and bend x x' is x y' + y x'.
      const R half_bend = scale * r.third * node.height * (M * (M - 2)) / 2;
      const std::array<R, 3> y{slope * n[0] + half_bend * x[0], slope * n[1] + half_bend * x[1],
                               slope * n[2] + half_bend * x[2]};
      jet.hessian = {2 * (x[0] * y[0]) + height_slope, x[0] * y[1] + x[1] * y[0], x[0] * y[2] + x[2] * y[0],
                     2 * (x[1] * y[1]) + height_slope, x[1] * y[2] + x[2] * y[1], 2 * (x[2] * y[2]) + height_slope};
    }
  }
}

}  // namespace cageproof::quadrature_ref
