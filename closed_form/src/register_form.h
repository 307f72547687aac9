// SPDX-License-Identifier: MIT
// Enters a closed form's evaluations into the register, whatever kind of element it is on.
#pragma once

#include "families.h"

#include "cageproof/closed_form/arithmetic/bounded_jet.h"
#include "cageproof/closed_form/arithmetic/spacing.h"
#include "cageproof/closed_form/explain.h"

#include <cmath>

namespace cageproof::closed_form {

/// The scalar that a result in R is computed from.
template <Scalar R>
using Given = std::conditional_t<is_multiprecision<R>, Mp200, double>;

/// The parts that closed forms on one kind of element share: the corners, and the engine's view of them from a point.
template <class Engine>
struct SharedOn {
  template <Scalar R>
  struct Element {
    typename Engine::template Corners<Given<R>> corners;
    explicit Element(std::span<const Vec3<R>> given)
        : corners(corners_in<typename Engine::template Corners<Given<R>>>(given)) {}
  };
  template <Scalar R, int O>
  struct At {
    Vec3<Given<R>> point;
    typename Engine::template Seen<R, O> seen;
    At(const Element<R>& element, const Vec3<R>& given)
        : point(convert<Given<R>>(given)), seen(element.corners, point) {}
  };
};

/// Puts the tensors of the form F at a point.
template <class Engine, class F>
struct PutForm {
  template <Scalar R, int O>
  static void put(typename SharedOn<Engine>::template At<R, O>& at, std::span<const R> parameters, bool finite_part,
                  std::size_t point, const BatchOutput<R>& output) {
    const ParametersIn<Given<R>> given(parameters);
    if constexpr (is_multiprecision<R>) {
      const auto found = bounded_form<F, O>(at.seen, given.all(), finite_part, std::numeric_limits<R>::digits10);
      closed_form::put(narrowed<R>(found.jet), O, point, output);
    } else {
      constexpr double largest = std::numeric_limits<R>::max();
      const auto found = bounded_form<F, O>(at.seen, given.all(), finite_part, kTolerance, largest);
      closed_form::put(narrowed<R>(found.jet), O, point, output);
    }
  }
};

/// \param formula lives as long as the program
/// \tparam Engine of the element's kind:
///   `kAlgebra`, the closed form in words; `Corners<R>`, an array of them;
///   `Seen<R, O>`, made of corners and a point, from which `bounded_form<F, O>` finds a jet with a bound;
///   `plain<F, O, R>(corners, point, parameters, finite_part)`;
///   `explain<F, O>(query, values, entry)`, an Explanation of the tensor of order O;
///   `StatedIn`, the scalars that its `accurate` is for
template <class Engine, class F>
class RegisterFormOn {
 public:
  explicit RegisterFormOn(std::string_view formula)
      : kept_(closed_form_family(
            formula, Engine::kAlgebra,
            [](Evaluation& evaluation) { set_member<float, double, Mp50, Mp100, Mp200>(evaluation, kMember); })),
        careful_(accurate_family(formula,
                                 [](Evaluation& evaluation) {
                                   Engine::StatedIn::each([&]<Scalar R>() { evaluation.set_batch<R>(careful<R>); });
                                 })),
        plain_(plain_family(formula,
                            [](Evaluation& evaluation) {
                              evaluation.set_batch<float>(plainly<float>);
                              evaluation.set_batch<double>(plainly<double>);
                            })),
        explainer_(formula, "closed_form", &explain_on<Engine, F>) {}

 private:
  using Shared = SharedOn<Engine>;
  static constexpr auto kMember = Member<Shared>::template of<PutForm<Engine, F>, float, double, Mp50, Mp100, Mp200>();

  // The evaluation `accurate`. In float it is double's, rounded.
  template <Scalar R>
  static void careful(const Batch<R>& batch, const BatchOutput<R>& output) {
    const typename Shared::template Element<R> element(batch.corners);
    const ParametersIn<double> given(batch.parameters);
    const auto u = static_cast<double>(unit_roundoff<R>());
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p) {
        typename Shared::template At<R, O> at(element, batch.points[p]);
        const auto f = bounded_form<F, O>(at.seen, given.all(), batch.finite_part, kAccurateTolerance,
                                          std::numeric_limits<R>::max());
        const auto jet = narrowed<R>(f.jet);
        closed_form::put(jet, O, p, output);
        const double rounding = std::same_as<R, double> || f.worst() == 0 ? 0 : 2 * u, worst = f.worst() + rounding;
        const double error = worst + share_of_spacing(jet, f.bound, O);
        output.state(p, {.digits = error > 0 ? -std::log10(error) : std::numeric_limits<double>::quiet_NaN(),
                         .converged = worst <= 128 * u});
      }
    });
  }

  template <Scalar R>
  static void plainly(const Batch<R>& batch, const BatchOutput<R>& output) {
    const auto corners = corners_in<typename Engine::template Corners<R>>(batch.corners);
    with_order(batch.order, [&]<int O>() {
      for (std::size_t p = 0; p < batch.points.size(); ++p)
        closed_form::put(Engine::template plain<F, O, R>(corners, batch.points[p], batch.parameters, batch.finite_part),
                         O, p, output);
    });
  }

  RegisterEvaluation kept_, careful_, plain_;
  RegisterExplainer explainer_;
};

}  // namespace cageproof::closed_form
