// SPDX-License-Identifier: MIT
// Helpers that the room's tests share: quads, points, and the definition as a plain sum in two dimensions.
#pragma once

#include "quad/mean_value/riemann/riemann.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/random_stream.h"

#include <algorithm>
#include <stdexcept>

namespace cageproof::adaptive_qmvc {

/// The unit square with corner 2 lifted by `twist`.
inline Quad<double> lifted_square(double twist) {
  return {Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, twist), Vec3<double>(0, 1, 0)};
}

template <Scalar To>
Quad<To> convert_quad(const Quad<double>& q) {
  return {convert<To>(q[0]), convert<To>(q[1]), convert<To>(q[2]), convert<To>(q[3])};
}

inline Vec3<double> random_point(RandomStream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// A valid quad about the origin, of size 1.
inline Quad<double> random_valid_quad(RandomStream& random) {
  for (;;) {
    Quad<double> q{Vec3<double>(-.5, -.5, 0), Vec3<double>(.5, -.5, 0), Vec3<double>(.5, .5, 0),
                   Vec3<double>(-.5, .5, 0)};
    for (auto& corner : q) corner += random_point(random, .25);
    if (!invalid_because(q)) return q;
  }
}

inline Vec4<double> basis_at(double u, double v) { return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}; }

template <Scalar R>
Vec3<R> combined(const Quad<R>& q, const Vec4<R>& w) {
  return w[0] * q[0] + w[1] * q[1] + w[2] * q[2] + w[3] * q[3];
}

inline Vec3<double> normal_at(const Quad<double>& q, double u, double v) {
  const Vec3<double> along_u = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]),
                     along_v = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
  return along_u.cross(along_v);
}

/// int Phi_k N.x/r^4 du dv by 24 x 24 Gauss points on cells that shrink towards the parameters (u0, v0).
inline Vec4<double> integrated_weights(const Quad<double>& q, const Vec3<double>& eta, double u0, double v0) {
  const auto& rule = gauss_legendre<double>(24);
  const auto cuts = [](double centre) {
    std::vector<double> all{0, 1, centre};
    for (int k = 1; k < 11; ++k)
      for (const double side : {-1., 1.})
        if (const double x = centre + side * std::pow(.4, k); x > 0 && x < 1) all.push_back(x);
    std::ranges::sort(all);
    return all;
  };
  const auto us = cuts(u0), vs = cuts(v0);
  Vec4<double> w = Vec4<double>::Zero();
  for (std::size_t a = 0; a + 1 < us.size(); ++a)
    for (std::size_t b = 0; b + 1 < vs.size(); ++b)
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
          const double du = us[a + 1] - us[a], dv = vs[b + 1] - vs[b];
          const double u = us[a] + du * rule.nodes[i], v = vs[b] + dv * rule.nodes[j];
          const Vec4<double> basis = basis_at(u, v);
          const Vec3<double> x = combined(q, basis) - eta;
          const double square = x.squaredNorm();
          w += basis * (du * dv * rule.weights[i] * rule.weights[j] * normal_at(q, u, v).dot(x) / (square * square));
        }
  return w;
}

/// Largest difference over the largest entry.
template <Scalar R>
double relative_difference(const Vec4<R>& a, const Vec4<R>& b) {
  return static_cast<double>(R((a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff()));
}

/// The weights by the named evaluation of quad.mean_value.
template <Scalar R>
Vec4<R> evaluated(const std::string& name, const Quad<R>& q, const Vec3<R>& eta) {
  const auto evaluation = EvaluationRegister::instance().find("quad.mean_value", name);
  if (!evaluation) throw std::runtime_error("no evaluation " + name);
  Result<R> result;
  (*evaluation)(Query<R>{q, eta}, result);
  return {result.value[0], result.value[1], result.value[2], result.value[3]};
}

/// |A w - m| over |m| + sum |w_i| |p_i|.
template <Scalar R>
double linear_residual(const Quad<R>& q, const Vec3<R>& eta, const Vec4<R>& w) {
  const PairFrame<R> s(q, eta);
  const Vec3<R> m = mean_vector(s);
  R size = m.norm();
  for (int i = 0; i < 4; ++i) {
    const R term = w[i] * s.unit * s.p[i].norm();
    size += term < 0 ? R(-term) : term;
  }
  return static_cast<double>(R((apply(s, Vec4<R>(w * s.unit)) - m).norm() / size));
}

}  // namespace cageproof::adaptive_qmvc
