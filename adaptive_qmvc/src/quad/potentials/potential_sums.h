// SPDX-License-Identifier: MIT
// The integrals of a potential's tape, summed over the lines of rules.
#pragma once

#include "quad/engine/line_references.h"
#include "quad/engine/outer_rule.h"
#include "quad/mean_value/line_form/weight_sums.h"
#include "quad/potentials/kernel_terms.h"
#include "quad/potentials/line_powers.h"

#include <algorithm>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// The sums over lines: for each integral one number per corner, and the sum of the sizes of its terms over all basis
/// functions.
template <class R>
struct IntegralSums {
  std::vector<std::array<R, 4>> of;
  std::vector<Size<R>> sizes;

  explicit IntegralSums(const LineIntegrals& integrals) : of(integrals.integrals.size()), sizes(of.size()) {}
};

/// The bilinear basis functions on a line: near to corners 0 and 3, far to 1 and 2, left to 0 and 1, right to 2 and 3.
template <class R>
struct BasisOnLine {
  R near, far, far_slope;      ///< 1 - u and u
  R left, right, right_slope;  ///< 1 - v and v
};

/// The integrals of a potential's tape, over the lines of one rule.
template <class R>
class PotentialSums {
 public:
  PotentialSums(const KernelTape& tape, double digits)
      : tape_(tape), digits_(digits), across_(tape.across), around_(tape.around) {}

  const KernelTape& tape() const { return tape_; }
  const IntegralSums<R>& across() const { return across_; }
  const IntegralSums<R>& around() const { return around_; }

  /// Adds all lines of a rule. Returns how many.
  /// \param references the first one is the point of the lines next to which the rule's are dense
  /// \param centre the rule's, as a step from the frame's line
  std::size_t add_lines(const LineReferences<R>& references, const OuterRule<R>& rule, const R& centre,
                        std::span<const Panel> panels);

  /// Adds the border of the part of the quad that the rule is for. \param centre as in add_lines
  void add_border(const LineReferences<R>& references, const OuterRule<R>& rule, const R& centre);

 private:
  static constexpr int kTerms = 7;  // of a polynomial: as many as its degree, and one
  using Polynomial = std::array<R, kTerms>;
  // Each factor is constant + slope t.
  using LineFactors = std::array<std::array<R, 2>, line_factor::kCount>;

  // Lines at d = a cosh y + c sinh y from the centre: c^2 = a^2 + width^2, y from 0 to span.
  struct Stretch {
    R a, c, span;
  };
  static Stretch stretch_of(const R& width, const R& from, const R& to);

  // Along the line a + t e, t in [first, last] of length 1: the powers' integrals. Returns the line's point at their
  // origin.
  Vec3<R> find_powers(const Vec3<R>& a, const Vec3<R>& e, const R& first, const R& last, const Vec3<R>& area, int top);
  void add_integrals(const LineIntegrals& integrals, const BasisOnLine<R>& basis, const R& weight,
                     IntegralSums<R>& sums);
  void add_line(const LineReferences<R>& references, const R& step, const R& weight);
  void add_horizontal_side(const LineReferences<R>& references, const R& step, int sign);
  void add_vertical_side(const LineReferences<R>& references, const R& from, const R& to, bool far);
  // x, N, g and M on the line v0 + s of a reference, for the integrals' origin.
  BasisOnLine<R> put_horizontal(const LineReference<R>& reference, const R& step, const Vec3<R>& x);

  void put(int factor, const Vec3<R>& constant, const Vec3<R>& slope) {
    for (int i = 0; i < 3; ++i) factors_[factor + i] = {constant[i], slope[i]};
  }

  const KernelTape& tape_;
  double digits_;
  IntegralSums<R> across_, around_;
  std::vector<Polynomial> polynomials_;
  LineFactors factors_;
  LinePowers<R> powers_;
};

template <class R>
Vec3<R> PotentialSums<R>::find_powers(const Vec3<R>& a, const Vec3<R>& e, const R& first, const R& last,
                                      const Vec3<R>& area, int top) {
  using F = Size<R>;
  const Vec3<R> start = a + first * e, end = a + last * e;
  const auto length = [](const Vec3<R>& v) { return std::sqrt(static_cast<F>(R(v.dot(v)))); };
  const F ends = length(start) + length(end), along_line = length(e);
  if (ends < kFarAlongLine * along_line) {
    line_powers_about_foot<R>(a, e, first, last, R(area.dot(area)), top, powers_);
    // Not a + origin e, whose terms cancel where the foot is far along the line.
    return e.cross(area) / e.dot(e);
  }
  // The order of the poles of r^-(2 top + 1).
  const double order = top + 0.5;
  const int nodes =
      along_line > 0 ? plain_nodes(static_cast<double>(ends / along_line), std::max(order, 0.5), digits_) : 2;
  line_powers_by_gauss<R>(a, e, first, nodes_of<R>(nodes), top, powers_);
  return a + powers_.origin * e;
}

template <class R>
void PotentialSums<R>::add_integrals(const LineIntegrals& integrals, const BasisOnLine<R>& basis, const R& weight,
                                     IntegralSums<R>& sums) {
  using F = Size<R>;
  const auto size = [](const R& value) { return std::abs(static_cast<F>(value)); };
  polynomials_.resize(std::max(polynomials_.size(), integrals.polynomials.size()));
  polynomials_[0][0] = R(1);
  for (std::size_t p = 1; p < integrals.polynomials.size(); ++p) {
    const LineFactor& made = integrals.polynomials[p];
    const Polynomial& from = polynomials_[made.parent];
    const auto& [constant, slope] = factors_[made.factor];
    Polynomial& to = polynomials_[p];
    to[0] = constant * from[0];
    if (!made.is_linear) {
      for (int d = 1; d <= made.degree; ++d) to[d] = constant * from[d];
      continue;
    }
    for (int d = 1; d < made.degree; ++d) to[d] = constant * from[d] + slope * from[d - 1];
    to[made.degree] = slope * from[made.degree - 1];
  }
  const F weights = size(weight);
  for (std::size_t i = 0; i < sums.of.size(); ++i) {
    const auto& [polynomial, m, part] = integrals.integrals[i];
    const Polynomial& p = polynomials_[polynomial];
    const auto& power = powers_.power[m + 1];
    const int degree = integrals.polynomials[polynomial].degree;
    R f0 = p[0] * power[0];
    F sizes = size(f0);
    for (int d = 1; d <= degree; ++d) {
      const R term = p[d] * power[d];
      sizes += size(term);
      f0 += term;
    }
    sums.sizes[i] += weights * sizes;
    // Whether basis functions change along the line.
    const bool changes =
        part == BasisPart::Phi || part == (basis.far_slope == R(0) ? BasisPart::PhiU : BasisPart::PhiV);
    R f1 = R(0);
    if (changes) {
      for (int d = 0; d <= degree; ++d) f1 += p[d] * power[d + 1];
      f1 *= weight;
    }
    f0 *= weight;
    auto& to = sums.of[i];
    switch (part) {
      case BasisPart::Phi: {
        const R uf = basis.far_slope * f1, vr = basis.right_slope * f1;
        // One of both directions is constant along the line.
        const R near = basis.near * f0 - uf, far = basis.far * f0 + uf;
        if (basis.right_slope == R(0)) {
          to[0] += basis.left * near;
          to[1] += basis.left * far;
          to[2] += basis.right * far;
          to[3] += basis.right * near;
        } else {
          const R left = basis.left * f0 - vr, right = basis.right * f0 + vr;
          to[0] += basis.near * left;
          to[1] += basis.far * left;
          to[2] += basis.far * right;
          to[3] += basis.near * right;
        }
        break;
      }
      case BasisPart::PhiU: {
        const R vr = basis.right_slope * f1, left = basis.left * f0 - vr, right = basis.right * f0 + vr;
        to[0] -= left;
        to[1] += left;
        to[2] += right;
        to[3] -= right;
        break;
      }
      case BasisPart::PhiV: {
        const R uf = basis.far_slope * f1, near = basis.near * f0 - uf, far = basis.far * f0 + uf;
        to[0] -= near;
        to[1] -= far;
        to[2] += far;
        to[3] += near;
        break;
      }
      case BasisPart::PhiUV:
        to[0] += f0;
        to[1] -= f0;
        to[2] += f0;
        to[3] -= f0;
        break;
    }
  }
}

template <class R>
BasisOnLine<R> PotentialSums<R>::put_horizontal(const LineReference<R>& reference, const R& step, const Vec3<R>& x) {
  using namespace line_factor;
  const LocalFrame<R>& q = reference.q;
  const R s = step + reference.ahead;
  const Vec3<R> e = q.direction(s), zero = Vec3<R>::Zero();
  const R g1 = q.g10 + s * q.g11, g0 = q.g00 + s * q.g01 + powers_.origin * g1;
  put(kX, x, e);
  put(kN, q.n + s * q.n_v + powers_.origin * q.n_u, q.n_u);
  factors_[kHeight] = {g0, g1};
  if (tape_.tangential) {
    const R past = reference.past + powers_.origin;
    put(kAlongU, e, zero);
    put(kAlongV, q.b + powers_.origin * q.w, q.w);
    put(kTurn, past * q.n_u + step * q.n_v, q.n_u);
    put(kTwist, q.w, zero);
  }
  const R right = q.v0 + s;
  return {R(q.last - powers_.origin), R(q.u0 + powers_.origin), R(1), R(1 - right), right, R(0)};
}

template <class R>
void PotentialSums<R>::add_line(const LineReferences<R>& references, const R& step, const R& weight) {
  const LineReference<R>& reference = references.at(step);
  const LocalFrame<R>& q = reference.q;
  const R s = step + reference.ahead;
  const Vec3<R> x = find_powers(q.start(s), q.direction(s), q.first, q.last, reference.area.at(s), tape_.across.top);
  add_integrals(tape_.across, put_horizontal(reference, step, x), weight, across_);
}

template <class R>
void PotentialSums<R>::add_horizontal_side(const LineReferences<R>& references, const R& step, int sign) {
  const LineReference<R>& reference = references.at(step);
  const LocalFrame<R>& q = reference.q;
  const R s = step + reference.ahead;
  const Vec3<R> e = q.direction(s);
  const Vec3<R> x = find_powers(q.start(s), e, q.first, q.last, reference.area.at(s), tape_.around.top);
  const BasisOnLine<R> basis = put_horizontal(reference, step, x);
  put(line_factor::kStep, e, Vec3<R>::Zero());
  add_integrals(tape_.around, basis, R(sign), around_);
}

template <class R>
void PotentialSums<R>::add_vertical_side(const LineReferences<R>& references, const R& from, const R& to, bool far) {
  using namespace line_factor;
  const LineReference<R>& reference = references.beside(far);
  const LocalFrame<R>& q = reference.q;
  // In lengths of the side, from the reference's line.
  const R t = far ? q.last : q.first, length = to - from, start_at = from + reference.ahead,
          end_at = to + reference.ahead;
  const Vec3<R> along_v = q.b + t * q.w, side = length * along_v, zero = Vec3<R>::Zero();
  const Vec3<R> start = q.a + t * q.e;
  const Vec3<R> x =
      find_powers(start, side, R(start_at / length), R(end_at / length), start.cross(side), tape_.around.top);
  const R s = length * powers_.origin;
  const R g1 = q.g01 + t * q.g11, g0 = q.g00 + t * q.g10 + s * g1;
  put(kX, x, side);
  put(kN, q.n + t * q.n_u + s * q.n_v, length * q.n_v);
  factors_[kHeight] = {g0, R(length * g1)};
  put(kAlongU, q.e + s * q.w, length * q.w);
  put(kAlongV, along_v, zero);
  put(kTurn, R(reference.past + t) * q.n_u + (s - reference.ahead) * q.n_v, length * q.n_v);
  put(kTwist, q.w, zero);
  put(kStep, side, zero);
  add_integrals(tape_.around, {far ? R(0) : R(1), far ? R(1) : R(0), R(0), R(R(1 - q.v0) - s), R(q.v0 + s), length},
                R(far ? 1 : -1), around_);
}

template <class R>
void PotentialSums<R>::add_border(const LineReferences<R>& references, const OuterRule<R>& rule, const R& centre) {
  if (tape_.around.integrals.empty()) return;
  const R from = centre + rule.to_lo, to = centre + rule.to_hi;
  add_horizontal_side(references, from, 1);
  add_horizontal_side(references, to, -1);
  add_vertical_side(references, from, to, true);
  add_vertical_side(references, from, to, false);
}

template <class R>
typename PotentialSums<R>::Stretch PotentialSums<R>::stretch_of(const R& width, const R& from, const R& to) {
  using std::asinh, std::cosh, std::sinh, std::sqrt;
  if (from < R(0) && to > R(0)) return {R(0), width, R(0)};
  // From the end nearer to the centre: sinh of a rounded s would lose |s| roundings.
  const bool turned = to <= R(0);
  const R a = turned ? to : from, b = turned ? from : to;
  const R c = sqrt(R(a * a + width * width));
  R span = asinh(R(b / width)) - asinh(R(a / width));
  // So that the other end is hit.
  for (int round = 0; round < 2; ++round) {
    const R sh = sinh(span), ch = cosh(span);
    span -= (a * ch + c * sh - b) / (a * sh + c * ch);
  }
  return {a, c, span};
}

template <class R>
std::size_t PotentialSums<R>::add_lines(const LineReferences<R>& references, const OuterRule<R>& rule, const R& centre,
                                        std::span<const Panel> panels) {
  using std::abs, std::cosh, std::sinh;
  std::size_t lines = 0;
  const R v0 = references.base().v0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const Panel& panel = panels[p];
    const Nodes<R> gauss = nodes_of<R>(panel.nodes);
    lines += panel.nodes;
    const bool first = p == 0, last = p + 1 == panels.size();
    if (rule.plain) {
      const R lo = first ? rule.first : R(panel.lo), hi = last ? rule.last : R(panel.hi);
      for (int i = 0; i < panel.nodes; ++i)
        add_line(references, R(lo + (hi - lo) * gauss.nodes[i] - v0), R((hi - lo) * gauss.weights[i]));
      continue;
    }
    const R from = first ? rule.to_lo : R(rule.width * sinh(R(panel.lo)));
    const R to = last ? rule.to_hi : R(rule.width * sinh(R(panel.hi)));
    const Stretch stretch = stretch_of(rule.width, from, to);
    // Around the centre the panel is one in s itself.
    const bool around = stretch.span == R(0);
    const R lo = around ? (first ? rule.first : R(panel.lo)) : R(0);
    const R range = around ? R((last ? rule.last : R(panel.hi)) - lo) : stretch.span;
    for (int i = 0; i < panel.nodes; ++i) {
      const R y = lo + range * gauss.nodes[i];
      const R sh = sinh(y), ch = cosh(y);
      const R weight = abs(range) * (stretch.a * sh + stretch.c * ch) * gauss.weights[i];
      add_line(references, R(centre + (stretch.a * ch + stretch.c * sh)), weight);
    }
  }
  return lines;
}

}  // namespace cageproof::adaptive_qmvc
