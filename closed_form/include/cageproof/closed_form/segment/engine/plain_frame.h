// SPDX-License-Identifier: MIT
// The frame in a scalar's own arithmetic, from the four coordinates of the ends and two of the point: as a program or a
// shader without wider numbers can compute it.
#pragma once

#include "cageproof/closed_form/segment/engine/frame.h"

namespace cageproof::closed_form::segment {

/// The height is taken from the nearer end and divided last, so that it is exact where coordinates are small integers.
/// Lengths are the caller's.
template <class R>
Frame<R> plain_frame(const Segment<R>& segment, const Vec3<R>& eta) {
  using std::log, std::sqrt;
  Frame<R> f;
  f.exponent = f.near_exponent = 0;
  const auto size_of = [](const R& x, const R& y) { return R(sqrt(x * x + y * y)); };
  const std::array<R, 2> along{segment[1][0] - segment[0][0], segment[1][1] - segment[0][1]};
  f.length = size_of(along[0], along[1]);
  f.u = {along[0] / f.length, along[1] / f.length};
  f.n = {f.u[1], -f.u[0]};
  std::array<std::array<R, 2>, 2> p;
  for (int i = 0; i < 2; ++i) {
    f.way[i] = (along[i] > 0) - (along[i] < 0);
    for (int c = 0; c < 2; ++c) p[i][c] = segment[i][c] - eta[c];
    f.r[i] = size_of(p[i][0], p[i][1]);
    f.s[i] = (along[0] * p[i][0] + along[1] * p[i][1]) / f.length;
    f.log_r[i] = log(f.r[i]);
  }
  f.sum = f.s[0] + f.s[1];
  f.near_end = f.r[0] <= f.r[1] ? 0 : 1;
  f.near_mantissa = f.r[f.near_end];
  f.at_end = f.near_mantissa == 0;
  const R across = (along[0] * p[f.near_end][1] - along[1] * p[f.near_end][0]) / f.length;
  // On the line the frame is the limit from inside.
  f.h = f.at_end || across == 0 ? -R(0) : across;
  if (f.at_end) f.near = {R(0), R(1)};
  else f.near = {f.s[f.near_end] / f.near_mantissa, -f.h / f.near_mantissa};
  f.set_angle_and_ratio();
  return f;
}

}  // namespace cageproof::closed_form::segment
