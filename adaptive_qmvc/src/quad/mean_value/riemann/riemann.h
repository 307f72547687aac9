// SPDX-License-Identifier: MIT
// The quad mean value weights of the paper: exact except for their part along the null vector of Eq 17, which a Riemann
// sum estimates.
#pragma once

#include "quad/mean_value/riemann/omega.h"
#include "quad/mean_value/riemann/quad_contact.h"
#include "quad/mean_value/riemann/projection.h"
#include "quad/mean_value/riemann/reflections.h"

#include <algorithm>
#include <array>

namespace cageproof::adaptive_qmvc {

/// 0 up to `low`, 1 from `high` on, between them 6 t^5 - 15 t^4 + 10 t^3: two continuous derivatives.
template <class R>
R blend(const R& x, const R& low, const R& high) {
  using std::max, std::min;
  const R t = min(max(R((x - low) / (high - low)), R(0)), R(1));
  return t * t * t * (t * (t * 6 - 15) + 10);
}

/// The treatment of the norm correction.
enum class NormCorrection {
  Guarded,    ///< blended into 1 around its poles
  AsPrinted,  ///< Eq 24 as it is, with its poles
  None        ///< 1: Eq 21 of the sum in the exact weights' place ([T18] Figure 7)
};

/// The norm correction ||wbar||^2/(Omega.wbar) of Eq 24 has poles where Omega.wbar = 0, around the points where m_q =
/// 0. It is blended into 1, no correction, over these ranges.
struct PoleGuard {
  /// The range of |m_q| over the mean of |m_013| + |m_123| and |m_012| + |m_023|, in [0, 1]: how much of the quad
  /// cancels in its mean vector. Near a zero of m_q wbar vanishes, and the sum's own error decides what the correction
  /// is.
  double mean_low = 0.05, mean_high = 0.2;
  /// The range of the cosine between wbar and the part of Omega across the null vector, 1 for an exact Omega.
  double cosine_low = 0.4, cosine_high = 0.8;
  NormCorrection correction = NormCorrection::Guarded;  ///< the ranges are those of Guarded
};

/// |m_q| over the mean vectors of the quad's two triangulations, in [0, 1].
template <Scalar R>
R mean_vector_ratio(const PairFrame<R>& s, const Vec3<R>& m) {
  const auto t = face_mean_vectors(s);
  const R parts = (t[0].norm() + t[1].norm() + t[2].norm() + t[3].norm()) / 2;
  return parts > 0 ? R(m.norm() / parts) : R(0);
}

/// lambda of Eq 24, in its factors.
template <Scalar R>
struct Lambda {
  R uncorrected;  ///< Omega.kappa/||kappa||^2: Eq 21 of Omega
  R correction;   ///< ||wbar||^2/(Omega.wbar)
  R trust;        ///< 0 where the guard leaves the correction out, 1 where all of it is taken

  R value() const { return trust == 0 ? uncorrected : R(uncorrected * (1 + trust * (correction - 1))); }
};

template <Scalar R>
Lambda<R> lambda(const Vec4<R>& omega, const Vec4<R>& kappa, const Vec4<R>& minimal_norm, const R& mean_ratio,
                 const PoleGuard& guard = {}) {
  using std::sqrt;
  const R uncorrected = omega.dot(kappa) / kappa.squaredNorm();
  const R along = omega.dot(minimal_norm), norm = minimal_norm.squaredNorm();
  Lambda<R> parts{uncorrected, norm / along, R(guard.correction == NormCorrection::AsPrinted ? 1 : 0)};
  if (guard.correction != NormCorrection::Guarded) return parts;
  const R size = sqrt(norm) * (omega - uncorrected * kappa).norm();
  if (!(along > 0) || !(size > 0)) return parts;
  parts.trust = blend<R>(mean_ratio, R(guard.mean_low), R(guard.mean_high)) *
                blend<R>(along / size, R(guard.cosine_low), R(guard.cosine_high));
  return parts;
}

/// Removes what rounding leaves of A w - m, so that linear functions are reproduced also where A is nearly singular:
/// once by Eq 28, and where that is not enough by a QR decomposition.
template <Scalar R>
void restore_linear_reproduction(const PairFrame<R>& s, const Vec4<R>& kappa, const Vec3<R>& m, Vec4<R>& w) {
  const R eps = std::numeric_limits<R>::epsilon();
  const auto residual = [&] { return Vec3<R>(m - apply(s, w)); };
  const auto small = [&](const Vec3<R>& r) { return r.norm() <= 4 * eps * (m.norm() + w.norm()); };
  Vec3<R> r = residual();
  if (small(r)) return;
  w += minimal_norm_solution(s, kappa, r);
  r = residual();
  if (small(r)) return;
  const std::array<R, 4> found = solution_by_reflections(s.p, r);
  const Vec4<R> correction(found.data());
  if (correction.allFinite()) w += correction;
}

/// The scheme's results at a point, in the frame's unit.
template <Scalar R>
struct SchemeParts {
  Vec3<R> mean;
  Vec4<R> kappa, minimal_norm, omega;
  Lambda<R> lambda;
  Vec4<R> weights;
};

/// From the Riemann sum Omega.
template <Scalar R>
SchemeParts<R> parts_from(const PairFrame<R>& s, const Vec4<R>& kappa, const Vec4<R>& sum, const PoleGuard& guard) {
  const Vec3<R> m = mean_vector(s);
  const Vec4<R> minimal_norm = minimal_norm_solution(s, kappa, m);
  const Lambda<R> along = lambda(sum, kappa, minimal_norm, mean_vector_ratio(s, m), guard);
  Vec4<R> w = minimal_norm + along.value() * kappa;
  restore_linear_reproduction(s, kappa, m, w);
  return {m, kappa, minimal_norm, sum, along, w};
}

/// The four weights, in 1/length.
template <Scalar R>
Vec4<R> weights_from(const PairFrame<R>& s, const Vec4<R>& kappa, const Vec4<R>& sum, const PoleGuard& guard) {
  return parts_from<R>(s, kappa, sum, guard).weights / s.unit;
}

/// The four weights, in 1/length, of a point off the quad and, for a planar one, off its plane.
template <Scalar R>
Vec4<R> riemann_weights(const PairFrame<R>& s, const Vec4<R>& kappa, int n, RiemannWorkspace<R>& work,
                        const PoleGuard& guard = {}) {
  const auto [u, v] = project(s, kappa);
  return weights_from<R>(s, kappa, omega(s, n, u, v, work), guard);
}

/// The frame in 50 digits.
template <Scalar R>
PairFrame<Mp50> wide_frame(const Quad<R>& q, const Vec3<R>& point) {
  Quad<Mp50> quad;
  for (int i = 0; i < 4; ++i) quad[i] = convert<Mp50>(q[i]);
  return {quad, convert<Mp50>(point)};
}

/// A sum in the unit of the wide frame.
template <Scalar R>
Vec4<Mp50> wide_sum(const Vec4<R>& sum, const PairFrame<R>& s, const PairFrame<Mp50>& wide) {
  return sum.template cast<Mp50>() * Mp50(wide.unit / Mp50(s.unit));
}

/// The same from far away, where the linear system loses the square of the distance over the size: it is solved in 50
/// digits, and only the sum is in R.
template <Scalar R>
Vec4<R> riemann_weights_from_afar(const Quad<R>& q, const Vec3<R>& point, const PairFrame<R>& s, const Vec4<R>& kappa,
                                  int n, RiemannWorkspace<R>& work, const PoleGuard& guard) {
  const auto [u, v] = project(s, kappa);
  const PairFrame<Mp50> wide = wide_frame(q, point);
  const Vec4<Mp50> sum = wide_sum<R>(omega(s, n, u, v, work), s, wide);
  const Vec4<Mp50> w = weights_from<Mp50>(wide, null_vector(wide), sum, guard);
  Vec4<R> rounded;
  for (int i = 0; i < 4; ++i) rounded[i] = static_cast<R>(w[i]);
  return rounded;
}

/// Whether the quad is so small, seen from the point, that the linear system costs half of a double's digits.
template <Scalar R>
bool is_far(const PairFrame<R>& s) {
  constexpr double enough = 0x1p-12;
  return std::ranges::all_of(s.along, [](const Vec3<R>& side) { return side.squaredNorm() < R(enough * enough); });
}

/// The four weights of any point: infinite on the quad where the basis function is positive, and zero for the other
/// corners; zero in the plane of a planar quad outside it; NaN for an input that is not finite.
template <Scalar R>
Vec4<R> quad_weights(const Quad<R>& q, const Vec3<R>& point, int n, RiemannWorkspace<R>& work,
                     const PoleGuard& guard = {}) {
  const PairFrame<R> s(q, point);
  const Vec4<R> kappa = null_vector(s);
  const QuadContact contact = quad_contact(q, point, kappa);
  Vec4<R> w = Vec4<R>::Zero();
  if (contact.on) {
    for (int i = 0; i < 4; ++i)
      if (contact.on->basis[i] > 0) w[i] = std::numeric_limits<R>::infinity();
  } else if (!contact.in_plane) {
    if constexpr (std::same_as<R, double>)
      if (is_far(s)) return riemann_weights_from_afar(q, point, s, kappa, n, work, guard);
    w = riemann_weights(s, kappa, n, work, guard);
  }
  return w;
}

}  // namespace cageproof::adaptive_qmvc
