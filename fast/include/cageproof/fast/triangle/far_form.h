// SPDX-License-Identifier: MIT
// The moments of closed forms far away, where these cancel: Gauss-Legendre points on the triangle, as few as an error
// bound allows.
#pragma once

#include "cageproof/closed_form/arithmetic/taylor.h"
#include "cageproof/closed_form/triangle/engine/frame.h"
#include "cageproof/core/numbers/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cageproof::fast::triangle {

using namespace closed_form;
using namespace closed_form::triangle;

/// How far the point is, as the Gauss-Legendre rule sees it: on a segment of length l whose ends are r0 and r1 away the
/// integrand's singularities lie on the ellipse rho + 1/rho = 2 (r0 + r1)/l, and the rule's error falls like rho^(-2n).
/// A lower bound of rho over all segments within the triangle, above 1 down to the triangle: (r0 + r1)/l >= sqrt(1 + (2
/// distance/l)^2), l at most the longest edge.
template <class R>
double ellipse_of(const Frame<R>& f) {
  R size = f.edges[0].length;
  for (int i = 1; i < 3; ++i)
    if (f.edges[i].length > size) size = f.edges[i].length;
  const double slope = 2 * static_cast<double>(R(distance_of(f) / size));
  return slope + std::hypot(1, slope);
}

/// Bound of the relative error of n x n points for the hat functions times r^p and its derivatives up to degree N,
/// norm-wise. Two of the degrees that the rule is exact for go to the hat function and the area element.
inline double far_error(int n, double rho, int p, int degree) {
  // Each power of 1/r, and each derivative, may raise the integrand on the ellipse once; far_form_test.cpp holds the
  // constant.
  const int steepness = std::abs(p) + degree;
  return 4 * std::pow(1 + 2.0 * n / (steepness + 1), steepness) * std::pow(rho, -2.0 * (n - 1));
}

/// The largest error allowed of the far form: a quarter of a rounding.
inline constexpr double kFarTolerance = 0x1p-55;

/// A rule's number in the arithmetic of the form.
template <class R, Scalar S>
R rule_number(const S& x) {
  if constexpr (Scalar<R>) return x;
  else return R(x, size_of(x));
}

/// A potential's moments far from the triangle, N and M as in EdgeForm, from sums over Gauss points. Sums are computed
/// when first asked for, and kept, within one thread. The frame must outlive it.
/// \tparam Sums has `template <int p, int D> std::array<Taylor<R, D>, 3> hats(const Frame<R>&) const`: int Gamma_k r^p
/// of each corner
template <class R, int N, int M, class Sums>
class HatMoments {
 public:
  template <class... From>
  explicit HatMoments(const Frame<R>& frame, const From&... from) : frame_(frame), sums_(from...) {}

  const Sums& sums() const { return sums_; }
  const Frame<R>& frame() const { return frame_; }
  Taylor<R, M> omega() const {
    Taylor<R, M> omega;
    omega.add_linear(-frame_.d, opposite_normal(), total<M>(kept<-3>(cubes_)));
    return omega;
  }
  Taylor<R, N> J() const { return total<N>(A()); }
  Taylor<R, N> I() const { return total<N>(hats<1, N>()); }
  const std::array<Taylor<R, N>, 3>& A() const { return kept<-1>(inverses_); }
  std::array<Taylor<R, M>, 3> B() const { return times_height<M>(kept<-3>(cubes_)); }
  /// int Gamma_k x.n/r^4 of each corner.
  std::array<Taylor<R, N>, 3> mean_value() const { return times_height<N>(hats<-4, N>()); }

 private:
  Vec3<R> opposite_normal() const { return {-frame_.n[0], -frame_.n[1], -frame_.n[2]}; }
  template <int D>
  static Taylor<R, D> total(const std::array<Taylor<R, D>, 3>& parts) {
    Taylor<R, D> sum = parts[0];
    sum += parts[1];
    sum += parts[2];
    return sum;
  }
  // x.n = -(d + n.delta) all over the triangle.
  template <int D>
  std::array<Taylor<R, D>, 3> times_height(const std::array<Taylor<R, D>, 3>& parts) const {
    std::array<Taylor<R, D>, 3> product;
    for (int k = 0; k < 3; ++k) product[k].add_linear(-frame_.d, opposite_normal(), parts[k]);
    return product;
  }

  template <int p, int D>
  std::array<Taylor<R, D>, 3> hats() const {
    return sums_.template hats<p, D>(frame_);
  }
  template <int p, int D>
  const std::array<Taylor<R, D>, 3>& kept(std::optional<std::array<Taylor<R, D>, 3>>& sums) const {
    if (!sums) sums = hats<p, D>();
    return *sums;
  }

  const Frame<R>& frame_;
  Sums sums_;
  mutable std::optional<std::array<Taylor<R, N>, 3>> inverses_;  // of r^-1
  mutable std::optional<std::array<Taylor<R, M>, 3>> cubes_;     // of r^-3
};

/// int lambda_k r^p over the triangle with corners at corner, corner + side and corner + side + base from the point,
/// lambda_k its three affine weights: Gauss points on the square collapsed towards the first corner.
template <int p, int D, class R, Scalar S>
std::array<Taylor<R, D>, 3> collapsed_sums(const Vec3<R>& corner, const Vec3<R>& side, const Vec3<R>& base,
                                           const R& area2, const GaussLegendre<S>& across,
                                           const GaussLegendre<S>& along) {
  using std::sqrt;
  std::array<Taylor<R, D>, 3> sums;
  for (std::size_t i = 0; i < across.nodes.size(); ++i) {
    const R u = rule_number<R>(across.nodes[i]);
    std::array<Taylor<R, D>, 3> row;  // sums of sums round less
    for (std::size_t j = 0; j < along.nodes.size(); ++j) {
      const R v = rule_number<R>(along.nodes[j]);
      Vec3<R> x;
      for (int c = 0; c < 3; ++c) x[c] = corner[c] + u * (side[c] + v * base[c]);
      const R r2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], r = sqrt(r2);
      R value = area2 * u * rule_number<R>(across.weights[i]) * rule_number<R>(along.weights[j]);
      if constexpr (p == 1) value *= r;
      else if constexpr (p == -1) value /= r;
      else if constexpr (p == -3) value /= r2 * r;
      else value /= r2 * r2;
      const Taylor<R, D> power = distance_power<D>(x, value, r, p);
      const std::array<R, 3> hat{R(1) - u, u * (R(1) - v), u * v};
      for (int k = 0; k < 3; ++k) row[k].add(hat[k], power);
    }
    for (int k = 0; k < 3; ++k) sums[k] += row[k];
  }
  return sums;
}

}  // namespace cageproof::fast::triangle
