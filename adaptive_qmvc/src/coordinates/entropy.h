// SPDX-License-Identifier: MIT
// maximum_entropy for any scalar; each scalar is compiled in a file of its own.
#pragma once

#include "coordinates/maximum_entropy.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// A vertex with a positive prior.
template <Scalar R>
struct ActiveVertex {
  Vec3<R> offset;  ///< from the point, in sizes
  R log_prior;
  std::size_t index;
};

template <Scalar R>
using ActiveVertices = std::vector<ActiveVertex<R>>;

/// log Z at t, its gradient -sum lambda_i offset_i, and the coordinates.
template <Scalar R>
struct Potential {
  R value;
  Vec3<R> gradient = Vec3<R>::Zero();
  std::vector<R> lambda;

  Potential(const ActiveVertices<R>& vertices, const Vec3<R>& t) {
    using std::exp, std::log, std::max;
    R highest = -std::numeric_limits<R>::infinity();
    for (const ActiveVertex<R>& v : vertices) {
      lambda.push_back(v.log_prior - t.dot(v.offset));
      highest = max(highest, lambda.back());
    }
    R sum = 0;
    for (R& l : lambda) sum += l = exp(R(l - highest));
    value = highest + log(sum);
    for (std::size_t i = 0; i < vertices.size(); ++i) gradient -= (lambda[i] /= sum) * vertices[i].offset;
  }

  /// The covariance of the offsets.
  Mat3<R> hessian(const ActiveVertices<R>& vertices) const {
    Mat3<R> found = Mat3<R>::Zero();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3<R> d = vertices[i].offset + gradient;
      found += lambda[i] * d * d.transpose();
    }
    return found;
  }
};

/// The scalar's unit roundoff over that of double, in which the tolerances below are given.
template <Scalar R>
R finer() {
  return unit_roundoff<R>() / R(0x1p-53);
}

/// The minimum of log Z, or nothing found: lambda is empty.
template <Scalar R>
Potential<R> least_potential(const ActiveVertices<R>& active) {
  constexpr int kSteps = 500;
  R least = active.front().log_prior;
  for (const ActiveVertex<R>& v : active) least = std::min(least, v.log_prior);
  Vec3<R> t = Vec3<R>::Zero();
  Potential<R> at(active, t);
  for (int step = 0; step < kSteps && at.gradient.norm() > 4 * unit_roundoff<R>(); ++step) {
    // Within the hull some vertex lies against t, so that Z is at least its prior: below the least prior there is no
    // solution.
    if (at.value < least - 1e-6) {
      at.lambda.clear();
      return at;
    }
    // A trace of its size keeps the covariance definite where the vertices in play span no volume.
    Mat3<R> hessian = at.hessian(active);
    hessian += R(R(1e-16) * finer<R>() * hessian.trace() + R(std::numeric_limits<double>::min())) * Mat3<R>::Identity();
    const Vec3<R> p = -hessian.ldlt().solve(at.gradient);
    bool better = false;
    for (double length = 1; length > 1e-12 && !better; length /= 2) {
      const Potential<R> next(active, t + R(length) * p);
      better = next.value <= at.value + R(1e-4) * length * at.gradient.dot(p) && next.value < at.value;
      better = better || next.gradient.norm() < R(0.9) * at.gradient.norm();
      if (!better) continue;
      t += R(length) * p;
      at = next;
    }
    if (!better) break;
  }
  if (!(at.gradient.norm() <= R(1e-13) * finer<R>())) at.lambda.clear();
  return at;
}

/// The derivatives of the coordinates, by differentiating sum lambda_i = 1 and sum lambda_i (v_i - x) = 0 once and
/// twice.
///
/// With lambda_i = r_i m_i, r_i = exp(-t.d_i)/Z, d_i = v_i - x and C = sum lambda_i d_i d_i': C dt/dx_a = sum r_i m_i,a
/// d_i - e_a, and lambda_i,a = r_i (m_i,a - m_i s_ia), s_ia = sum_j r_j m_j,a + d_i.dt/dx_a. In the same way second
/// derivatives are those of the prior in place of the first, r_i (m_i,ab - m_i,a s_ib - s_ia m_i,b + m_i s_ia s_ib),
/// less lambda_i times what restores both conditions. Nothing is divided by m_i.
template <Scalar R>
void differentiate(const ActiveVertices<R>& active, const Potential<R>& at, const Result<R>& prior, double size,
                   int order, Result<R>& result) {
  const std::size_t n = active.size();
  const Eigen::LDLT<Mat3<R>> covariance(at.hessian(active));
  std::vector<R> ratio(n);
  for (std::size_t i = 0; i < n; ++i) ratio[i] = at.lambda[i] / prior.value[active[i].index];
  // The correction of a direction: lambda_i (shift + d_i.turn) is subtracted, so that the sums over the coordinates,
  // and over them times d_i, are right.
  struct Correction {
    R shift = R(0);
    Vec3<R> turn = Vec3<R>::Zero();
    R at(const Vec3<R>& d) const { return shift + d.dot(turn); }
  };
  const auto correction = [&](const auto& rate, const Vec3<R>& wanted) {
    Correction c;
    for (std::size_t i = 0; i < n; ++i) {
      const R x = rate(i);
      c.shift += x;
      c.turn += x * active[i].offset;
    }
    c.turn = covariance.solve(Vec3<R>(c.turn - wanted));
    return c;
  };
  std::array<Correction, 3> first;
  for (int a = 0; a < 3; ++a) {
    const auto rate = [&](std::size_t i) { return R(ratio[i] * prior.gradient[3 * active[i].index + a]); };
    first[a] = correction(rate, Vec3<R>::Unit(a) / R(size));
    for (std::size_t i = 0; i < n; ++i)
      result.gradient[3 * active[i].index + a] = rate(i) - at.lambda[i] * first[a].at(active[i].offset);
  }
  if (order < 2) return;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const auto rate = [&](std::size_t i) {
        const std::size_t v = active[i].index;
        const R sa = first[a].at(active[i].offset), sb = first[b].at(active[i].offset);
        return R(ratio[i] * (prior.hessian[9 * v + 3 * a + b] - prior.gradient[3 * v + a] * sb -
                             sa * prior.gradient[3 * v + b]) +
                 at.lambda[i] * sa * sb);
      };
      const Correction second = correction(rate, Vec3<R>::Zero());
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t v = active[i].index;
        result.hessian[9 * v + 3 * a + b] = result.hessian[9 * v + 3 * b + a] =
            rate(i) - at.lambda[i] * second.at(active[i].offset);
      }
    }
}

template <Scalar R>
void maximum_entropy(std::span<const Vec3<double>> vertices, const Result<R>& prior, const Vec3<R>& point, double size,
                     int order, Result<R>& result) {
  using std::isfinite, std::log;
  const int count = static_cast<int>(vertices.size());
  const auto without = [&](int from) {
    for (int o = from; o <= order; ++o) std::ranges::fill(result.of(o), std::numeric_limits<R>::quiet_NaN());
  };
  result.reset(count, 3, order);
  ActiveVertices<R> active;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!isfinite(prior.value[i])) return without(0);
    if (prior.value[i] > 0) active.push_back({(convert<R>(vertices[i]) - point) / R(size), log(prior.value[i]), i});
  }
  if (active.empty()) return without(0);
  const Potential<R> at = least_potential(active);
  if (at.lambda.empty()) return without(0);
  for (std::size_t i = 0; i < active.size(); ++i) result.value[active[i].index] = at.lambda[i];
  const auto known = [](const std::vector<R>& tensors) {
    return std::ranges::all_of(tensors, [](const R& x) { return isfinite(x); });
  };
  for (int o = 1; o <= order; ++o)
    if (!known(prior.of(o))) return without(1);
  if (order >= 1) differentiate(active, at, prior, size, order, result);
}

}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_MAXIMUM_ENTROPY(R)                                                                                 \
  template void cageproof::adaptive_qmvc::maximum_entropy<R>(std::span<const cageproof::Vec3<double>>,               \
                                                             const cageproof::Result<R>&, const cageproof::Vec3<R>&, \
                                                             double, int, cageproof::Result<R>&);
