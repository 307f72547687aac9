// SPDX-License-Identifier: MIT
// Checks the closed form on the element itself, where it has limits and infinities of either sign.
#include "checks/check_makers.h"

#include "element/element_sampling.h"

#include <algorithm>

namespace cageproof::validation {
namespace {

/// The closed form on the element against itself next to it, on the inner side: the integral proves it there, and no
/// rule about the border has a part in it. Finite entries must be what is approached; infinite ones must grow with
/// their sign. Entries without a limit are not asked for.
class LimitCheck final : public Check {
 public:
  std::string_view name() const override { return "limit"; }
  std::string_view unit() const override { return "relative"; }
  std::string_view description() const override {
    return "closed form on the element against itself 1e-60 sizes inside, in 200 digits: finite entries, and the signs "
           "of infinite ones";
  }
  Cost cost(ScalarKind) const override { return Cost::Truths; }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return stands_for_truth(evaluation) && scalar == ScalarKind::Digits200 && regime.starts_with("on-");
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    if (!in.truth.on_element) return findings;
    const Result<Mp200>& on = in.result<Mp200>();
    // Next to the element as many digits as the bound asks, where more take longer.
    const std::string& digits = in.evaluation.substitutes().confirmations;
    const Evaluation form = digits.empty() ? in.evaluation : evaluation_named(in.formula.name, digits);
    const Result<Mp200> farther = inside(in, form, Mp200("1e-40")), nearer = inside(in, form, Mp200("1e-60"));
    for (int o = 0; o <= in.order; ++o) {
      const auto no_limit = [](const Mp200& x) { return static_cast<bool>(isnan(x)); };
      if (std::ranges::all_of(on.of(o), no_limit)) {
        findings[o].status = in.truth.required[o] ? Finding::Status::Unreached : Finding::Status::NoTruth;
        continue;
      }
      findings[o].status = Finding::Status::Measured;
      const Mp200 natural =
          pow(Mp200(longest_edge<double>(in.sample.corners)), in.formula.behaviour(in.sample.parameters).degree - o);
      findings[o].error = error_of(on.of(o), farther.of(o), nearer.of(o), natural);
    }
    return findings;
  }

 private:
  // The tensors a little below the point, in sizes of the element.
  static Result<Mp200> inside(const CheckInput& in, const Evaluation& form, const Mp200& depth) {
    QueryOf<Mp200> input(in.sample, in.order);
    const ExactShape& shape = sampling_of(in.formula.element).exact;
    std::vector<Vec3<Mp100>> corners;
    corners.reserve(in.sample.corners.size());
    for (const Vec3<double>& corner : in.sample.corners) corners.push_back(convert<Mp100>(corner));
    const Vec3<Mp200> normal = convert<Mp200>(shape.normal(corners, shape.basis(in.sample.corners, in.sample.point)));
    const Mp200 length = sqrt(normal.dot(normal)), step = depth * longest_edge<double>(in.sample.corners) / length;
    for (int axis = 0; axis < in.formula.dim(); ++axis)
      input.coordinate(input.point_vertex(), axis) -= step * normal[axis];
    Result<Mp200> result;
    form(input.query(), result);
    return result;
  }

  // Finite entries change only in their last digits between the two depths, divergent ones as much as a logarithm.
  static double error_of(const std::vector<Mp200>& on, const std::vector<Mp200>& farther,
                         const std::vector<Mp200>& nearer, const Mp200& natural) {
    static const Mp200 seen("1e-12");
    Mp200 size = 0, error = 0, finite = 0;
    for (const Mp200& x : nearer) size += x * x;
    size = sqrt(size);
    for (std::size_t i = 0; i < on.size(); ++i) {
      if (isnan(on[i])) continue;
      const Mp200 growth = nearer[i] - farther[i];
      if (isinf(on[i])) {
        if (!((on[i] > 0 ? growth : Mp200(-growth)) > seen * size)) return std::numeric_limits<double>::infinity();
        continue;
      }
      error += (nearer[i] - on[i]) * (nearer[i] - on[i]);
      finite += on[i] * on[i];
    }
    // A limit may be zero, which leaves only the element's size to compare with.
    const Mp200 ratio = sqrt(error) / (sqrt(finite) + natural);
    return isfinite(ratio) ? static_cast<double>(ratio) : std::numeric_limits<double>::infinity();
  }
};

}  // namespace

void add_limit_check(CheckList& list) { list.push_back(std::make_unique<LimitCheck>()); }

}  // namespace cageproof::validation
