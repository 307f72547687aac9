// SPDX-License-Identifier: MIT
// A triangle seen from a point in the notation of [T24] Section 3. As printed: nothing is stabilised, and special
// positions are those that are met exactly.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "cageproof/core/geometry/element.h"

#include <cmath>

namespace cageproof::closed_form::published {

/// G_k = lambda_k r^(2k-3) ([T24] Eq 2): lambda_1 = -1/(4 pi), lambda_2 = -1/(8 pi).
template <Scalar R>
R lambda1() {
  return R(-1) / (4 * pi<R>());
}
template <Scalar R>
R lambda2() {
  return R(-1) / (8 * pi<R>());
}

/// T(u; v) = u v' + v u' ([T24] Section 3).
template <Scalar R>
Mat3<R> tensor(const Vec3<R>& u, const Vec3<R>& v) {
  return u * v.transpose() + v * u.transpose();
}
/// T(M; L) = M L' + L M' ([T24] Section 3).
template <Scalar R>
Mat3<R> matrix_tensor(const Mat3<R>& m, const Mat3<R>& l) {
  return m * l.transpose() + l * m.transpose();
}

/// An edge e = (e0, e1) of the triangle seen from eta, in the caller's units of length.
template <Scalar R>
struct Edge {
  Vec3<R> e;                     ///< e1 - e0
  R length;                      ///< ||e||
  Vec3<R> u, r;                  ///< u_e, and r_e = n x u_e, which points into the triangle
  std::array<Vec3<R>, 2> arrow;  ///< eta - e_i
  std::array<R, 2> l;            ///< l_{e_i} = ||eta - e_i||
  std::array<R, 2> zeta;         ///< zeta_{e_i} = (eta - e_i).u_e
  R a;  ///< a_e = r_e.(eta - e0): the point's distance from the line within the plane, positive on the triangle's side
  Vec3<R> D;     ///< D_e = P_e (eta - e0), from the line to the point
  R D2;          ///< ||D_e||^2
  bool on_line;  ///< eta lies exactly on the line (e0 e1): the blue terms alone remain
  bool on_edge;  ///< and between e0 and e1, ends included

  /// log((l1 - zeta1)/(l0 - zeta0)); infinite or NaN on the edge, and where the differences cancel to zero.
  R log_ratio() const {
    using std::log;
    return log((l[1] - zeta[1]) / (l[0] - zeta[0]));
  }
  /// P_e = I - u_e u_e', the projection across the edge.
  Mat3<R> P() const { return Mat3<R>::Identity() - u * u.transpose(); }
  /// u_{e_i} = (eta - e_i)/l_{e_i}; NaN at e_i.
  Vec3<R> unit(int i) const { return arrow[i] / l[i]; }
  /// u_{e_i} zeta_{e_i}, which vanishes at e_i.
  Vec3<R> unit_zeta(int i) const { return l[i] == 0 ? Vec3<R>(Vec3<R>::Zero()) : Vec3<R>(unit(i) * zeta[i]); }
  /// m_{e_i} = grad log(l_{e_i} - zeta_{e_i}); not finite on the line ahead of e_i, where l_{e_i} = zeta_{e_i}.
  Vec3<R> m(int i) const { return (unit(i) - u) / (l[i] - zeta[i]); }
  /// U_{e_i}, the Hessian of l_{e_i}; not finite at e_i.
  Mat3<R> U(int i) const {
    const R l2 = l[i] * l[i];
    return (l2 * Mat3<R>::Identity() - arrow[i] * arrow[i].transpose()) / (l2 * l[i]);
  }
  /// M_{e_i}, the Hessian of log(l_{e_i} - zeta_{e_i}); not finite where m_{e_i} is not.
  Mat3<R> M(int i) const { return U(i) / (l[i] - zeta[i]) - m(i) * m(i).transpose(); }
  /// (l0 + l1)^2 - ||e||^2
  R q() const { return (l[0] + l[1]) * (l[0] + l[1]) - length * length; }
};

/// A triangle seen from a point. \pre the triangle has an area
template <Scalar R>
struct Frame {
  Triangle<R> t;
  Vec3<R> eta;
  R twice_area;                  ///< 2 |t|
  Vec3<R> n;                     ///< unit normal, outward
  R d;                           ///< d_t = (eta - t^0).n: negative inside
  std::array<Edge<R>, 3> edges;  ///< edge i from t^i to t^{i+1}
  std::array<Vec3<R>, 3> g;      ///< gradients of the hat functions, 1/length
  std::array<R, 3> gamma;        ///< hat functions at eta's projection
  bool in_plane = false;  ///< exactly: then d = 0, its terms are removed, and eta is taken as a limit from inside
  bool inside = false;    ///< strictly inside the triangle
  int vertex = -1;        ///< the corner that eta is exactly at

  Frame(const Triangle<R>& triangle, const Vec3<R>& point) : t(triangle), eta(point) {
    const Vec3<R> N = Vec3<R>(t[1] - t[0]).cross(Vec3<R>(t[2] - t[0]));
    twice_area = N.norm();
    n = N / twice_area;
    in_plane = N.dot(Vec3<R>(eta - t[0])) == 0;
    d = Vec3<R>(eta - t[0]).dot(n);
    for (int i = 0; i < 3; ++i) {
      edges[i] = edge(t[i], t[(i + 1) % 3]);
      in_plane = in_plane || edges[i].on_line;
      if (eta == t[i]) vertex = i;
    }
    if (in_plane) d = R(0);
    inside = in_plane;
    for (int i = 0; i < 3; ++i) {
      const Edge<R>& opposite_edge = opposite(i);
      const R h = opposite_edge.r.dot(Vec3<R>(t[i] - t[(i + 1) % 3]));
      g[i] = opposite_edge.r / h;
      gamma[i] = Vec3<R>(eta - t[(i + 1) % 3]).dot(g[i]);
      inside = inside && !opposite_edge.on_line && opposite_edge.a > 0;
    }
  }

  /// e^i, the edge opposite corner i.
  const Edge<R>& opposite(int corner) const { return edges[(corner + 1) % 3]; }

 private:
  Edge<R> edge(const Vec3<R>& e0, const Vec3<R>& e1) const {
    Edge<R> x;
    x.e = e1 - e0;
    x.length = x.e.norm();
    x.u = x.e / x.length;
    x.r = n.cross(x.u);
    x.arrow = {Vec3<R>(eta - e0), Vec3<R>(eta - e1)};
    for (int i = 0; i < 2; ++i) {
      x.l[i] = x.arrow[i].norm();
      x.zeta[i] = x.arrow[i].dot(x.u);
    }
    x.a = x.r.dot(x.arrow[0]);
    x.D = x.P() * x.arrow[0];
    x.D2 = x.D.squaredNorm();
    x.on_line = x.e.cross(x.arrow[0]).isZero(0);
    x.on_edge = x.on_line && x.zeta[0] >= 0 && x.zeta[1] <= 0;
    if (x.on_line) {  // "in case eta is in (e0 e1), a = D = d = 0"
      x.a = x.D2 = R(0);
      x.D.setZero();
    }
    return x;
  }
};

}  // namespace cageproof::closed_form::published
