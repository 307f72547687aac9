// SPDX-License-Identifier: MIT
// A segment whose integrals are sums over Gauss-Legendre points far away, where closed forms cancel. Closed forms find
// the functions here by the type of their frame.
#pragma once

#include "cageproof/closed_form/segment/engine/hat_integrals.h"
#include "cageproof/closed_form/segment/engine/logarithms.h"
#include "cageproof/closed_form/segment/engine/radial_moments.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "far_rule.h"

#include <optional>
#include <vector>

namespace cageproof::fast::segment {

/// A segment's frame for the far form. \tparam R double, or Counted
template <Scalar R>
struct FarFrame : Frame<R> {
  using Frame<R>::Frame;
};

/// Every term has the sum's phase up to the angle that the segment fills.
template <int O, Scalar R>
HatIntegrals<O, R> hat_integrals(const FarFrame<R>& f) {
  if (!f.is_far()) return HatIntegrals<O, R>(f);
  std::array<Complex<R>, 2> inverse{}, square{};
  const auto& [nodes, weights] = gauss_legendre<R>(far_points(f));
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const R along = f.s[0] + f.length * nodes[j], square_of_r = along * along + f.h * f.h;
    const Complex<R> q{along / square_of_r, f.h / square_of_r}, q2 = q * q;
    const std::array<R, 2> hat{1 - nodes[j], nodes[j]};
    for (int k = 0; k < 2; ++k) {
      const R weight = weights[j] * f.length * hat[k];
      inverse[k] = inverse[k] + weight * q;
      square[k] = square[k] + weight * q2;
    }
  }
  return {inverse, square};
}

template <Scalar R>
std::array<R, 2> hat_logarithms(const FarFrame<R>& f) {
  using std::log;
  if (!f.is_far()) return hat_logarithms(static_cast<const Frame<R>&>(f));
  std::array<R, 2> hats{};
  const auto& [nodes, weights] = gauss_legendre<R>(far_points(f));
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const R along = f.s[0] + f.length * nodes[j];
    const R logarithm = weights[j] * f.length / 2 * log(R(along * along + f.h * f.h));
    hats[0] += (1 - nodes[j]) * logarithm;
    hats[1] += nodes[j] * logarithm;
  }
  return hats;
}

template <Scalar R>
SquareLogarithm<R> square_logarithm(const FarFrame<R>& f) {
  using std::log;
  if (!f.is_far()) return square_logarithm(static_cast<const Frame<R>&>(f));
  SquareLogarithm<R> of;
  const auto& [nodes, weights] = gauss_legendre<R>(far_points(f));
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const R s = f.s[0] + f.length * nodes[j], square = s * s + f.h * f.h, logarithm = log(square);
    const R weight = weights[j] * f.length;
    of.value += weight * square * (logarithm / 2 - 1);
    of.along += weight * s * (logarithm - 1);
    of.across -= weight * f.h * (logarithm - 1);
  }
  return of;
}

/// RadialMoments, or the same from Gauss points.
template <Scalar R>
class FarRadialMoments {
 public:
  FarRadialMoments(const FarFrame<R>& f, int most) : f_(f) {
    using std::log;
    if (!f.is_far()) {
      near_.emplace(f, most);
      return;
    }
    const R unit = unit_logarithm(f);
    // The rule is exact up to a degree, of which each factor s^2 takes two: one point more.
    const auto& [nodes, weights] = gauss_legendre<R>(far_points(f) + (most + 1) / 2);
    nodes_.reserve(nodes.size());
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const R s = f.s[0] + f.length * nodes[j], square = s * s + f.h * f.h;
      nodes_.push_back({s, weights[j] * f.length, square, log(square) / 2 + unit, {1 - nodes[j], nodes[j]}});
    }
  }

  R integral(int i, const Radial<R>& g, int k) const {
    if (near_) return near_->integral(i, g, k);
    return sum(g, [&](const Node& n) { return power(n.s, i); }) * power(f_.h, k);
  }
  R integral_of_hat(int end, int i, const Radial<R>& g, int k) const {
    if (near_) return near_->integral_of_hat(end, i, g, k);
    return sum(g, [&](const Node& n) { return n.hat[end] * power(n.s, i); }) * power(f_.h, k);
  }

 private:
  struct Node {
    R s, weight, square, logarithm;
    std::array<R, 2> hat;
  };

  template <class Factor>
  R sum(const Radial<R>& g, const Factor& factor) const {
    R sum = 0;
    for (const Node& n : nodes_) {
      const R radial = g.power < 0 ? R(1 / n.square) : power(n.square, g.power);
      sum += n.weight * factor(n) * radial * (g.log * n.logarithm + g.plain);
    }
    return sum;
  }

  const FarFrame<R>& f_;
  std::optional<RadialMoments<R>> near_;
  std::vector<Node> nodes_;  // none nearby
};

template <Scalar R>
FarRadialMoments<R> radial_moments(const FarFrame<R>& f, int most) {
  return FarRadialMoments<R>(f, most);
}

}  // namespace cageproof::fast::segment
