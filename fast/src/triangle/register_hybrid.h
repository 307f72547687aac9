// SPDX-License-Identifier: MIT
// Enters a triangle formula's hybrid into the register.
#pragma once

#include "../algebra.h"

#include "cageproof/closed_form/joint.h"
#include "cageproof/closed_form/triangle/engine/shared_instances.h"
#include "cageproof/fast/triangle/hybrid.h"

namespace cageproof::fast::triangle {

/// What hybrids on a triangle share: the corners, and at each point the moments in double. Multiprecision is the closed
/// form's.
struct SharedOnTriangle {
  template <Scalar R>
  struct Element {
    std::span<const Vec3<R>> given;
    Triangle<double> t;

    explicit Element(std::span<const Vec3<R>> corners) : given(corners) {
      if constexpr (!is_multiprecision<R>)
        for (int i = 0; i < 3; ++i) t[i] = convert<double>(corners[i]);
    }
  };
  template <Scalar R, int O>
  struct At {
    struct Nothing {};

    std::span<const Vec3<R>> corners;
    const Vec3<R>& given;
    std::conditional_t<is_multiprecision<R>, Nothing, Vec3<double>> eta{};
    std::optional<HybridMoments<O>> moments;

    At(const Element<R>& element, const Vec3<R>& point) : corners(element.given), given(point) {
      if constexpr (!is_multiprecision<R>) {
        eta = convert<double>(point);
        moments.emplace(element.t, eta);
      }
    }
  };
};

/// Puts a formula's tensors at a point.
template <class F>
struct PutHybrid {
  template <Scalar R, int O>
  static void put(SharedOnTriangle::At<R, O>& at, std::span<const R> parameters, bool finite_part, std::size_t point,
                  const BatchOutput<R>& output) {
    if constexpr (!is_multiprecision<R>) {
      const auto wide = closed_form::triangle::widened<F, R, double>(parameters);
      if (const auto found = hybrid<F, O>(*at.moments, wide); found.jet)
        return closed_form::put(closed_form::narrowed<R>(*found.jet), O, point, output);
    }
    Algebra<F>::put(at.corners, at.given, O, parameters, finite_part, point, output);
  }
};

template <class F>
inline constexpr closed_form::Member<SharedOnTriangle> member_of =
    closed_form::Member<SharedOnTriangle>::of<PutHybrid<F>>();

/// `const RegisterHybrid<F> register_<kernel>{"triangle.<kernel>"};` at namespace scope.
template <class F>
class RegisterHybrid {
 public:
  explicit RegisterHybrid(std::string_view formula)
      : family_(
            hybrid_family(formula, [](Evaluation& evaluation) { closed_form::set_member(evaluation, member_of<F>); })) {
    Algebra<F>::formula = formula;
  }

 private:
  RegisterEvaluation family_;
};

}  // namespace cageproof::fast::triangle
