// SPDX-License-Identifier: MIT
// A potential's tensors from the sums over lines, and how many times as large their terms are.
#pragma once

#include "normal_axes.h"

#include "quad/potentials/potential_form.h"
#include "quad/potentials/potential_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// Sums of terms that are more than that many times as large are taken in more digits, by order of derivatives: a
/// Hessian's own parts are larger than their sum.
inline constexpr std::array<double, 3> kPotentialCancelled{16, 16, 24};

/// A potential's tensors, added up rule by rule in the frame's units, and what the sizes of their terms add up to.
template <class R>
class PotentialParts {
 public:
  explicit PotentialParts(const PotentialTask<R>& task) : task_(task) {
    for (int o = 0; o <= task.order; ++o) {
      entries_[o] = entries_of(task.potential) * (o == 0 ? 1 : o == 1 ? 3 : 9);
      of_[o].assign(4 * entries_[o], R(0));
    }
  }

  /// Adds one rule's sums, in coordinates along `axes`.
  /// \param decades how far the rule's lines reach in powers of e of their distance: so many times as large as their
  /// sum
  ///   terms may be without a loss, since each decade's cancel by themselves
  void add(const PotentialSums<R>& sums, const NormalAxes<R>& axes, double decades);

  /// Turns the frame's units into the caller's, and measures what cancelled.
  void put(const FrameUnit& unit, PotentialTensors<R>& tensors) const;

 private:
  const PotentialTask<R>& task_;
  std::array<std::size_t, 3> entries_{};
  std::array<std::vector<R>, 3> of_;  // of each corner one tensor after the other
  std::array<Size<R>, 3> sizes_{};
  double decades_ = 0;
  std::vector<R> rule_;
};

template <class R>
void PotentialParts<R>::add(const PotentialSums<R>& sums, const NormalAxes<R>& axes, double decades) {
  using F = Size<R>;
  const KernelTape& tape = sums.tape();
  const R inverse = 1 / axes.length;
  decades_ = std::max(decades_, decades);
  for (int o = 0; o <= task_.order; ++o) {
    const std::size_t count = entries_[o];
    rule_.assign(4 * count, R(0));
    F sizes = 0;
    for (std::size_t n = 0; n < count; ++n) {
      F size = 0;
      for (const auto& part : tape.entries[o][n]) {
        R coefficient = task_.parameters[part.parameter] * (R(part.sixths) / R(6));
        if (part.divided) coefficient *= inverse;
        const IntegralSums<R>& from = part.around ? sums.around() : sums.across();
        const auto& of = from.of[part.integral];
        for (std::size_t k = 0; k < 4; ++k) rule_[k * count + n] += coefficient * of[k];
        size += std::abs(static_cast<F>(coefficient)) * from.sizes[part.integral];
      }
      sizes = std::hypot(sizes, size);
    }
    sizes_[o] += sizes;
    // Index by index back to the frame's coordinates, the last one the fastest.
    if (tape.tangential)
      for (std::size_t stride = 1; stride < count; stride *= 3)
        for (std::size_t first = 0; first < rule_.size(); first += 3 * stride)
          for (std::size_t i = first; i < first + stride; ++i) {
            const Vec3<R> v(rule_[i], rule_[i + stride], rule_[i + 2 * stride]);
            const Vec3<R> turned = axes.axes.transpose() * v;
            for (int c = 0; c < 3; ++c) rule_[i + c * stride] = turned[c];
          }
    for (std::size_t i = 0; i < rule_.size(); ++i) of_[o][i] += rule_[i];
  }
}

template <class R>
void PotentialParts<R>::put(const FrameUnit& unit, PotentialTensors<R>& tensors) const {
  using F = Size<R>;
  using std::ldexp;
  const int sign = has_normal(task_.potential) ? unit.sign : 1;
  tensors.cancelled = 1;
  for (int o = 0; o <= task_.order; ++o) {
    const std::size_t count = entries_[o];
    const int exponent = unit.exponent * (degree_of(task_.potential) - o);
    auto& to = tensors.of[o];
    to.resize(4 * count);
    F norm = 0;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t n = 0; n < count; ++n) {
        const R& entry = of_[o][k * count + n];
        norm = std::hypot(norm, static_cast<F>(entry));
        to[unit.corner[k] * count + n] = ldexp(R(sign * entry), exponent);
      }
    // On the border without being placed there, as numbers beyond on_quad() are: more digits find no limit.
    if (sizes_[o] == 0 || (is_multiprecision<R> && !std::isfinite(norm))) continue;
    const double held = kPotentialCancelled[o] + decades_;
    const auto ratio = static_cast<double>(sizes_[o] / norm) * (kPotentialCancelled[0] / held);
    tensors.cancelled = ratio >= 0 ? std::max(tensors.cancelled, ratio) : std::numeric_limits<double>::infinity();
  }
}

}  // namespace cageproof::adaptive_qmvc
