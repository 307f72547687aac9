// SPDX-License-Identifier: MIT
// Enters a triangle formula's evaluations into the register.
#pragma once

#include "../../joint.h"
#include "../../plain_family.h"
#include "cageproof/closed_form/triangle/engine/plain.h"
#include "cageproof/closed_form/triangle/engine/shared_instances.h"

#include <cmath>

namespace cageproof::closed_form::triangle {

/// What closed forms on a triangle share: the corners, and at each point the frame and the moments, all in the scalar
/// that they compute in.
struct SharedOnTriangle {
  template <Scalar R>
  struct Element {
    Triangle<Working<R>> t;
    explicit Element(std::span<const Vec3<R>> corners)
        : t{convert<Working<R>>(corners[0]), convert<Working<R>>(corners[1]), convert<Working<R>>(corners[2])} {}
  };
  template <Scalar R, int O>
  struct At {
    Vec3<Working<R>> eta;
    PointMoments<Working<R>, O> moments;
    At(const Element<R>& element, const Vec3<R>& point) : eta(convert<Working<R>>(point)), moments(element.t, eta) {}
  };
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutForm {
  template <Scalar R, int O>
  static void put(SharedOnTriangle::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    using W = Working<R>;
    if constexpr (!std::same_as<R, W>) {
      const auto wide = widened<F>(parameters);
      closed_form::put(narrowed<R>(triangle::closed_form<F, O, W>(at.moments, wide, finite_part)), O, point, output);
    } else {
      closed_form::put(triangle::closed_form<F, O, R>(at.moments, parameters, finite_part), O, point, output);
    }
  }
};

template <class F>
inline constexpr Member<SharedOnTriangle> member_of = Member<SharedOnTriangle>::of<PutForm<F>>();

/// `const RegisterForm<F> register_<kernel>{"triangle.<kernel>"};` at namespace scope of the formula's .cpp.
template <class F>
class RegisterForm {
 public:
  explicit RegisterForm(std::string_view formula)
      : fast_(single_family(
            formula, "closed_form",
            {.description = "edge form; Gauss points far away", .role = Role::Recommended, .cost = CostClass::Direct},
            true, [](Evaluation& evaluation) { set_member(evaluation, member_of<F>); })),
        careful_(single_family(formula, "accurate",
                               {.description = "edge form that bounds its own error, in as many digits as that takes",
                                .role = Role::Stated,
                                .cost = CostClass::Direct,
                                .states_error = true},
                               true, [](Evaluation& evaluation) { evaluation.set_batch<double>(careful); })),
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
        output.state(p, {.digits = f.worst() > 0 ? -std::log10(f.worst()) : std::numeric_limits<double>::quiet_NaN(),
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

  RegisterEvaluation fast_, careful_, plain_;
};

}  // namespace cageproof::closed_form::triangle
