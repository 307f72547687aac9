// SPDX-License-Identifier: MIT
// The closed form that a hybrid falls back on, where double loses too much or has no limit to give.
#pragma once

#include "cageproof/closed_form/joint.h"

#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::fast {

/// The hybrid of the formula whose closed form is F.
template <class F>
struct Algebra {
  static inline std::string_view formula;  ///< set as its hybrid is registered

  static const Evaluation& closed_form() {
    static const Evaluation found = evaluation_named(formula, "closed_form");
    return found;
  }

  /// Puts the closed form's tensors at a point. \param index of the point in the output
  template <Scalar R>
  static void put(std::span<const Vec3<R>> corners, const Vec3<R>& point, int order, std::span<const R> parameters,
                  bool finite_part, std::size_t index, BatchOutput<R> output) {
    for (int o = 0; o <= order; ++o) output.tensors[o] += index * output.stride[o];
    output.statements = nullptr;
    closed_form()(Batch<R>{corners, std::span(&point, 1), order, parameters, finite_part}, output);
  }
};

/// Hybrids in multiprecision compute their closed forms, jointly.
template <Scalar R>
class JointAlgebra final : public JointForm<R> {
 public:
  using ClosedForm = const Evaluation& (*)();
  explicit JointAlgebra(ClosedForm closed_form) : closed_form_(closed_form) {}
  void together(std::span<const JointForm<R>* const> hybrids, const Batch<R>& batch,
                std::span<const BatchOutput<R>> outputs) const override {
    std::vector<const Evaluation*> members;
    members.reserve(hybrids.size());
    for (const JointForm<R>* hybrid : hybrids)
      members.push_back(&static_cast<const JointAlgebra*>(hybrid)->closed_form_());
    Evaluation::together<R>(members, batch, outputs);
  }

 private:
  ClosedForm closed_form_;
};

/// Gives a hybrid its functions: float's and double's are the member's, multiprecision's those of the closed form.
template <class F, class Shared>
void set_hybrid(Evaluation& evaluation, const closed_form::Member<Shared>& member) {
  closed_form::set_member<float, double>(evaluation, member);
  const auto set = [&]<Scalar R>() {
    evaluation.set_batch<R>(
        [](const Batch<R>& batch, const BatchOutput<R>& output) { Algebra<F>::closed_form()(batch, output); });
    evaluation.set_joint<R>(std::make_shared<JointAlgebra<R>>(&Algebra<F>::closed_form));
  };
  set.template operator()<Mp50>();
  set.template operator()<Mp100>();
  set.template operator()<Mp200>();
}

/// The family of a hybrid. \param fill sets its functions in all scalars
inline EvaluationFamily hybrid_family(std::string_view formula, std::function<void(Evaluation&)> fill) {
  return single_family(formula, "hybrid",
                       {.description = "closed form nearby, Gauss points far away: the quickest that keeps its promise",
                        .role = Role::Recommended,
                        .cost = CostClass::Direct},
                       true, std::move(fill));
}

}  // namespace cageproof::fast
