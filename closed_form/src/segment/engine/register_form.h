// SPDX-License-Identifier: MIT
// Enters a segment formula's evaluations into the register.
#pragma once

#include "../../families.h"

#include "cageproof/closed_form/arithmetic/spacing.h"
#include "cageproof/closed_form/joint.h"
#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/engine/plain.h"

#include <cmath>

namespace cageproof::closed_form::segment {

/// What closed forms on a segment share: the ends, and at each point the frames, in double or in multiprecision.
struct SharedOnSegment {
  template <cageproof::Scalar R>
  using Wide = std::conditional_t<is_multiprecision<R>, Mp200, double>;

  template <cageproof::Scalar R>
  struct Element {
    Segment<Wide<R>> s;
    explicit Element(std::span<const Vec3<R>> ends) : s{convert<Wide<R>>(ends[0]), convert<Wide<R>>(ends[1])} {}
  };
  template <cageproof::Scalar R, int O>
  struct At {
    std::conditional_t<is_multiprecision<R>, WideFrames, PointFrames> frames;
    At(const Element<R>& element, const Vec3<R>& point) : frames(element.s, convert<Wide<R>>(point)) {}
  };
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutForm {
  template <cageproof::Scalar R, int O>
  static void put(SharedOnSegment::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    using W = SharedOnSegment::Wide<R>;
    std::array<W, 4> wide;
    for (std::size_t i = 0; i < parameters.size(); ++i) wide[i] = W(parameters[i]);
    const auto given = std::span<const W>(wide).first(parameters.size());
    if constexpr (is_multiprecision<R>) {
      const auto found = bounded_form<F, O>(at.frames, given, finite_part, std::numeric_limits<R>::digits10);
      closed_form::put(narrowed<R>(found.jet), O, point, output);
    } else {
      constexpr double largest = std::numeric_limits<R>::max();
      closed_form::put(narrowed<R>(bounded_form<F, O>(at.frames, given, finite_part, kTolerance, largest).jet), O,
                       point, output);
    }
  }
};

template <class F>
inline constexpr auto member_of = Member<SharedOnSegment>::of<PutForm<F>, float, double, Mp50, Mp100, Mp200>();

/// `const RegisterForm<F> register_<kernel>{"segment.<kernel>"};` at namespace scope.
template <class F>
class RegisterForm {
 public:
  explicit RegisterForm(std::string_view formula)
      : kept_(closed_form_family(
            formula, "logarithms and an angle, in as many digits as its promise takes",
            [](Evaluation& evaluation) { set_member<float, double, Mp50, Mp100, Mp200>(evaluation, member_of<F>); })),
        careful_(accurate_family(formula,
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
  template <cageproof::Scalar R>
  static void careful(const Batch<R>& batch, const BatchOutput<R>& output) {
    const Segment<double> s{convert<double>(batch.corners[0]), convert<double>(batch.corners[1])};
    const std::vector<double> parameters(batch.parameters.begin(), batch.parameters.end());
    const auto u = static_cast<double>(cageproof::unit_roundoff<R>());
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p) {
        const auto f = accurate<F, O>(s, convert<double>(batch.points[p]), parameters, batch.finite_part,
                                      std::numeric_limits<R>::max());
        const auto jet = narrowed<R>(f.jet);
        closed_form::put(jet, O, p, output);
        const double rounding = std::same_as<R, double> || f.worst() == 0 ? 0 : 2 * u, worst = f.worst() + rounding;
        const double error = worst + share_of_spacing(jet, O);
        output.state(p, {.digits = error > 0 ? -std::log10(error) : std::numeric_limits<double>::quiet_NaN(),
                         .converged = worst <= 128 * u});
      }
    });
  }

  template <cageproof::Scalar R>
  static void plainly(const Batch<R>& batch, const BatchOutput<R>& output) {
    const Segment<R> s{batch.corners[0], batch.corners[1]};
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p)
        closed_form::put(plain<F, O, R>(s, batch.points[p], batch.parameters, batch.finite_part), O, p, output);
    });
  }

  RegisterEvaluation kept_, careful_, plain_;
};

}  // namespace cageproof::closed_form::segment
