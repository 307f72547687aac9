// SPDX-License-Identifier: MIT
// The same moments far away, where closed forms cancel: Gauss-Legendre points on the triangle, as few as an error bound allows.
#pragma once

#include "cageproof/closed_form/taylor.h"
#include "cageproof/closed_form/triangle/frame.h"
#include "cageproof/core/gauss_legendre.h"

#include <optional>

namespace cageproof::closed_form {

/// How far the point is, as the Gauss-Legendre rule sees it: on a segment of length l whose ends are r0 and r1 away the integrand's
/// singularities lie on the ellipse rho + 1/rho = 2 (r0 + r1)/l, and the rule's error falls like rho^(-2n). This is the smallest rho over
/// all segments within the triangle: (r0 + r1)/l >= 2 (distance of the triangle)/(longest edge).
template <class R>
double ellipse_of(const Frame<R>& f) {
  using std::sqrt;
  const Vec3<R> centre = (f.p[0] + f.p[1] + f.p[2]) / R(3);
  double size = 0, reach = 0;
  for (int i = 0; i < 3; ++i) {
    size = std::max(size, static_cast<double>(f.edges[i].length));
    const Vec3<R> arm = f.p[i] - centre;
    reach = std::max(reach, static_cast<double>(R(sqrt(arm.dot(arm)))));
  }
  const double ratio = 2 * (static_cast<double>(R(sqrt(centre.dot(centre)))) - reach) / size;
  return ratio > 1 ? ratio + std::sqrt(ratio * ratio - 1) : 1;
}

/// Bound of the relative error of n x n points for the hat functions times r^p and its derivatives up to degree N, norm-wise. Two of the
/// degrees that the rule is exact for go to the hat function and the area element.
inline double far_error(int n, double rho, int p, int degree) {
  // Each power of 1/r, and each derivative, may raise the integrand on the ellipse once; far_form_test.cpp holds the constant.
  const int steepness = std::abs(p) + degree;
  return 4 * std::pow(1 + 2.0 * n / (steepness + 1), steepness) * std::pow(rho, -2.0 * (n - 1));
}

/// The fewest points a side that are good to `tolerance`; nothing if more than `limit` would be needed.
inline std::optional<int> far_points(double rho, int p, int degree, double tolerance, int limit) {
  for (int n = 2; n <= limit; ++n)
    if (far_error(n, rho, p, degree) <= tolerance) return n;
  return std::nullopt;
}

/// The most points a side that the far form takes.
inline constexpr int kFarLimit = 20;
/// What rounding may add up to over its nodes, relative to the result: positive weights, each kernel to some ten roundings.
inline constexpr double far_roundoff = 64 * 0x1p-53;

/// A potential's moments far from the triangle, N and M as in EdgeForm.
template <Scalar R, int N, int M>
class FarForm {
 public:
  /// \param n points a side, 2 <= n <= 64
  FarForm(const Frame<R>& frame, int n) : frame_(frame), rule_(gauss_legendre<R>(n)) {}

  const Frame<R>& frame() const { return frame_; }
  Taylor<R, M> omega() const {
    Taylor<R, M> omega;
    omega.add_linear(-frame_.d, Vec3<R>(-frame_.n), total<M>(hats<-3, M>()));
    return omega;
  }
  Taylor<R, N> J() const { return total<N>(hats<-1, N>()); }
  Taylor<R, N> I() const { return total<N>(hats<1, N>()); }
  std::array<Taylor<R, N>, 3> A() const { return hats<-1, N>(); }
  std::array<Taylor<R, M>, 3> B() const { return times_height<M>(hats<-3, M>()); }
  /// int Gamma_k x.n/r^4 of each corner.
  std::array<Taylor<R, N>, 3> mean_value() const { return times_height<N>(hats<-4, N>()); }

 private:
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
    for (int k = 0; k < 3; ++k) product[k].add_linear(-frame_.d, Vec3<R>(-frame_.n), parts[k]);
    return product;
  }

  /// int Gamma_k r^p of each corner: the square collapsed towards corner 0.
  template <int p, int D>
  std::array<Taylor<R, D>, 3> hats() const;

  const Frame<R>& frame_;
  const GaussLegendre<R>& rule_;
};

template <Scalar R, int N, int M>
template <int p, int D>
std::array<Taylor<R, D>, 3> FarForm<R, N, M>::hats() const {
  using std::sqrt;
  std::array<Taylor<R, D>, 3> sums;
  const auto& [nodes, weights] = rule_;
  const Vec3<R> side = frame_.p[1] - frame_.p[0], base = frame_.p[2] - frame_.p[1];
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const R& u = nodes[i];
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const R& v = nodes[j];
      const Vec3<R> x = frame_.p[0] + u * (side + v * base);
      const R r2 = x.dot(x), r = sqrt(r2);
      const R weight = frame_.area2 * u * weights[i] * weights[j];
      R value = weight;
      if constexpr (p == 1) value *= r;
      else if constexpr (p == -1) value /= r;
      else if constexpr (p == -3) value /= r2 * r;
      else value /= r2 * r2;
      const Taylor<R, D> power = distance_power<D>(x, value, r, p);
      const std::array<R, 3> hat{1 - u, u * (1 - v), u * v};
      for (int k = 0; k < 3; ++k) sums[k].add(hat[k], power);
    }
  }
  return sums;
}

}  // namespace cageproof::closed_form
