// SPDX-License-Identifier: MIT
// The smooth projection of a point to a quad's parameters ([T18] Section 3.4.2, Algorithm 1, Appendix B, with their
// corrections).
#pragma once

#include "quad/mean_value/riemann/linear_solution.h"

#include <limits>
#include <utility>

namespace cageproof::adaptive_qmvc {

/// Whether the point is inside the hull, or on it.
template <Scalar R>
bool inside_hull(const Vec4<R>& kappa) {
  return (kappa.minCoeff() >= 0 && kappa.maxCoeff() > 0) || (kappa.maxCoeff() <= 0 && kappa.minCoeff() < 0);
}

/// Where the first step moves an outer point, relative to it, in units: to the mean of the hull's surface under |(xi -
/// eta).n|/|xi - eta|^4 (Eq 25, where 3 is printed; the sum of the weights divides it, which Algorithm 1 leaves out),
/// so to the absolute triangle weights' (Eq 14) mean of the corners. A face has no weight if the point is in its plane
/// up to rounding.
template <Scalar R>
Vec3<R> to_hull(const PairFrame<R>& s, const Vec4<R>& kappa) {
  using std::abs;
  struct Face {
    std::array<int, 3> corner;
    std::array<Pair, 3> opposite;  ///< the pair across from each corner
    int off;  ///< the corner that is not of this face, whose entry of kappa is the face's determinant
  };
  static constexpr std::array<Face, 4> faces{{{{0, 1, 3}, {k13, k03, k01}, 2},
                                              {{1, 2, 3}, {k23, k13, k12}, 0},
                                              {{0, 1, 2}, {k12, k02, k01}, 3},
                                              {{0, 2, 3}, {k23, k03, k02}, 1}}};
  const std::array<Vec3<R>, 4> m = face_mean_vectors(s);
  Vec4<R> weight = Vec4<R>::Zero();
  for (int f = 0; f < 4; ++f) {
    const R determinant = abs(kappa[faces[f].off]);
    if (!(determinant > 4 * std::numeric_limits<R>::epsilon())) continue;
    for (int c = 0; c < 3; ++c)
      weight[faces[f].corner[c]] += abs(R(m[f].dot(s.cross[faces[f].opposite[c]]))) / determinant;
  }
  const R sum = weight.sum();
  if (!(sum > 0)) return (s.p[0] + s.p[1] + s.p[2] + s.p[3]) / R(4);
  return apply(s, Vec4<R>(weight / sum));
}

/// The roots of a v^2 + b v + c = 0 without cancellation. A negative discriminant counts as rounding of a double root;
/// the second is not finite where a is zero.
template <class R>
std::array<R, 2> quadratic_roots(const R& a, const R& b, const R& c) {
  using std::max, std::sqrt;
  const R root = sqrt(max(R(b * b - 4 * a * c), R(0)));
  const R q = -(b + (b < 0 ? R(-root) : root)) / 2;
  if (q == 0) return {a == 0 ? R(0.5) : R(0), a == 0 ? R(0.5) : R(0)};
  return {c / q, q / a};
}

/// Where the line through the point along `d` meets the quad (Appendix B): u by Eq 29 divided by |b - a|^2, which is
/// not printed. Of two the one nearer the parameters' middle; clamped to [0, 1]^2, which changes nothing for valid
/// quads, and gives others a point of theirs.
template <Scalar R>
std::pair<R, R> meet_line(const PairFrame<R>& s, const Vec3<R>& d) {
  using std::abs, std::max, std::min;
  // ((1-v) p0 + v p3) x ((1-v) p1 + v p2) . d = 0, by powers of v.
  const Vec3<R>&left = s.along[k03], &right = s.along[k12];
  const R c = s.cross[k01].dot(d);
  const R b = (s.p[0].cross(right) + left.cross(s.p[1])).dot(d);
  const R a = left.cross(right).dot(d);
  std::pair<R, R> best{R(0.5), R(0.5)};
  R nearest = std::numeric_limits<R>::infinity();
  for (const R& v : quadratic_roots(a, b, c)) {
    const Vec3<R> start = s.p[0] + v * left;
    const Vec3<R> row = s.along[k01] + v * (right - left);
    const Vec3<R> across = row.cross(d);
    const R u = -start.cross(d).dot(across) / across.squaredNorm();
    const R off = max(R(abs(u - R(0.5))), R(abs(v - R(0.5))));
    if (!(off < nearest)) continue;
    nearest = off;
    best = {u, v};
  }
  return {min(max(best.first, R(0)), R(1)), min(max(best.second, R(0)), R(1))};
}

/// P_q of Algorithm 1: parameters in [0, 1]^2, (u, v) itself for xi(u, v). `kappa` is null_vector(s).
template <Scalar R>
std::pair<R, R> project(const PairFrame<R>& s, const Vec4<R>& kappa) {
  if (inside_hull(kappa)) return meet_line(s, mean_vector(s));
  const PairFrame<R> on_hull = s.moved(to_hull(s, kappa));
  return meet_line(on_hull, mean_vector(on_hull));
}

}  // namespace cageproof::adaptive_qmvc
