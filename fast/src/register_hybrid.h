// SPDX-License-Identifier: MIT
// Enters a formula's hybrid into the register, whatever kind of element it is on.
#pragma once

#include "algebra.h"

#include "cageproof/closed_form/explain.h"

#include <cmath>
#include <concepts>

namespace cageproof::fast {

/// The parts that hybrids on one kind of element share: the corners, and the engine's view of them from a point, in
/// double.
template <class Engine>
struct SharedOn {
  template <Scalar R>
  struct Element {
    std::span<const Vec3<R>> given;
    typename Engine::Corners corners;

    explicit Element(std::span<const Vec3<R>> of)
        : given(of), corners(closed_form::corners_in<typename Engine::Corners>(of)) {}
  };
  template <Scalar R, int O>
  struct At {
    const Element<R>& element;
    const Vec3<R>& given;
    Vec3<double> point;
    typename Engine::template Seen<O> seen;

    At(const Element<R>& on, const Vec3<R>& at)
        : element(on), given(at), point(convert<double>(at)), seen(on.corners, point) {}
  };
};

/// Whether all entries are finite.
template <class R, int C, int D>
bool is_finite(const closed_form::Jet<R, C, D>& jet) {
  for (int c = 0; c < C; ++c)
    if (!std::isfinite(jet.value[c]) || !jet.gradient[c].allFinite() || !jet.hessian[c].allFinite()) return false;
  return true;
}

/// Puts the tensors of the form F at a point.
template <class Engine, class F>
struct PutHybrid {
  template <Scalar R, int O>
  static void put(typename SharedOn<Engine>::template At<R, O>& at, std::span<const R> parameters, bool finite_part,
                  std::size_t point, const BatchOutput<R>& output) {
    const closed_form::ParametersIn<double> wide(parameters);
    if (const auto jet = Engine::template jet<F, O>(at.seen, wide.all(), finite_part)) {
      const auto narrow = closed_form::narrowed<R>(*jet);
      // Where some entries overflow in float, the tolerance of double's norm says nothing of the others.
      if (std::same_as<R, double> || is_finite(narrow)) return closed_form::put(narrow, O, point, output);
    }
    Algebra<F>::put(at.element.given, at.given, O, parameters, finite_part, point, output);
  }
};

/// \tparam Engine of the element's kind: `Corners` in double, an array of them; `Seen<O>`, made of these and a point;
///   `jet<F, O>(seen, parameters, finite_part)`, none where the algebra is to be taken;
///   `explain<F, O>(query, values, entry)`, an Explanation of the tensor of order O
template <class Engine, class F>
class RegisterHybridOn {
 public:
  explicit RegisterHybridOn(std::string_view formula)
      : family_(hybrid_family(formula, [](Evaluation& evaluation) { set_hybrid<F>(evaluation, kMember); })),
        explainer_(formula, "hybrid", &closed_form::explain_on<Engine, F>) {
    Algebra<F>::formula = formula;
  }

 private:
  static constexpr auto kMember =
      closed_form::Member<SharedOn<Engine>>::template of<PutHybrid<Engine, F>, float, double>();

  RegisterEvaluation family_;
  closed_form::RegisterExplainer explainer_;
};

}  // namespace cageproof::fast
