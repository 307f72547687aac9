// SPDX-License-Identifier: MIT
// Enters a triangle formula's hybrid into the register.
#pragma once

#include "../algebra.h"

#include "cageproof/closed_form/joint.h"
#include "cageproof/closed_form/triangle/engine/shared_instances.h"
#include "cageproof/fast/triangle/hybrid.h"

namespace cageproof::fast::triangle {

/// What hybrids on a triangle share: the corners, and at each point the moments in double.
struct SharedOnTriangle {
  template <Scalar R>
  struct Element {
    std::span<const Vec3<R>> given;
    Triangle<double> t;

    explicit Element(std::span<const Vec3<R>> corners)
        : given(corners), t{convert<double>(corners[0]), convert<double>(corners[1]), convert<double>(corners[2])} {}
  };
  template <Scalar R, int O>
  struct At {
    std::span<const Vec3<R>> corners;
    const Vec3<R>& given;
    Vec3<double> eta;
    HybridMoments<O> moments;

    At(const Element<R>& element, const Vec3<R>& point)
        : corners(element.given), given(point), eta(convert<double>(point)), moments(element.t, eta) {}
  };
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutHybrid {
  template <Scalar R, int O>
  static void put(SharedOnTriangle::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    const auto wide = closed_form::triangle::widened<F, R, double>(parameters);
    if (const auto found = hybrid<F, O>(at.moments, wide); found.jet)
      return closed_form::put(closed_form::narrowed<R>(*found.jet), O, point, output);
    Algebra<F>::put(at.corners, at.given, O, parameters, finite_part, point, output);
  }
};

template <class F>
inline constexpr auto member_of = closed_form::Member<SharedOnTriangle>::of<PutHybrid<F>, float, double>();

/// `const RegisterHybrid<F> register_<kernel>{"triangle.<kernel>"};` at namespace scope.
template <class F>
class RegisterHybrid {
 public:
  explicit RegisterHybrid(std::string_view formula)
      : family_(hybrid_family(formula, [](Evaluation& evaluation) { set_hybrid<F>(evaluation, member_of<F>); })) {
    Algebra<F>::formula = formula;
  }

 private:
  RegisterEvaluation family_;
};

}  // namespace cageproof::fast::triangle
