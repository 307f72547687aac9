// SPDX-License-Identifier: MIT
// The solid angle of a bilinear quad: of two triangles, and its derivatives as sums over the four sides.
#pragma once

#include "quad/engine/line_moments.h"
#include "quad/potentials/line_powers.h"
#include "cageproof/core/numbers/linear.h"

namespace cageproof::adaptive_qmvc {

/// Adds one side's part of gradient and Hessian: the gradient is the integral of x x dl/r^3 around the quad.
/// \param a the side's nearer end, seen from the point
/// \param d the side from there
/// \param c a x d, to its last digits
/// \param digits of the Gauss rule that far sides take, whose terms cancel otherwise; 800 digits have some to spare
template <class R>
void add_side_to_solid_angle(const Vec3<R>& a, const Vec3<R>& d, const Vec3<R>& c, int order, double digits,
                             Vec3<R>& gradient, Eigen::Matrix<R, 3, 3>& hessian) {
  using std::sqrt;
  const R length2 = d.dot(d);
  if (!(length2 > R(0))) return;
  const Vec3<R> end = a + d;
  LinePowers<R> powers;
  Vec3<R> x;
  const auto ends = static_cast<double>(R((sqrt(R(a.dot(a))) + sqrt(R(end.dot(end)))) / sqrt(length2)));
  const bool is_near = std::same_as<R, Mp800> || ends < kFarAlongLine;
  if (is_near) {
    line_powers_about_foot<R>(a, d, R(0), R(1), R(c.dot(c)), 2, powers);
    x = d.cross(c) / length2;
  }
  if constexpr (!std::same_as<R, Mp800>)
    if (!is_near) {
      line_powers_by_gauss<R>(a, d, R(0), nodes_of<R>(plain_nodes(ends, 2.5, digits)), 2, powers);
      x = a + powers.origin * d;
    }
  gradient += powers.power[2][0] * c;
  if (order < 2) return;
  const Vec3<R> along = 3 * (powers.power[3][0] * x + powers.power[3][1] * d);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) hessian(i, j) += c[i] * along[j];
  // -(e_j x d)_i of the cube's integral.
  const Vec3<R> turned = powers.power[2][0] * d;
  hessian(0, 1) -= turned[2];
  hessian(1, 0) += turned[2];
  hessian(1, 2) -= turned[0];
  hessian(2, 1) += turned[0];
  hessian(2, 0) -= turned[1];
  hessian(0, 2) += turned[1];
}

}  // namespace cageproof::adaptive_qmvc
