// SPDX-License-Identifier: MIT
// Values in double by Gauss-Legendre along lines as well, four lines at a time: cheaper than their arc tangents unless
// one of them is close.
#pragma once

#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/line_moments.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/singular_pairs.h"
#include "cageproof/adaptive_qmvc/quad/mean_value/line_form/local_frame.h"

#include <algorithm>
#include <array>

namespace cageproof::adaptive_qmvc {

/// From ends that sum up to that many lengths on, the nodes along a line cost less than its arc tangent.
inline constexpr double kWorthNodes = 1.06;

/// One number for each of four lines.
using Lines = Eigen::Array<double, 4, 1>;

/// A vector for each of four lines.
struct LinesVector {
  Lines x, y, z;

  /// p + s q, s one for each line.
  static LinesVector along(const Vec3<double>& p, const Lines& s, const Vec3<double>& q) {
    return {p[0] + s * q[0], p[1] + s * q[1], p[2] + s * q[2]};
  }
  static LinesVector along(const Vec3<double>& p, const Lines& s, const LinesVector& q) {
    return {p[0] + s * q.x, p[1] + s * q.y, p[2] + s * q.z};
  }
  LinesVector operator+(const LinesVector& o) const { return {x + o.x, y + o.y, z + o.z}; }
  friend LinesVector operator*(double f, const LinesVector& v) { return {f * v.x, f * v.y, f * v.z}; }
  Lines dot(const LinesVector& o) const { return x * o.x + y * o.y + z * o.z; }
};

/// Sums of the four corners' weights over lines.
class LineValues {
 public:
  LineValues(const LocalFrame<double>& q, const LineArea<double>& area, double digits)
      : q_(q), area_(area), digits_(digits) {}

  /// Adds four lines. False, and nothing added, where one of them is too close.
  /// \param s the lines' steps from the frame's
  bool add(const Lines& s, const Lines& weight) {
    const LinesVector a = LinesVector::along(q_.a, s, q_.b), e = LinesVector::along(q_.e, s, q_.w);
    const LinesVector start = a + q_.first() * e, end = a + q_.last() * e;
    const Lines length2 = e.dot(e);
    const Lines ends = start.dot(start).sqrt() + end.dot(end).sqrt();
    const Lines ratios2 = ends.square() / length2;
    const double ratio2 = ratios2.minCoeff();
    // A length of zero gives infinity, or, with its ends at the point, no number.
    if (!(ratios2 > kWorthNodes * kWorthNodes && ratios2 < 1e12).all()) return false;
    // r^2 = least2 + length2 (t - foot)^2, whose terms do not cancel; N.x = g0 + t g1.
    const LinesVector c = LinesVector::along(area_.c0, s, LinesVector::along(area_.c1, s, area_.c2));
    const Lines inverse = 1 / length2;
    const Lines foot = -a.dot(e) * inverse, least2 = c.dot(c) * inverse;
    const Lines g0 = q_.g00 + s * q_.g01, g1 = q_.g10 + s * q_.g11;
    const GaussLegendre<double>& rule = gauss_rule<double>(nodes_along_line(std::sqrt(ratio2), 0, digits_));
    Lines zeroth = Lines::Zero(), first = Lines::Zero();
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double u = rule.nodes[k];
      const double t = u + q_.first();
      const Lines step = t - foot;
      const Lines square = least2 + length2 * step * step;
      const Lines f = rule.weights[k] * (g0 + t * g1) / (square * square);
      zeroth += f;
      first += u * f;
    }
    const Lines all = weight * zeroth, far = weight * first, v = q_.v0 + s;
    left_ += (1 - v) * (all - far);
    left_far_ += (1 - v) * far;
    right_far_ += v * far;
    right_ += v * (all - far);
    return true;
  }

  /// The sums so far, by corner.
  std::array<double, 4> corners() const { return {left_.sum(), left_far_.sum(), right_far_.sum(), right_.sum()}; }

 private:
  const LocalFrame<double>& q_;
  const LineArea<double>& area_;
  double digits_;
  Lines left_ = Lines::Zero(), left_far_ = Lines::Zero(), right_far_ = Lines::Zero(), right_ = Lines::Zero();
};

}  // namespace cageproof::adaptive_qmvc
