// SPDX-License-Identifier: MIT
// Enclosures of the moments int y1^a y2^b r^(-q) over the triangle, r^2 = y1^2 + y2^2 + d^2.
#pragma once

#include "frame.h"
#include "radial.h"
#include "seen_element.h"

#include <optional>

namespace cageproof::quadrature_ref::certified {

/// A set of moments: per power q the highest degree a + b.
class MomentRange {
 public:
  /// \param odd whether the powers are odd
  explicit MomentRange(bool odd) : lowest_q_(odd ? -1 : 2), degrees_(2, -1) {}  // the recurrences' first two
  void include(int degree, int q);
  int lowest_q() const { return lowest_q_; }
  int highest_q() const { return lowest_q_ + 2 * (static_cast<int>(degrees_.size()) - 1); }
  int degree(int q) const { return degrees_[(q - lowest_q_) / 2]; }  ///< -1: none
  int highest_degree() const;

 private:
  int lowest_q_;
  std::vector<int> degrees_;
};

/// The moments of a range.
class Moments {
 public:
  explicit Moments(const MomentRange& range)
      : range_(range),
        stride_((range.highest_degree() + 1) * (range.highest_degree() + 2) / 2),
        values_(stride_ * ((range.highest_q() - range.lowest_q()) / 2 + 1)) {}
  const MomentRange& range() const { return range_; }
  Real& at(int a, int b, int q) { return values_[index(a, b, q)]; }
  const Real& at(int a, int b, int q) const { return values_[index(a, b, q)]; }

 private:
  std::size_t index(int a, int b, int q) const {
    const int place = (q - range_.lowest_q()) / 2 * stride_ + (a + b) * (a + b + 1) / 2 + b;
    return static_cast<std::size_t>(place);
  }

  MomentRange range_;
  int stride_;
  std::vector<Real> values_;
};

/// A triangle with its moments.
class SeenTriangle final : public SeenElement {
 public:
  /// Both must outlive it.
  SeenTriangle(const Frame& frame, const Moments& moments) : frame_(frame), moments_(moments) {}
  const Real& axis(int axis, int i) const override { return frame_.axes[axis][i]; }
  const Real& height() const override { return frame_.height; }
  bool in_plane() const override { return frame_.in_plane; }
  Real moment(const Monomial& term, std::optional<int> corner) const override {
    const int a = term.powers[0], b = term.powers[1], q = term.q;
    const Real& plain = moments_.at(a, b, q);
    if (!corner) return plain;
    const auto& hat = frame_.hat[*corner];
    return plain * hat[0] + moments_.at(a + 1, b, q) * hat[1] + moments_.at(a, b + 1, q) * hat[2];
  }

 private:
  const Frame& frame_;
  const Moments& moments_;
};

/// The moments, by one-dimensional integrals over the edges (README.md), at working_bits.
///
/// \param goal truncation error wanted, in bits below the largest contribution to each moment: a wish that decides how
/// much is spent; what was reached is in the radii
/// \param work_left what may be spent, CertifiedEffort::most_work's unit; what is spent is taken off. Nothing is
/// returned, and it is below zero, where it would not suffice
/// \param nodes is increased by the number of nodes spent
/// \pre moments with q >= a + b + 2 are not used where the point lies on the triangle
std::optional<Moments> integrate_moments(const Frame& frame, const MomentRange& range, int goal, double& work_left,
                                         std::size_t& nodes);

}  // namespace cageproof::quadrature_ref::certified
