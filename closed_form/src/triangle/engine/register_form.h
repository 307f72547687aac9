// SPDX-License-Identifier: MIT
// Enters a triangle formula's evaluations into the register.
#pragma once

#include "cageproof/closed_form/arithmetic/spacing.h"
#include "cageproof/closed_form/joint.h"
#include "../../families.h"
#include "cageproof/closed_form/triangle/engine/plain.h"
#include "cageproof/closed_form/triangle/engine/shared_instances.h"

#include <cmath>

namespace cageproof::closed_form::triangle {

/// What closed forms on a triangle share: the corners, and at each point the moments, in double or in multiprecision.
struct SharedOnTriangle {
  template <Scalar R>
  using Wide = std::conditional_t<is_multiprecision<R>, Mp200, double>;

  template <Scalar R>
  struct Element {
    Triangle<Wide<R>> t;
    explicit Element(std::span<const Vec3<R>> corners)
        : t{convert<Wide<R>>(corners[0]), convert<Wide<R>>(corners[1]), convert<Wide<R>>(corners[2])} {}
  };
  template <Scalar R, int O>
  struct At {
    Vec3<Wide<R>> eta;
    std::conditional_t<is_multiprecision<R>, WideMoments<O>, PointMoments<O>> moments;
    At(const Element<R>& element, const Vec3<R>& point) : eta(convert<Wide<R>>(point)), moments(element.t, eta) {}
  };
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutForm {
  template <Scalar R, int O>
  static void put(SharedOnTriangle::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    using W = SharedOnTriangle::Wide<R>;
    const auto wide = widened<F, R, W>(parameters);
    const std::span<const W> given(wide);
    if constexpr (is_multiprecision<R>) {
      const auto found = bounded_form<F, O>(at.moments, given, finite_part, std::numeric_limits<R>::digits10);
      closed_form::put(narrowed<R>(found.jet), O, point, output);
    } else {
      constexpr double largest = std::numeric_limits<R>::max();
      closed_form::put(narrowed<R>(bounded_form<F, O>(at.moments, given, finite_part, kTolerance, largest).jet), O,
                       point, output);
    }
  }
};

template <class F>
inline constexpr auto member_of = Member<SharedOnTriangle>::of<PutForm<F>, float, double, Mp50, Mp100, Mp200>();

/// `const RegisterForm<F> register_<kernel>{"triangle.<kernel>"};` at namespace scope.
template <class F>
class RegisterForm {
 public:
  explicit RegisterForm(std::string_view formula)
      : kept_(closed_form_family(
            formula, "edge form, in as many digits as its promise takes",
            [](Evaluation& evaluation) { set_member<float, double, Mp50, Mp100, Mp200>(evaluation, member_of<F>); })),
        careful_(accurate_family(formula, [](Evaluation& evaluation) { evaluation.set_batch<double>(careful); })),
        plain_(plain_family(formula, [](Evaluation& evaluation) {
          evaluation.set_batch<float>(plainly<float>);
          evaluation.set_batch<double>(plainly<double>);
        })) {}

 private:
  static void careful(const Batch<double>& batch, const BatchOutput<double>& output) {
    const Triangle<double> t{batch.corners[0], batch.corners[1], batch.corners[2]};
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p) {
        const auto f = accurate<F, O>(t, batch.points[p], batch.parameters, batch.finite_part);
        closed_form::put(f.jet, O, p, output);
        const double error = f.worst() + share_of_spacing(f.jet, O);
        output.state(p, {.digits = error > 0 ? -std::log10(error) : std::numeric_limits<double>::quiet_NaN(),
                         .converged = f.worst() <= kAccurateTolerance});
      }
    });
  }

  template <Scalar R>
  static void plainly(const Batch<R>& batch, const BatchOutput<R>& output) {
    const Triangle<R> t{batch.corners[0], batch.corners[1], batch.corners[2]};
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p)
        closed_form::put(plain<F, O, R>(t, batch.points[p], batch.parameters, batch.finite_part), O, p, output);
    });
  }

  RegisterEvaluation kept_, careful_, plain_;
};

}  // namespace cageproof::closed_form::triangle
