// SPDX-License-Identifier: MIT
// The edge form: solid angle, int 1/r and int r over a triangle, plain and weighted with hat functions, with derivatives.
#pragma once

#include "cageproof/closed_form/triangle/edge_integrals.h"

namespace cageproof::closed_form {

/// Everything the layer potentials share. Source: divergence theorem over the triangle, one term an edge; x = xi - eta, d <= 0 inside.
/// On the triangle (d = 0) every quantity is the limit from inside, eta - t n with t -> 0+.
template <Scalar R>
class Potentials {
 public:
  Potentials(const Triangle<R>& t, const Vec3<R>& eta)
      : frame_(t, eta),
        odd_{OddIntegrals<R>(frame_, 0), OddIntegrals<R>(frame_, 1), OddIntegrals<R>(frame_, 2)},
        omega_(solid_angle()) {
    inverse_distance_ = frame_.d * omega_ + frame_.area2 / frame_.farthest();
    for (int i = 0; i < 3; ++i) inverse_distance_ += edge(i).h * odd_[i].L_rest;
  }

  const Frame<R>& frame() const { return frame_; }
  const FrameEdge<R>& edge(int i) const { return frame_.edges[i]; }
  const OddIntegrals<R>& odd(int i) const { return odd_[i]; }
  /// True on the triangle's border, where the gradients of omega and J do not exist.
  bool on_border() const { return on_edge(edge(0)) || on_edge(edge(1)) || on_edge(edge(2)); }

  /// omega = int x.n/r^3: the solid angle, positive inside; in (-2 pi, 2 pi].
  R omega() const { return omega_; }
  Vec3<R> grad_omega() const {
    Vec3<R> g = Vec3<R>::Zero();
    for (int i = 0; i < 3; ++i) g += odd_[i].K3 * (frame_.d * edge(i).nu + edge(i).h * frame_.n);
    return g;
  }
  Mat3<R> hess_omega() const {
    const Vec3<R>& n = frame_.n;
    const R& d = frame_.d;
    Mat3<R> m = Mat3<R>::Zero();
    for (int i = 0; i < 3; ++i) {
      const FrameEdge<R>& e = edge(i);
      const Vec3<R> w = d * e.nu + e.h * n;
      m += (3 * odd_[i].S5 / 2) * symmetric_outer<R>(e.u, w);
      m += 3 * odd_[i].K5 *
           (d * e.h * (e.nu * e.nu.transpose() - n * n.transpose()) +
            ((e.h - d) * (e.h + d) / 2) * symmetric_outer<R>(n, e.nu));
    }
    return m;
  }

  /// J = int 1/r.
  R J() const { return inverse_distance_; }
  Vec3<R> grad_J() const {
    Vec3<R> g = omega_ * frame_.n;
    for (int i = 0; i < 3; ++i) g -= odd_[i].L_rest * edge(i).nu;
    return g;
  }
  Mat3<R> hess_J() const {
    const Vec3<R>& n = frame_.n;
    Mat3<R> m = Mat3<R>::Zero();
    for (int i = 0; i < 3; ++i) {
      const FrameEdge<R>& e = edge(i);
      m += odd_[i].K3 *
           (e.h * (n * n.transpose() - e.nu * e.nu.transpose()) + frame_.d * symmetric_outer<R>(n, e.nu));
      m -= (odd_[i].S3 / 2) * symmetric_outer<R>(e.nu, e.u);
    }
    return m;
  }

  /// I = int r.
  R I() const {
    R sum = frame_.d * frame_.d * inverse_distance_;
    for (int i = 0; i < 3; ++i) sum += edge(i).h * odd_[i].P_rest;
    return (sum + frame_.area2 * frame_.farthest()) / 3;
  }
  Vec3<R> grad_I() const {
    Vec3<R> g = frame_.d * inverse_distance_ * frame_.n;
    for (int i = 0; i < 3; ++i) g -= odd_[i].P_rest * edge(i).nu;
    return g;
  }
  Mat3<R> hess_I() const {
    const Vec3<R>& n = frame_.n;
    Mat3<R> m = (inverse_distance_ + frame_.d * omega_) * n * n.transpose();
    for (int i = 0; i < 3; ++i) {
      const FrameEdge<R>& e = edge(i);
      const R half_difference = e.length * (e.s0 + e.s1) / (2 * (e.r0 + e.r1));
      m += odd_[i].L * (e.h * e.nu * e.nu.transpose() - frame_.d * symmetric_outer<R>(n, e.nu));
      m += half_difference * symmetric_outer<R>(e.nu, e.u);
    }
    return m;
  }

  /// Corner k's hat-weighted A = int Gamma_k/r and B = int Gamma_k x.n/r^3 share these sums over edges, weighted with nu.g.
  struct HatSums {
    R gamma;      ///< the hat function at the projection of the point
    Vec3<R> g;    ///< its gradient
    std::array<R, 3> weight;  ///< nu_e . g
  };
  HatSums hat(int k) const {
    HatSums s{frame_.hat(k), frame_.hat_gradient(k), {}};
    for (int i = 0; i < 3; ++i) s.weight[i] = edge(i).nu.dot(s.g);
    return s;
  }
  R A(const HatSums& s) const {
    R sum = s.gamma * inverse_distance_;
    for (int i = 0; i < 3; ++i) sum += s.weight[i] * odd_[i].P_rest;
    return sum;
  }
  Vec3<R> grad_A(const HatSums& s, const Vec3<R>& grad_of_J) const {
    Vec3<R> g = inverse_distance_ * s.g + s.gamma * grad_of_J;
    for (int i = 0; i < 3; ++i) g += s.weight[i] * gradient_P_rest(frame_, i, odd_[i]);
    return g;
  }
  Mat3<R> hess_A(const HatSums& s, const Vec3<R>& grad_of_J, const Mat3<R>& hess_of_J) const {
    Mat3<R> m = symmetric_outer<R>(s.g, grad_of_J) + s.gamma * hess_of_J;
    for (int i = 0; i < 3; ++i) m += s.weight[i] * hessian_P(edge(i), odd_[i]);
    return m;
  }
  R B(const HatSums& s) const {
    R sum = 0;
    for (int i = 0; i < 3; ++i) sum += s.weight[i] * odd_[i].L_rest;
    return s.gamma * omega_ + frame_.d * sum;
  }
  Vec3<R> grad_B(const HatSums& s, const Vec3<R>& grad_of_omega) const {
    R sum = 0;
    Vec3<R> gradient = Vec3<R>::Zero();
    for (int i = 0; i < 3; ++i) {
      sum += s.weight[i] * odd_[i].L_rest;
      gradient += s.weight[i] * gradient_L(edge(i), odd_[i]);
    }
    return omega_ * s.g + s.gamma * grad_of_omega + sum * frame_.n + frame_.d * gradient;
  }
  Mat3<R> hess_B(const HatSums& s, const Vec3<R>& grad_of_omega, const Mat3<R>& hess_of_omega) const {
    Vec3<R> gradient = Vec3<R>::Zero();
    Mat3<R> hessian = Mat3<R>::Zero();
    for (int i = 0; i < 3; ++i) {
      gradient += s.weight[i] * gradient_L(edge(i), odd_[i]);
      hessian += s.weight[i] * hessian_L(edge(i), odd_[i]);
    }
    return symmetric_outer<R>(s.g, grad_of_omega) + s.gamma * hess_of_omega +
           symmetric_outer<R>(frame_.n, gradient) + frame_.d * hessian;
  }

 private:
  /// van Oosterom-Strackee, with the limits from inside on the triangle: 2 pi within, pi on an edge, the angle at a corner.
  R solid_angle() const {
    using std::abs, std::atan2, std::max;
    const auto& p = frame_.p;
    const auto& r = frame_.r;
    if (frame_.d == 0) {
      for (int k = 0; k < 3; ++k)
        if (r[k] == 0) {
          const Vec3<R>&a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
          return atan2(frame_.area2, a.dot(b));
        }
      if (on_border()) return pi<R>();
      return frame_.on_triangle() ? 2 * pi<R>() : R(0);
    }
    const R denominator =
        r[0] * r[1] * r[2] + p[0].dot(p[1]) * r[2] + p[1].dot(p[2]) * r[0] + p[2].dot(p[0]) * r[1];
    const R numerator = -frame_.d * frame_.area2;
    const R bulk = r[0] * r[1] * r[2];
    // Next to an edge the denominator cancels; angles edge by edge do not, given accurate heights.
    if (10 * max(abs(numerator), abs(denominator)) < bulk) {
      const R height = abs(frame_.d);
      R sum = 0;
      for (int i = 0; i < 3; ++i) {
        const FrameEdge<R>& e = edge(i);
        if (e.h == 0) continue;
        sum += atan2(R(e.h * e.s1), R(e.D2 + height * e.r1)) - atan2(R(e.h * e.s0), R(e.D2 + height * e.r0));
      }
      return frame_.d < 0 ? sum : R(-sum);
    }
    return 2 * atan2(numerator, denominator);
  }

  Frame<R> frame_;
  std::array<OddIntegrals<R>, 3> odd_;
  R omega_;
  R inverse_distance_;
};

}  // namespace cageproof::closed_form
