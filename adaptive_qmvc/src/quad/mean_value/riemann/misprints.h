// SPDX-License-Identifier: MIT
// What [T18] prints where it errs: beside each corrected form, the one as printed. Tests and errata measure them;
// nothing else uses them.
#pragma once

#include "quad/mean_value/riemann/riemann.h"

namespace cageproof::adaptive_qmvc::as_printed {

/// Algorithm 1, lines 5-9: the sum over the hull's faces of |w_c| t_c, from the origin, not divided by the sum of the
/// |w_c|.
/// \param eta the point
template <Scalar R>
Vec3<R> to_hull(const PairFrame<R>& s, const Quad<R>& q) {
  using std::abs;
  static constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 3}, {1, 2, 3}, {0, 1, 2}, {0, 2, 3}}};
  const std::array<Vec3<R>, 4> m = face_mean_vectors(s);
  Vec3<R> sum = Vec3<R>::Zero();
  for (int f = 0; f < 4; ++f)
    for (int c = 0; c < 3; ++c) {
      const int here = faces[f][c];
      const Vec3<R> n = s.p[faces[f][(c + 1) % 3]].cross(s.p[faces[f][(c + 2) % 3]]);
      sum += abs(R(m[f].dot(n) / s.p[here].dot(n))) * q[here];
    }
  return sum / s.unit;
}

/// Eq 25 with the exponent printed, 3: the mean of one triangle's surface under |(xi - eta).n|/|xi - eta|^exponent, by
/// the tensor rule given on [0, 1]. Returns the three corners' weights, not normalised.
template <Scalar R, class Rule>
Vec3<R> face_weights(const std::array<Vec3<R>, 3>& t, const Vec3<R>& eta, int exponent, const Rule& rule) {
  using std::abs, std::pow;
  const Vec3<R> n = (t[1] - t[0]).cross(t[2] - t[0]);
  Vec3<R> w = Vec3<R>::Zero();
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const R a = rule.nodes[i], b = rule.nodes[i] * rule.nodes[j];
      const Vec3<R> hat(1 - a, a - b, b);
      const Vec3<R> x = hat[0] * t[0] + hat[1] * t[1] + hat[2] * t[2] - eta;
      w += hat * (rule.weights[i] * rule.weights[j] * rule.nodes[i] * abs(R(x.dot(n))) / pow(x.norm(), R(exponent)));
    }
  return w;
}

/// Eq 28 with D = +|kappa|^2.
template <Scalar R>
Vec4<R> minimal_norm_solution(const PairFrame<R>& s, const Vec4<R>& kappa, const Vec3<R>& m) {
  return -adaptive_qmvc::minimal_norm_solution(s, kappa, m);
}

/// Eq 29: (eta' - a).(b - a), where it is to be divided by |b - a|^2.
/// \param v the row
/// \param meeting eta' relative to the point
template <Scalar R>
R row_parameter(const PairFrame<R>& s, const R& v, const Vec3<R>& meeting) {
  const Vec3<R> a = s.p[0] + v * s.along[k03], b = s.p[1] + v * s.along[k12];
  return (meeting - a).dot(b - a) * s.unit * s.unit;
}

/// Section 3.3's membership test for quads that are not planar, which Algorithm 2 asks planar quads too: parameters
/// from kappa/sum kappa.
template <Scalar R>
std::pair<R, R> parameters_of_kernel(const Vec4<R>& kappa) {
  return {(kappa[1] + kappa[2]) / kappa.sum(), (kappa[2] + kappa[3]) / kappa.sum()};
}

}  // namespace cageproof::adaptive_qmvc::as_printed
