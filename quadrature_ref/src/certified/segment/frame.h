// SPDX-License-Identifier: MIT
// A segment of the plane as its point sees it, in balls.
#pragma once

#include "../ball.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <optional>

namespace cageproof::quadrature_ref::certified {

/// x = xi - eta of the segment's points: arc length s along the segment from the foot of the perpendicular, and d =
/// x.n, constant.
struct SegmentFrame {
  std::array<std::array<Real, 2>, 2> axes;  ///< along the segment, and the outward unit normal, to the right of it
  Real length, height;
  std::array<Real, 2> s;           ///< of the ends
  std::array<Real, 2> squares;     ///< of the ends' distances
  std::array<Real, 2> logarithms;  ///< of the ends' distances; not finite at an end
  Real log_ratio;                  ///< ln(r1/r0); not finite at an end
  Real angle;                      ///< int d/r^2, in (-pi, pi): not finite on the line
  std::array<bool, 2> at_end{};    ///< the point is that end
  bool on_line = false;            ///< d is exactly zero
  bool on_segment = false;         ///< the point lies on the segment, its ends included
  int side = 0;                    ///< the sign of s on the line beyond the ends
};

/// The frame at working_bits, with exact signs; third coordinates are ignored. Nothing for a segment without length, an
/// input that is not finite, or one whose coordinates spread over more than 2^20000.
template <Scalar R>
std::optional<SegmentFrame> segment_frame_of(const Query<R>& query);

}  // namespace cageproof::quadrature_ref::certified
