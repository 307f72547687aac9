// SPDX-License-Identifier: MIT
#include "arm_frame.h"

#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

using R = Mp200;

// Arc length from end 0 to the foot of the perpendicular, and from there to end 1: exactly zero where the foot is an
// end.
struct Foot {
  R from_start, to_end;
};

Foot foot_of(const SegmentFrame<R>& s) { return {-s.start, s.end}; }

}  // namespace

OnSegment on_segment(const SegmentFrame<R>& s) {
  const Foot foot = foot_of(s);
  if (s.height != 0 || foot.from_start < 0 || foot.to_end < 0) return {};
  if (foot.from_start == 0 || foot.to_end == 0) return {true, true, s.extent};
  return {true, false, std::min(foot.from_start, foot.to_end)};
}

ArmFrame<R> arm_frame(const SegmentFrame<R>& s, const R& inward) {
  const Foot foot = foot_of(s);
  const Vec3<R> along = s.edges[0] / s.extent;
  const bool before = foot.from_start <= 0, beyond = foot.to_end <= 0;
  ArmFrame<R> frame;
  frame.exponent = s.exponent;
  frame.normal = s.normal;
  frame.height = s.height + inward;
  const Vec3<R> nearest = before ? s.corners[0] : beyond ? s.corners[1] : Vec3<R>(s.normal * s.height);
  frame.base = nearest + s.normal * inward;
  frame.distance = length(frame.base);
  frame.hat[1] = before ? R(0) : beyond ? R(1) : R(foot.from_start / s.extent);
  frame.hat[0] = before ? R(1) : beyond ? R(0) : R(foot.to_end / s.extent);
  const auto add_arm = [&](int sign, const R& reach) {
    const R slope = sign / s.extent;
    frame.arms.push_back({along * R(sign), inverse_sinh(R(reach / frame.distance)), {R(-slope), slope}});
  };
  if (!beyond) add_arm(1, before ? s.extent : foot.to_end);
  if (!before) add_arm(-1, beyond ? s.extent : foot.from_start);
  // The sine of the angle is stated by the height: with c inside the segment it is one, next to the line it is tiny.
  const auto sine = static_cast<double>(R(abs(frame.height) / frame.distance));
  const auto cosine =
      before || beyond ? static_cast<double>(R(dot(frame.base, frame.arms[0].direction) / frame.distance)) : 0.;
  const std::complex<double> zero = std::asinh(std::complex<double>(-cosine, sine));
  frame.singular = {zero, {-zero.real(), std::numbers::pi - zero.imag()}};
  return frame;
}

}  // namespace cageproof::quadrature_ref
