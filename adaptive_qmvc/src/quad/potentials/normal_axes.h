// SPDX-License-Identifier: MIT
// Coordinates whose third axis is the quad's normal at the point that lines are taken about.
#pragma once

#include "quad/engine/local_frame.h"
#include "quad/engine/quad_frame.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc {

/// Where the normal at a rule's point is shorter than that, in lengths of the longest at a corner, what is divided by
/// it loses more than derivatives along the quad do.
inline constexpr double kShortNormal = 1e-2;

/// Whether the normal at the frame's point is long enough to divide by.
template <class R>
bool has_normal_at(const LocalFrame<R>& q) {
  R longest = R(0);
  for (const R& t : {q.first, q.last})
    for (const R& s : {R(-q.v0), R(1 - q.v0)}) {
      const Vec3<R> n = q.n + t * q.n_u + s * q.n_v;
      longest = std::max(longest, R(n.dot(n)));
    }
  return q.n.dot(q.n) > R(kShortNormal * kShortNormal) * longest;
}

/// Where the quad is that many times as long as wide at a rule's point, lengths across it that are turned to other axes
/// in a scalar's own digits lose as many roundings; more than sums do.
inline constexpr double kThin = 16;

/// Whether the quad is that thin at the frame's point.
template <class R>
bool is_thin_at(const LocalFrame<R>& q) {
  R longest = R(0);
  for (const R& t : {q.first, q.last}) {
    const Vec3<R> side = q.b + t * q.w;
    longest = std::max(longest, R(side.dot(side)));
  }
  for (const R& s : {R(-q.v0), q.above}) {
    const Vec3<R> side = q.e + s * q.w;
    longest = std::max(longest, R(side.dot(side)));
  }
  return R(kThin * kThin) * q.n.dot(q.n) < longest * q.e.dot(q.e);
}

/// Axes whose third is the normal at the point that a rule's lines are taken about; the frame's own for plain tapes.
template <class R>
struct NormalAxes {
  Eigen::Matrix<R, 3, 3> axes = Eigen::Matrix<R, 3, 3>::Identity();  ///< rows, in the frame's coordinates
  R length = R(1);                                                   ///< of the normal

  NormalAxes() = default;
  /// The same in another scalar, every number rounded once.
  template <class From>
  explicit NormalAxes(const NormalAxes<From>& q) : axes(q.axes.template cast<R>()), length(q.length) {}
  NormalAxes(const Vec3<R>& normal, const Vec3<R>& along) {
    using std::sqrt;
    length = sqrt(R(normal.dot(normal)));
    const Vec3<R> z = normal / length;
    Vec3<R> x = along - z.dot(along) * z;
    x /= sqrt(R(x.dot(x)));
    axes.row(0) = x;
    axes.row(1) = z.cross(x);
    axes.row(2) = z;
  }
  Vec3<R> of(const Vec3<R>& v) const { return axes * v; }
};

/// A frame's vectors in coordinates along the axes; what is a number stays.
template <class R>
LocalFrame<R> turned(LocalFrame<R> q, const NormalAxes<R>& to) {
  for (Vec3<R>* v : {&q.a, &q.e, &q.b, &q.w, &q.n, &q.n_u, &q.n_v}) *v = to.of(*v);
  return q;
}

/// The same of a quad's frame.
template <class R>
QuadFrame<R> turned(QuadFrame<R> q, const NormalAxes<R>& to) {
  for (Vec3<R>* v : {&q.a, &q.e, &q.e1, &q.b, &q.b1, &q.w, &q.n, &q.n_u, &q.n_v}) *v = to.of(*v);
  for (int k = 0; k < 4; ++k) {
    q.seen[k] = to.of(q.seen[k]);
    q.normal[k] = to.of(q.normal[k]);
  }
  return q;
}

}  // namespace cageproof::adaptive_qmvc
