// SPDX-License-Identifier: MIT
// The edge form, a triangle's moments as sums over its three edges: solid angle, int 1/r and int r, plain and weighted
// with hat functions, as Taylor polynomials.
#pragma once

#include "cageproof/closed_form/arithmetic/constants.h"
#include "cageproof/closed_form/triangle/engine/edge_integrals.h"

#include <algorithm>
#include <optional>

namespace cageproof::closed_form::triangle {

/// A potential's moments near the triangle. Source: divergence theorem over the triangle, one term per edge. x = xi -
/// eta goes from the point eta to xi on the triangle; d <= 0 inside. On the triangle (d = 0) every moment is the limit
/// from inside, eta - t n with t -> 0+.
///
/// N is the highest degree of J, I and A, which need degree N - 1 of omega and L; M >= N - 1 is that of omega, L and B.
/// J, I, A and B are computed when first asked for, and kept: several formulas may take them from one form, within one
/// thread. The frame must outlive it.
template <class R, int N, int M>
class EdgeForm {
  static_assert(M >= 0 && M <= 3 && N <= M + 1);

 public:
  /// \param border_log the value of L, the integral of 1/r over an edge, for points on the edge, where it diverges;
  /// with zero, results there leave L out, as Batch::finite_part asks
  explicit EdgeForm(const Frame<R>& frame, const R& border_log = R(0));

  const Frame<R>& frame() const { return frame_; }
  /// omega = int x.n/r^3: the solid angle, positive inside; in (-2 pi, 2 pi].
  const Taylor<R, M>& omega() const { return omega_; }
  /// int 1/r.
  const Taylor<R, N>& J() const {
    if (!J_) J_ = inverse_distance();
    return *J_;
  }
  /// int r.
  const Taylor<R, N>& I() const {
    if (!I_) I_ = distance();
    return *I_;
  }
  /// int Gamma_k/r of each corner.
  const std::array<Taylor<R, N>, 3>& A() const {
    if (!A_) A_ = hats_over_distance();
    return *A_;
  }
  /// int Gamma_k x.n/r^3 of each corner.
  const std::array<Taylor<R, M>, 3>& B() const {
    if (!B_) B_ = hats_of_solid_angle();
    return *B_;
  }

 private:
  Taylor<R, N> inverse_distance() const;
  Taylor<R, N> distance() const;
  std::array<Taylor<R, N>, 3> hats_over_distance() const;
  std::array<Taylor<R, M>, 3> hats_of_solid_angle() const;

  const FrameEdge<R>& edge(int i) const { return frame_.edges[i]; }
  // a u + b v.
  static std::array<R, 3> combined(const R& a, const Vec3<R>& u, const R& b, const Vec3<R>& v) {
    return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
  }
  static Vec3<R> negative(const Vec3<R>& v) { return {-v[0], -v[1], -v[2]}; }
  // nu.g of edge i.
  R across(int i, const Vec3<R>& g) const {
    const Vec3<R>& nu = edge(i).nu;
    return nu[0] * g[0] + nu[1] * g[1] + nu[2] * g[2];
  }
  template <int D>
  static Taylor<R, D> with_value(Taylor<R, D> f, const R& value) {
    f.c[0] = value;
    return f;
  }

  // Sets L_[i], and adds edge i's part of omega: grad omega = sum K3 (d nu + h n). The change of this vector with delta
  // is normal to delta, so only its constant part enters.
  void add_edge(int i);
  const std::array<Taylor<R, N>, 3>& P() const {
    if (!P_) P_ = {edge_distance(0), edge_distance(1), edge_distance(2)};
    return *P_;
  }
  Taylor<R, N> edge_distance(int i) const;
  // r1^p - r0^p as a polynomial, `value` its constant without cancellation.
  template <int D>
  static Taylor<R, D> ends(const Vec3<R>& p0, const Vec3<R>& p1, const R& r0, const R& r1, int p, const R& value) {
    Taylor<R, D> f;
    if constexpr (D >= 1) {
      // At a corner, powers of its distance have no derivatives: they would be multiplied by zero, or enter orders
      // without a limit.
      if (r1 != R(0)) f = distance_power<D>(p1, power(r1, p), r1, p);
      if (r0 != R(0)) f.add(R(-1), distance_power<D>(p0, power(r0, p), r0, p));
    }
    f.c[0] = value;
    return f;
  }
  static R power(const R& r, int p) {
    if (p == 1) return r;
    const R q = R(1) / r;
    R f = q;
    for (int i = -1; i > p; i -= 2) f *= q * q;
    return f;
  }

  static R dot(const Vec3<R>& a, const Vec3<R>& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// van Oosterom-Strackee; next to an edge, angles edge by edge. On the triangle the limits from inside: 2 pi within,
  /// pi on an edge, the triangle's angle at a corner.
  R solid_angle() const;

  const Frame<R>& frame_;
  std::array<OddIntegrals<R>, 3> odd_;
  std::array<Taylor<R, M>, 3> L_;
  Taylor<R, M> omega_;
  mutable std::optional<Taylor<R, N>> J_, I_;
  mutable std::optional<std::array<Taylor<R, N>, 3>> A_, P_;
  mutable std::optional<std::array<Taylor<R, M>, 3>> B_;
};

template <class R, int N, int M>
EdgeForm<R, N, M>::EdgeForm(const Frame<R>& frame, const R& border_log)
    : frame_(frame),
      odd_{OddIntegrals<R>(frame, 0, border_log), OddIntegrals<R>(frame, 1, border_log),
           OddIntegrals<R>(frame, 2, border_log)} {
  omega_.c[0] = solid_angle();
  for (int i = 0; i < 3; ++i) add_edge(i);
  for (int k = 1; k <= M; ++k) omega_.divide_part(k, R(k));
}

template <class R, int N, int M>
Taylor<R, N> EdgeForm<R, N, M>::inverse_distance() const {
  Taylor<R, N> j;
  j.c[0] = frame_.d * omega_.c[0] + frame_.area2 / frame_.farthest();
  for (int i = 0; i < 3; ++i) j.c[0] += edge(i).h * odd_[i].L_rest;
  for (int k = 1; k <= N; ++k) {
    j.add_raised(k, frame_.n, omega_);
    for (int i = 0; i < 3; ++i)
      j.add_raised(k, Vec3<R>(negative(edge(i).nu)), k == 1 ? with_value(L_[i], odd_[i].L_rest) : L_[i]);
    j.divide_part(k, R(k));
  }
  return j;
}

template <class R, int N, int M>
Taylor<R, N> EdgeForm<R, N, M>::distance() const {
  const Taylor<R, N>& j = J();
  Taylor<R, N> f;
  f.c[0] = frame_.d * frame_.d * j.c[0] + frame_.area2 * frame_.farthest();
  for (int i = 0; i < 3; ++i) f.c[0] += edge(i).h * odd_[i].P_rest;
  f.c[0] /= R(3);
  Taylor<R, N> height;  // (d + n.delta) J
  height.add_linear(frame_.d, frame_.n, j);
  const auto& p = P();
  for (int k = 1; k <= N; ++k) {
    f.add_raised(k, frame_.n, height);
    for (int i = 0; i < 3; ++i)
      f.add_raised(k, Vec3<R>(negative(edge(i).nu)), k == 1 ? with_value(p[i], odd_[i].P_rest) : p[i]);
    f.divide_part(k, R(k));
  }
  return f;
}

template <class R, int N, int M>
std::array<Taylor<R, N>, 3> EdgeForm<R, N, M>::hats_over_distance() const {
  const Taylor<R, N>& j = J();
  const std::array<Taylor<R, N>, 3> p{with_value(P()[0], odd_[0].P_rest), with_value(P()[1], odd_[1].P_rest),
                                      with_value(P()[2], odd_[2].P_rest)};
  std::array<Taylor<R, N>, 3> a;
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> g = frame_.hat_gradient(k);
    a[k].add_linear(frame_.hat(k), g, j);
    for (int i = 0; i < 3; ++i) a[k].add(across(i, g), p[i]);
  }
  return a;
}

template <class R, int N, int M>
std::array<Taylor<R, M>, 3> EdgeForm<R, N, M>::hats_of_solid_angle() const {
  const std::array<Taylor<R, M>, 3> l{with_value(L_[0], odd_[0].L_rest), with_value(L_[1], odd_[1].L_rest),
                                      with_value(L_[2], odd_[2].L_rest)};
  std::array<Taylor<R, M>, 3> b;
  for (int k = 0; k < 3; ++k) {
    const Vec3<R> g = frame_.hat_gradient(k);
    b[k].add_linear(frame_.hat(k), g, omega_);
    Taylor<R, M> sum;
    for (int i = 0; i < 3; ++i) sum.add(across(i, g), l[i]);
    b[k].add_linear(frame_.d, frame_.n, sum);
  }
  return b;
}

template <class R, int N, int M>
void EdgeForm<R, N, M>::add_edge(int i) {
  const FrameEdge<R>& e = edge(i);
  const OddIntegrals<R>& o = odd_[i];
  L_[i].c[0] = o.L;
  if constexpr (M >= 1) {
    const R &r0 = e.r0, &r1 = e.r1;
    const Vec3<R>&p0 = frame_.p[i], &p1 = frame_.p[(i + 1) % 3];
    Taylor<R, M - 1> K3;
    K3.c[0] = o.K3;
    if constexpr (M >= 2) {
      Taylor<R, M - 2> K5;
      K5.c[0] = o.K5;
      if constexpr (M >= 3) {
        Taylor<R, 0> K7;
        K7.c[0] = o.K7;
        K5 = edge_power<M - 2>(e, frame_.n, frame_.d, -5, o.K5, ends<M - 3>(p0, p1, r0, r1, -5, o.ends[3]), K7);
      }
      K3 = edge_power<M - 1>(e, frame_.n, frame_.d, -3, o.K3, ends<M - 2>(p0, p1, r0, r1, -3, o.ends[2]), K5);
    }
    L_[i] = edge_power<M>(e, frame_.n, frame_.d, -1, o.L, ends<M - 1>(p0, p1, r0, r1, -1, o.ends[1]), K3);
    const std::array<R, 3> turn = combined(frame_.d, e.nu, e.h, frame_.n);
    for (int k = 1; k <= M; ++k) omega_.add_raised(k, turn, K3);
  }
}

template <class R, int N, int M>
Taylor<R, N> EdgeForm<R, N, M>::edge_distance(int i) const {
  const FrameEdge<R>& e = edge(i);
  Taylor<R, N> p;
  p.c[0] = odd_[i].P;
  if constexpr (N >= 1)
    p = edge_power<N>(e, frame_.n, frame_.d, 1, odd_[i].P,
                      ends<N - 1>(frame_.p[i], frame_.p[(i + 1) % 3], e.r0, e.r1, 1, odd_[i].ends[0]), L_[i]);
  return p;
}

template <class R, int N, int M>
R EdgeForm<R, N, M>::solid_angle() const {
  using std::abs, std::atan2, std::max;
  const auto& p = frame_.p;
  const auto& r = frame_.r;
  const R& d = frame_.d;
  if (d == R(0)) {
    for (int k = 0; k < 3; ++k)
      if (r[k] == R(0)) return atan2(frame_.area2, dot(p[(k + 1) % 3], p[(k + 2) % 3]));
    if (on_edge(edge(0)) || on_edge(edge(1)) || on_edge(edge(2))) return constant_pi<R>();
    return frame_.on_triangle() ? R(2) * constant_pi<R>() : R(0);
  }
  const R bulk = r[0] * r[1] * r[2];
  const R denominator = bulk + dot(p[0], p[1]) * r[2] + dot(p[1], p[2]) * r[0] + dot(p[2], p[0]) * r[1];
  const R numerator = -d * frame_.area2;
  // Next to an edge the denominator cancels; angles edge by edge do not, given accurate heights.
  if (R(10) * abs(numerator) < bulk && R(10) * abs(denominator) < bulk) {
    const R height = abs(d);
    R sum = R(0);
    if (edge(0).h < R(0) || edge(1).h < R(0) || edge(2).h < R(0)) {
      // Over the plane outside the triangle the angles in the plane sum to zero, so the sum is over the angles that the
      // height takes off them: atan(s height/(h r)) at each end.
      const auto taken = [&](const FrameEdge<R>& e, const R& along, const R& away) {
        return e.h < R(0) ? R(atan2(R(-along * height), R(-e.h * away))) : R(atan2(R(along * height), R(e.h * away)));
      };
      for (int i = 0; i < 3; ++i) {
        const FrameEdge<R>& e = edge(i);
        if (e.h != R(0)) sum += taken(e, e.s0, e.r0) - taken(e, e.s1, e.r1);
      }
      return d < R(0) ? sum : R(-sum);
    }
    for (int i = 0; i < 3; ++i) {
      const FrameEdge<R>& e = edge(i);
      if (e.h == R(0)) continue;
      sum += atan2(R(e.h * e.s1), R(e.D2 + height * e.r1)) - atan2(R(e.h * e.s0), R(e.D2 + height * e.r0));
    }
    return d < R(0) ? sum : R(-sum);
  }
  return R(2) * atan2(numerator, denominator);
}

}  // namespace cageproof::closed_form::triangle
