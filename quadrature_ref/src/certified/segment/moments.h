// SPDX-License-Identifier: MIT
// Enclosures of the moments int s^m r^(-q) ds over a segment, r^2 = s^2 + d^2, and of those with ln r.
#pragma once

#include "../seen_element.h"
#include "frame.h"

#include <map>

namespace cageproof::quadrature_ref::certified {

/// A segment's moments, each computed when it is first asked for, by recurrences (../README.md) that end at the
/// segment's ends. At the working_bits of its construction. Not safe from several threads.
class SegmentMoments final : public SeenElement {
 public:
  explicit SegmentMoments(SegmentFrame frame) : frame_(std::move(frame)) {}

  const SegmentFrame& frame() const { return frame_; }
  const Real& axis(int axis, int i) const override { return frame_.axes[axis][i]; }
  const Real& height() const override { return frame_.height; }
  bool in_plane() const override { return frame_.on_line; }
  /// \pre on the segment: m + 1 > q
  /// \throws std::logic_error for a logarithm over a positive power of r, which no kernel has
  Real moment(const Monomial& term, std::optional<int> corner) const override;

 private:
  const Real& power(int m, int q) const;      // int s^m r^(-q)
  const Real& logarithm(int m, int q) const;  // int s^m r^(-q) ln r
  Real power_off_line(int m, int q) const;
  Real power_on_line(int m, int q) const;
  Real between_ends(int m, int q) const;  // s^m r^(-q) at the last end less that at the first
  Real distance_power(int end, int exponent) const;

  SegmentFrame frame_;
  mutable std::map<std::pair<int, int>, Real> powers_, logarithms_;
};

}  // namespace cageproof::quadrature_ref::certified
