// SPDX-License-Identifier: MIT
// The quickest evaluation of a segment formula that keeps its promise: the closed form in double nearby, Gauss points
// far away.
#pragma once

#include "cageproof/closed_form/segment/engine/exact_frame.h"
#include "cageproof/closed_form/segment/engine/kernel.h"
#include "far_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cageproof::fast::segment {

using closed_form::Jet;

/// Ends nearer than 2^-kExtreme, of the segment or of one, leave double: squares of 1/r leave its range.
inline constexpr int kExtreme = 400;
/// The least ratio of lengths, and of their products with the sine of the angle at the nearer end, to the longest one.
inline constexpr double kTiny = 0x1p-900;

/// Whether powers of distances leave double's range. The height of a point off the line, over the longest length, may
/// be subnormal or zero in double.
inline bool is_extreme(const Segment<double>& s, const Vec3<double>& eta, const Frame<double>& frame) {
  if (frame.at_end) return false;
  if (frame.near_exponent - frame.exponent < -kExtreme || frame.exponent < -kExtreme) return true;
  if (frame.length < kTiny) return true;
  return std::abs(frame.length * frame.near.im) < kTiny && side_of_line(s, eta) != 0;
}

/// Whether values are so small that double may have none of their digits, such as angles of the size of the least
/// numbers. Far away, where no terms cancel, this is never needed.
template <std::size_t C>
bool is_next_to_nothing(const Frame<double>& frame, const std::array<double, C>& values) {
  double size = 0;
  for (const double x : values) size = std::max(size, std::abs(x));
  return size > 0 && size < 0x1p-900 && !frame.is_far();
}

/// Whether a tensor of the order is small compared with the logarithms it is made of, as next to a potential's zeros,
/// which depend on the unit of length. The roundings there are those of the logarithms, however small their sum is.
template <int C>
bool is_next_to_zero(const Frame<double>& frame, const LogarithmicPart& part, int order, const Jet<double, C, 2>& jet) {
  if (part.power < order) return false;
  constexpr double small = 0x1p-6;
  double largest = 0;
  for (int c = 0; c < C; ++c)
    largest = std::max(largest, order == 0   ? std::abs(jet.value[c])
                                : order == 1 ? jet.gradient[c].cwiseAbs().maxCoeff()
                                             : jet.hessian[c].cwiseAbs().maxCoeff());
  double size = small * std::abs(part.factor) * frame.length;
  for (int i = 0; i < order; ++i) size *= std::max(1, part.power - i);
  for (int i = 0; i < part.power - order; ++i)
    size *= part.over_height && order == 0 && i == 0 ? std::abs(frame.h) : frame.far_r();
  return largest < std::ldexp(size, frame.exponent * (1 + part.power - order));
}

/// Whether a formula's powers of the height over the segment's line leave double's range.
template <class F>
bool is_next_to_line(const Frame<double>& frame) {
  if constexpr (requires { F::diverges_on_segment; })
    return !frame.at_end && std::abs(frame.near.im) < 0x1p-300;  // zero may be an underflow
  else return false;
}

/// Whether infinities at the ends have signs that double may get wrong, because they are polynomials of the segment's
/// direction.
template <class F>
inline constexpr bool has_signs_at_ends = requires {
  F::has_signs_at_ends;
};

/// A segment seen from a point in double. The segment and the point must outlive it.
struct SeenSegment {
  FarFrame<double> frame;
  bool extreme;

  SeenSegment(const Segment<double>& s, const Vec3<double>& eta) : frame(s, eta), extreme(is_extreme(s, eta, frame)) {}
};

/// In double; nothing where the closed form with more digits is to be taken. \param finite_part Batch::finite_part
template <class F, int O>
std::optional<Jet<double, F::components, 2>> hybrid(const SeenSegment& seen, std::span<const double> parameters,
                                                    bool finite_part) {
  const FarFrame<double>& frame = seen.frame;
  if (seen.extreme || (frame.at_end && has_signs_at_ends<F>) || is_next_to_line<F>(frame)) return std::nullopt;
  auto jet = jet_at<F, O>(frame, parameters, finite_part);
  if (is_next_to_nothing(frame, jet.value)) return std::nullopt;
  if constexpr (requires { F::logarithmic_part(parameters); }) {
    const LogarithmicPart part = F::logarithmic_part(parameters);
    for (int order = 0; order <= O; ++order)
      if (is_next_to_zero(frame, part, order, jet)) return std::nullopt;
  }
  // Far from a tiny segment second derivatives overflow first: infinities times a normal's zeros have no sign.
  if (O >= 2 && !frame.at_end && !std::ranges::all_of(jet.hessian, [](const auto& h) { return h.allFinite(); }))
    return std::nullopt;
  return jet;
}

}  // namespace cageproof::fast::segment
