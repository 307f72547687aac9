// SPDX-License-Identifier: MIT
#include "cageproof/adaptive_qmvc/quad/mean_value/continuity.h"

#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/core/numbers/random_stream.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec4d = Eigen::Matrix<double, 4, 1>;

struct Limits {
  Vec4d value, slope;
};

// The parabola through the values at 1, 2 and 3 steps, at 0.
Limits limits(const WeightsAt& weights, const Vec3<double>& point, const Vec3<double>& step) {
  std::array<Vec4d, 3> f;
  for (int k = 0; k < 3; ++k) f[k] = Vec4d(weights(point + (k + 1) * step).data());
  return {3 * f[0] - 3 * f[1] + f[2], -2.5 * f[0] + 4 * f[1] - 1.5 * f[2]};
}

double relative(const Vec4d& a, const Vec4d& b) {
  const double size = std::max(a.norm(), b.norm());
  return size > 0 ? (a - b).norm() / size : 0;
}

struct Spread {
  Jump worst, median;
};

Spread spread(const std::vector<Jump>& jumps) {
  std::vector<double> value, derivative;
  for (const Jump& j : jumps) {
    value.push_back(j.value);
    derivative.push_back(j.derivative);
  }
  std::ranges::sort(value);
  std::ranges::sort(derivative);
  return {{value.back(), derivative.back()}, {value[value.size() / 2], derivative[derivative.size() / 2]}};
}

}  // namespace

Jump jump_across(const WeightsAt& weights, const Vec3<double>& point, const Vec3<double>& normal, double step) {
  const Limits above = limits(weights, point, step * normal), below = limits(weights, point, -step * normal);
  return {relative(above.value, below.value), relative(above.slope, Vec4d(-below.slope))};
}

ContinuityStudy study_continuity(const Evaluation& evaluation, const Quad<double>& q, int points, std::uint64_t seed,
                                 double step, double control_distance) {
  if (is_planar(q)) throw std::invalid_argument("a planar quad's hull has no inside");
  const WeightsAt weights = [&](const Vec3<double>& eta) {
    Result<double> result;
    evaluation(Query<double>{q, eta}, result);
    return std::array<double, 4>{result.value[0], result.value[1], result.value[2], result.value[3]};
  };
  const double size = std::max((q[2] - q[0]).norm(), (q[3] - q[1]).norm());
  std::vector<Jump> hull, control;
  for (int i = 0; i < points; ++i) {
    RandomStream random(seed, "hull-continuity", i);
    const int off = i % 4;  // the corner that is not of the face
    const Triangle<double> t{q[(off + 1) % 4], q[(off + 2) % 4], q[(off + 3) % 4]};
    const double a = random.uniform(.15, .7), b = (.85 - a) * random.uniform(.2, 1);
    const Vec3<double> x = a * t[0] + b * t[1] + (1 - a - b) * t[2];
    const Vec3<double> outwards = -side_of_plane(t, q[off]) * (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    hull.push_back(jump_across(weights, x, outwards, step * size));
    control.push_back(jump_across(weights, x + control_distance * size * outwards, outwards, step * size));
  }
  const Spread at_hull = spread(hull), away = spread(control);
  return {points, hull, at_hull.worst, at_hull.median, away.worst, away.median};
}

}  // namespace cageproof::adaptive_qmvc
