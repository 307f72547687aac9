// SPDX-License-Identifier: MIT
// The check that is a proof at each sample: the truth against a rigorous enclosure of the integral.
#include "checks/check_makers.h"

namespace cageproof::validation {
namespace {

/// The recommended evaluation in multiprecision, that is the truth, lies in the enclosure of the defining integral.
class EnclosureCheck final : public Check {
 public:
  std::string_view name() const override { return "enclosure"; }
  std::string_view unit() const override { return "of the radius"; }
  std::string_view description() const override {
    return "recommended evaluation in multiprecision: distance from the middle of a rigorous enclosure of the integral";
  }
  Use use() const override { return Use::Proof; }
  Cost cost(ScalarKind) const override { return Cost::Enclosure; }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view) const override {
    return stands_for_truth(evaluation) && scalar == ScalarKind::Digits100 &&
           EvaluationRegister::instance().with_role(formula.name, Role::Enclosure);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    const auto certified = EvaluationRegister::instance().with_role(in.formula.name, Role::Enclosure);
    const Result<Mp100> ball = evaluate<Mp100>(*certified, in.sample, in.order);
    const Result<Mp100>& closed = in.result<Mp100>();
    std::array<Finding, 3> findings;
    for (int o = 0; o <= in.order; ++o) {
      findings[o] = finding_for(in.truth, o);
      if (findings[o].status != Finding::Status::Measured) continue;
      if (!is_narrow(ball, o)) findings[o].status = Finding::Status::Declined;
      else findings[o].error = distance_over_radius(closed.of(o), ball, o, rounding_of(in.evaluation));
    }
    return findings;
  }

 private:
  // A wide ball holds whatever is asked of it.
  static bool is_narrow(const Result<Mp100>& ball, int order) {
    static const Mp100 width("1e-30");
    const Mp100 radius = norm(ball.radius_of(order));
    return isfinite(radius) && radius <= width * norm(ball.of(order));
  }

  // The closed form's rounding in 100 digits; sums over lines ask for 48 of them.
  static const Mp100& rounding_of(const Evaluation& evaluation) {
    static const Mp100 of_algebra("1e-60"), of_lines("1e-45");
    return evaluation.formula().element == ElementKind::Quad && evaluation.role() != Role::ClosedForm ? of_lines
                                                                                                      : of_algebra;
  }

  static double distance_over_radius(const std::vector<Mp100>& closed, const Result<Mp100>& ball, int order,
                                     const Mp100& rounding) {
    const Mp100 slack = rounding * norm(closed);
    double largest = 0;
    for (std::size_t i = 0; i < closed.size(); ++i) {
      const Mp100 distance = abs(Mp100(closed[i] - ball.of(order)[i])), radius = ball.radius_of(order)[i] + slack;
      if (distance == 0) continue;
      const Mp100 ratio = distance / radius;
      if (!isfinite(ratio)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, static_cast<double>(ratio));
    }
    return largest;
  }
};

}  // namespace

void add_enclosure_check(CheckList& list) { list.push_back(std::make_unique<EnclosureCheck>()); }

}  // namespace cageproof::validation
