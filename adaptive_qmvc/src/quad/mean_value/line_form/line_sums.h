// SPDX-License-Identifier: MIT
// Sums of the weights' terms over the lines of a rule.
#pragma once

#include "quad/engine/line_moments.h"
#include "quad/engine/line_references.h"
#include "quad/mean_value/line_form/line_values.h"
#include "quad/engine/singular_pairs.h"
#include "quad/mean_value/line_form/weight_sums.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc {

/// Adds one line, all of whose entries are multiplied with `weight`.
/// \param step the line's from the rule's frame
template <int Order, class R>
void add_line(const LineReferences<R>& references, const R& step, const R& weight, double digits,
              WeightSums<R, Order>& sums) {
  using std::sqrt;
  const LineReference<R>& reference = references.at(step);
  const LocalFrame<R>& q = reference.q;
  const R s = step + reference.ahead;
  const Vec3<R> a = q.start(s), e = q.direction(s);
  const R &first = q.first, &last = q.last;
  const Vec3<R> start = a + first * e, end = a + last * e;
  using F = std::conditional_t<is_multiprecision<R>, long double, double>;
  const F length2 = static_cast<F>(e.dot(e)), start2 = static_cast<F>(start.dot(start)),
          end2 = static_cast<F>(end.dot(end));
  // The line is far if its ends' distances sum up to `kFarAlongLine` lengths, which their squares often tell already.
  const auto ends = [&] { return static_cast<double>((std::sqrt(start2) + std::sqrt(end2)) / std::sqrt(length2)); };
  LineMoments<R> m;
  Vec3<R> x;  // the line's point at the moments' origin
  if (2 * (start2 + end2) < kFarAlongLine * kFarAlongLine * length2 || ends() < kFarAlongLine) {
    const Vec3<R> c = reference.area.at(s);
    m = moments_about_foot<Order>(a, e, first, last, R(c.dot(c)), digits);
    // Not a + origin e, whose terms cancel where the foot is far along the line.
    if constexpr (Order >= 1) x = e.cross(c) / e.dot(e);
  } else {
    m = moments_by_gauss<Order>(a, e, first, gauss_rule<R>(length2 > 0 ? nodes_along_line(ends(), Order, digits) : 2));
    if constexpr (Order >= 1) x = a + m.origin * e;
  }
  if (sums.watched) add_magnitudes(q, s, weight, m, x, e, sums);
  const R g1 = q.g10 + s * q.g11;
  const R g0 = q.g00 + s * q.g01 + m.origin * g1;
  // f0 and f1: the integrals of the kernel and of s times the kernel.
  std::array<std::array<R, WeightSums<R, Order>::entries>, 2> f;
  for (int c = 0; c < 2; ++c) f[c][0] = g0 * m.p2[c] + g1 * m.p2[c + 1];
  if constexpr (Order >= 1) {
    const Vec3<R>& n1 = q.n_u;
    const Vec3<R> n0 = q.n + s * q.n_v + m.origin * n1;
    for (int c = 0; c < 2; ++c) {
      const R h0 = g0 * m.p3[c] + g1 * m.p3[c + 1], h1 = g0 * m.p3[c + 1] + g1 * m.p3[c + 2];
      for (int i = 0; i < 3; ++i) f[c][1 + i] = 4 * (x[i] * h0 + e[i] * h1) - (n0[i] * m.p2[c] + n1[i] * m.p2[c + 1]);
      if constexpr (Order >= 2) {
        const R k0 = 24 * (g0 * m.p4[c] + g1 * m.p4[c + 1]), k1 = 24 * (g0 * m.p4[c + 1] + g1 * m.p4[c + 2]),
                k2 = 24 * (g0 * m.p4[c + 2] + g1 * m.p4[c + 3]);
        // The symmetric products of x and of e with what follows.
        const Vec3<R> by_x = (k0 / 2) * x + k1 * e - 4 * (m.p3[c] * n0 + m.p3[c + 1] * n1);
        const Vec3<R> by_e = (k2 / 2) * e - 4 * (m.p3[c + 1] * n0 + m.p3[c + 2] * n1);
        for (int i = 0, entry = 4; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++entry) {
            f[c][entry] = x[i] * by_x[j] + x[j] * by_x[i] + e[i] * by_e[j] + e[j] * by_e[i];
            if (i == j) f[c][entry] -= 4 * h0;
          }
      }
    }
  }
  const R right = weight * (q.v0 + s), left = weight - right;
  const R along = q.u0 + m.origin, rest = last - m.origin;
  for (int k = 0; k < WeightSums<R, Order>::entries; ++k) {
    const R far = along * f[0][k] + f[1][k], near = rest * f[0][k] - f[1][k];
    sums.corner[0][k] += left * near;
    sums.corner[1][k] += left * far;
    sums.corner[2][k] += right * far;
    sums.corner[3][k] += right * near;
  }
}

/// Adds a panel's lines for values in double, in packs of four; those of weight zero fill the last one.
inline void add_values(const LineReferences<double>& references, const OuterRule<double>& rule, double centre,
                       double lo, double hi, const GaussLegendre<double>& gauss, double digits, LineValues& values,
                       WeightSums<double, 0>& sums) {
  const int count = static_cast<int>(gauss.nodes.size());
  for (int first = 0; first < count; first += 4) {
    Lines at, weight;
    for (int i = 0; i < 4; ++i) {
      const int k = std::min(first + i, count - 1);
      at[i] = gauss.nodes[k];
      weight[i] = first + i < count ? gauss.weights[k] : 0;
    }
    at = lo + (hi - lo) * at;
    weight *= hi - lo;
    Lines s = at - references.base().v0;
    if (!rule.plain) {
      // sinh and cosh: what their difference cancels is below the roundings of the width.
      const Lines grown = (rule.width / 2) * at.exp(), shrunk = (rule.width / 2) * (-at).exp();
      s = centre + (grown - shrunk);
      weight *= grown + shrunk;
    }
    if (values.add(references.at(s[0]), s, weight)) continue;
    for (int i = 0; i < 4 && first + i < count; ++i) add_line<0, double>(references, s[i], weight[i], digits, sums);
  }
}

/// Adds all lines of a rule. Returns how many.
/// \param references the first one is the point of the lines next to which the rule's are dense
/// \param centre the rule's, as a step from the frame's line
template <int Order, class R>
std::size_t add_lines(const LineReferences<R>& references, const OuterRule<R>& rule, const R& centre,
                      std::span<const Panel> panels, double digits, WeightSums<R, Order>& sums) {
  constexpr bool values_only = Order == 0 && std::same_as<R, double>;
  std::size_t lines = 0;
  [[maybe_unused]] std::conditional_t<values_only, LineValues, std::nullptr_t> values = [&] {
    if constexpr (values_only) return LineValues(digits);
    else return nullptr;
  }();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Panel& panel = panels[p];
    const R lo = p == 0 ? rule.first : R(panel.lo), hi = p + 1 == panels.size() ? rule.last : R(panel.hi);
    const GaussLegendre<R>& gauss = gauss_rule<R>(panel.nodes);
    lines += panel.nodes;
    if constexpr (values_only) {
      // Four lines at a time add no magnitudes.
      if (!sums.watched) {
        add_values(references, rule, centre, lo, hi, gauss, digits, values, sums);
        continue;
      }
    }
    for (int i = 0; i < panel.nodes; ++i) {
      const R at = lo + (hi - lo) * gauss.nodes[i];
      R weight = (hi - lo) * gauss.weights[i];
      if (rule.plain) {
        add_line(references, R(at - references.base().v0), weight, digits, sums);
        continue;
      }
      using std::exp;
      const R grown = rule.width / 2 * exp(at), shrunk = rule.width * rule.width / (4 * grown);
      weight *= grown + shrunk;
      add_line(references, R(centre + (grown - shrunk)), weight, digits, sums);
    }
  }
  if constexpr (values_only) {
    const std::array<double, 4> corners = values.corners();
    for (int k = 0; k < 4; ++k) sums.corner[k][0] += corners[k];
  }
  return lines;
}

}  // namespace cageproof::adaptive_qmvc
