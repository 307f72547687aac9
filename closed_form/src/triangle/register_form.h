// SPDX-License-Identifier: MIT
// Enters a triangle formula's two evaluations into the register.
#pragma once

#include "../register.h"
#include "shared_instances.h"

namespace cageproof::closed_form {

template <class F>
class RegisterForm {
 public:
  explicit RegisterForm(const std::string& formula)
      : fast_(triangle_family(formula, "closed_form", "edge form; Gauss points far away",
                              []<Scalar R>(const Triangle<R>& t, const Query<R>& q) { return fast<R>(t, q); })),
        careful_(accurate_family(formula)) {}

 private:
  template <Scalar R>
  static Jet<R, F::components> fast(const Triangle<R>& t, const Query<R>& q) {
    if (q.order == 0) return closed_form<F, 0, R>(t, q.point, q.parameters, q.finite_part);
    if (q.order == 1) return closed_form<F, 1, R>(t, q.point, q.parameters, q.finite_part);
    return closed_form<F, 2, R>(t, q.point, q.parameters, q.finite_part);
  }
  static void careful(const Query<double>& q, Result<double>& result) {
    const Triangle<double> t{q.corners[0], q.corners[1], q.corners[2]};
    const AccurateJet<F::components> f = q.order == 0   ? accurate<F, 0>(t, q.point, q.parameters, q.finite_part)
                                         : q.order == 1 ? accurate<F, 1>(t, q.point, q.parameters, q.finite_part)
                                                        : accurate<F, 2>(t, q.point, q.parameters, q.finite_part);
    store(f.jet, q.order, result);
    result.stated_digits = f.worst() > 0 ? -std::log10(f.worst()) : std::numeric_limits<double>::quiet_NaN();
    result.converged = f.worst() <= accurate_tolerance;
  }
  static EvaluationFamily accurate_family(const std::string& formula) {
    const auto make = [formula](std::string_view asked) -> std::optional<Evaluation> {
      if (asked != "accurate") return std::nullopt;
      Evaluation evaluation(formula, "accurate", "edge form that bounds its own error, in as many digits as that takes");
      evaluation.set_states_error();
      evaluation.set<double>(careful);
      return evaluation;
    };
    return {formula, "accurate", {"accurate"}, make};
  }

  RegisterEvaluation fast_, careful_;
};

}  // namespace cageproof::closed_form
