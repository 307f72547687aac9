// SPDX-License-Identifier: MIT
// Enters a segment formula's evaluations into the register.
#pragma once

#include "../../joint.h"
#include "../../plain_family.h"

#include "cageproof/closed_form/segment/engine/accurate.h"
#include "cageproof/closed_form/segment/engine/plain.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cageproof::closed_form::segment {

/// Ends nearer than 2^-kExtreme, of the segment or of one, are seen in multiprecision: squares of 1/r leave double's
/// range.
inline constexpr int kExtreme = 400;
/// And lengths, and their products with the sine of the angle at the nearer end, over what is longest.
inline constexpr double kTiny = 0x1p-900;

/// What closed forms on a segment share: the ends, and at each point the frame, all in the scalar that they compute in.
struct SharedOnSegment {
  template <Scalar R>
  struct Element {
    Segment<Working<R>> s;
    explicit Element(std::span<const Vec3<R>> ends) : s{convert<Working<R>>(ends[0]), convert<Working<R>>(ends[1])} {}
  };
  template <Scalar R, int O>
  struct At {
    Segment<Working<R>> given;
    Vec3<Working<R>> at_point;
    FarFrame<Working<R>> frame;
    /// The same in multiprecision, where powers of distances leave double's range.
    std::optional<FarFrame<Mp200>> beyond;

    At(const Element<R>& element, const Vec3<R>& point)
        : given{element.s}, at_point(convert<Working<R>>(point)), frame(element.s, at_point) {
      if constexpr (!is_multiprecision<R>)
        if (is_extreme()) beyond.emplace(in_multiprecision());
    }

    // A point off the line may have a height, over what is longest, that double has few bits of, or none.
    bool is_extreme() const {
      if (frame.at_end) return false;
      if (frame.near_exponent - frame.exponent < -kExtreme || frame.exponent < -kExtreme) return true;
      if (frame.length < kTiny) return true;
      return std::abs(frame.length * frame.near.im) < kTiny && side_of_line(given, at_point) != 0;
    }

    FarFrame<Mp200> in_multiprecision() const {
      return {Segment<Mp200>{convert<Mp200>(given[0]), convert<Mp200>(given[1])}, convert<Mp200>(at_point)};
    }
  };
};

/// Whether values are so small that double may have no digits of them, as of angles of the size of the least numbers.
/// Far away nothing cancels, nor is there need.
template <std::size_t C>
bool is_next_to_nothing(const Frame<double>& frame, const std::array<double, C>& values) {
  double size = 0;
  for (const double x : values) size = std::max(size, std::abs(x));
  return size > 0 && size < 0x1p-900 && !frame.is_far();
}

/// Whether a formula's powers of the height over the segment's line leave double's range.
template <class F>
bool is_next_to_line(const Frame<double>& frame) {
  if constexpr (requires { F::diverges_on_segment; })
    return !frame.at_end && std::abs(frame.near.im) < 0x1p-300;  // zero may be an underflow
  else return false;
}

/// Whether what is infinite at the ends has signs that double may not tell: polynomials of the segment's direction.
template <class F>
inline constexpr bool has_signs_at_ends = requires {
  F::has_signs_at_ends;
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutForm {
  template <Scalar R, int O>
  static void put(SharedOnSegment::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    const auto beyond = [&](const FarFrame<Mp200>& frame) { return jet_at<F, O>(frame, parameters, finite_part); };
    if (at.beyond) return closed_form::put(narrowed<R>(beyond(*at.beyond)), O, point, output);
    if constexpr (!is_multiprecision<R>)
      if (at.frame.at_end && has_signs_at_ends<F>)
        return closed_form::put(narrowed<R>(beyond(at.in_multiprecision())), O, point, output);
    auto jet = jet_at<F, O>(at.frame, parameters, finite_part);
    if constexpr (!is_multiprecision<R>) {
      if (is_next_to_line<F>(at.frame) || is_next_to_nothing(at.frame, jet.value))
        return closed_form::put(narrowed<R>(beyond(at.in_multiprecision())), O, point, output);
    }
    // Far from a tiny segment second derivatives overflow first: infinities times a normal's zeros have no sign. They
    // are products, which lose nothing in multiprecision, as far as the point may be.
    if constexpr (O >= 2 && !is_multiprecision<R>)
      if (!at.frame.at_end && !std::ranges::all_of(jet.hessian, [](const auto& h) { return h.allFinite(); }))
        jet.hessian = narrowed<double>(beyond(at.in_multiprecision())).hessian;
    closed_form::put(narrowed<R>(jet), O, point, output);
  }
};

template <class F>
inline constexpr Member<SharedOnSegment> member_of = Member<SharedOnSegment>::of<PutForm<F>>();

/// `const RegisterForm<F> register_<kernel>{"segment.<kernel>"};` at namespace scope of the formula's .cpp.
template <class F>
class RegisterForm {
 public:
  explicit RegisterForm(std::string_view formula)
      : fast_(single_family(formula, "closed_form",
                            {.description = "logarithms and an angle, in forms that do not cancel",
                             .role = Role::Recommended,
                             .cost = CostClass::Direct},
                            true, [](Evaluation& evaluation) { set_member(evaluation, member_of<F>); })),
        careful_(single_family(formula, "accurate",
                               {.description = "closed form that bounds its own error, in as many digits as that takes",
                                .role = Role::Stated,
                                .cost = CostClass::Direct,
                                .states_error = true},
                               true,
                               [](Evaluation& evaluation) {
                                 evaluation.set_batch<float>(careful<float>);
                                 evaluation.set_batch<double>(careful<double>);
                               })),
        plain_(plain_family(formula, [](Evaluation& evaluation) {
          evaluation.set_batch<float>(plainly<float>);
          evaluation.set_batch<double>(plainly<double>);
        })) {}

 private:
  // Float's is double's, rounded.
  template <Scalar R>
  static void careful(const Batch<R>& batch, const BatchOutput<R>& output) {
    const Segment<double> s{convert<double>(batch.corners[0]), convert<double>(batch.corners[1])};
    const std::vector<double> parameters(batch.parameters.begin(), batch.parameters.end());
    const auto u = static_cast<double>(unit_roundoff<R>());
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p) {
        const auto f = accurate<F, O>(s, convert<double>(batch.points[p]), parameters, batch.finite_part);
        closed_form::put(narrowed<R>(f.jet), O, p, output);
        const double rounding = std::same_as<R, double> || f.worst() == 0 ? 0 : 2 * u, worst = f.worst() + rounding;
        output.state(p, {.digits = worst > 0 ? -std::log10(worst) : std::numeric_limits<double>::quiet_NaN(),
                         .converged = worst <= 128 * u});
      }
    });
  }

  template <Scalar R>
  static void plainly(const Batch<R>& batch, const BatchOutput<R>& output) {
    const Segment<R> s{batch.corners[0], batch.corners[1]};
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p)
        closed_form::put(plain<F, O, R>(s, batch.points[p], batch.parameters, batch.finite_part), O, p, output);
    });
  }

  RegisterEvaluation fast_, careful_, plain_;
};

}  // namespace cageproof::closed_form::segment
