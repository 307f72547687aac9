// SPDX-License-Identifier: MIT
// Values in double by Gauss-Legendre along lines as well, four lines at a time: cheaper than their arc tangents unless
// one of them is close.
#pragma once

#include "quad/engine/line_moments.h"
#include "quad/engine/line_references.h"

#include <algorithm>
#include <array>

namespace cageproof::adaptive_qmvc {

/// From ends that sum up to that many lengths on, the nodes along a line cost less than its arc tangent.
inline constexpr double kWorthNodes = 1.06;

/// One number for each of four lines.
using Lines = Eigen::Array<double, 4, 1>;

/// The same in registers: expressions over Lines hold addresses, which Clang 16 carries from place to place and follows
/// each time, four times as slow.
using FourInRegisters = double __attribute__((vector_size(4 * sizeof(double))));

/// A vector for each of four lines.
struct FourVectors {
  FourInRegisters x, y, z;

  /// p + s q, s one for each line.
  FourVectors(const Vec3<double>& p, const FourInRegisters& s, const Vec3<double>& q)
      : x(p[0] + s * q[0]), y(p[1] + s * q[1]), z(p[2] + s * q[2]) {}
  FourVectors(const Vec3<double>& p, const FourInRegisters& s, const FourVectors& q)
      : x(p[0] + s * q.x), y(p[1] + s * q.y), z(p[2] + s * q.z) {}
  FourVectors(const FourVectors& p, double s, const FourVectors& q)
      : x(p.x + s * q.x), y(p.y + s * q.y), z(p.z + s * q.z) {}
};

/// Sums of the four corners' weights over lines.
class LineValues {
 public:
  explicit LineValues(double digits) : digits_(digits) {}

  /// Adds four lines. False, and nothing added, where one of them is too close.
  /// \param steps the lines' from the rule's frame
  bool add(const LineReference<double>& reference, const Lines& steps, const Lines& weight) {
    const LocalFrame<double>& q = reference.q;
    const LineArea<double>& area = reference.area;
    const Lines s = steps + reference.ahead;
    const FourInRegisters at{s[0], s[1], s[2], s[3]};
    const FourVectors a(q.a, at, q.b), e(q.e, at, q.w), start(a, q.first, e), end(a, q.last, e);
    const FourInRegisters length2 = e.x * e.x + e.y * e.y + e.z * e.z;
    const FourInRegisters start2 = start.x * start.x + start.y * start.y + start.z * start.z;
    const FourInRegisters end2 = end.x * end.x + end.y * end.y + end.z * end.z;
    double ratio2 = 1e12;
    for (int i = 0; i < 4; ++i) {
      const double ends = std::sqrt(start2[i]) + std::sqrt(end2[i]);
      const double own = ends * ends / length2[i];
      // A length of zero gives infinity, or, with its ends at the point, no number.
      if (!(own > kWorthNodes * kWorthNodes && own < 1e12)) return false;
      ratio2 = std::min(ratio2, own);
    }
    // r^2 = least2 + length2 (t - foot)^2, whose terms do not cancel; N.x = g0 + t g1.
    const FourVectors c(area.c0, at, FourVectors(area.c1, at, area.c2));
    const FourInRegisters inverse = 1 / length2;
    const FourInRegisters foot = -(a.x * e.x + a.y * e.y + a.z * e.z) * inverse,
                          least2 = (c.x * c.x + c.y * c.y + c.z * c.z) * inverse;
    const FourInRegisters g0 = q.g00 + at * q.g01, g1 = q.g10 + at * q.g11;
    const GaussLegendre<double>& rule = gauss_rule<double>(nodes_along_line(std::sqrt(ratio2), 0, digits_));
    FourInRegisters sum{}, moment{};
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double u = rule.nodes[k];
      const double t = u + q.first;
      const FourInRegisters step = t - foot;
      const FourInRegisters square = least2 + length2 * step * step;
      const FourInRegisters f = rule.weights[k] * (g0 + t * g1) / (square * square);
      sum += f;
      moment += u * f;
    }
    const Lines zeroth(sum[0], sum[1], sum[2], sum[3]), first(moment[0], moment[1], moment[2], moment[3]);
    const Lines all = weight * zeroth, far = weight * first, v = q.v0 + s;
    left_ += (1 - v) * (all - far);
    left_far_ += (1 - v) * far;
    right_far_ += v * far;
    right_ += v * (all - far);
    return true;
  }

  /// The sums so far, by corner.
  std::array<double, 4> corners() const { return {left_.sum(), left_far_.sum(), right_far_.sum(), right_.sum()}; }

 private:
  double digits_;
  Lines left_ = Lines::Zero(), left_far_ = Lines::Zero(), right_far_ = Lines::Zero(), right_ = Lines::Zero();
};

}  // namespace cageproof::adaptive_qmvc
