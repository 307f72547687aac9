// SPDX-License-Identifier: MIT
// The check that counts digits: conditioned units forgive what rounding the input may change, which next to an edge is
// everything.
#include "checks/check_makers.h"

#include "cageproof/quadrature_ref/norm_integral.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// A derivative of that order this small counts as zero: a thousandth of the integral of the kernel's norm, divided by
// the distance to the furthest corner for every derivative.
Mp100 next_to_nothing(const Formula& formula, const Sample& sample, int order) {
  double furthest = 0;
  for (const Vec3<double>& corner : sample.corners) furthest = std::max(furthest, (corner - sample.point).stableNorm());
  Mp100 floor = quadrature_ref::norm_integral(
      formula, {.corners = sample.corners, .point = sample.point, .parameters = sample.parameters});
  for (int o = 0; o < order; ++o) floor /= furthest;
  return isfinite(floor) ? Mp100(floor / 1000) : Mp100(0);
}

/// The error that is left of an evaluation's digits, whatever the conditioning.
class DigitsCheck final : public Check {
 public:
  std::string_view name() const override { return "digits"; }
  std::string_view unit() const override { return "units of u"; }
  std::string_view description() const override {
    return "relative error, norm-wise, in units of rounding; where the truth is next to zero, relative to a thousandth "
           "of the integral of the kernel's norm";
  }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar, std::string_view) const override {
    return scalar == ScalarKind::Double &&
           (is_recommended(evaluation) || evaluation.role() == cageproof::Role::ClosedForm);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    if (!is_finite(in.sample)) return without_truth(in.order);
    const Result<double>& f = in.result<double>();
    std::array<Finding, 3> findings;
    for (int o = 0; o <= in.order; ++o) {
      findings[o] = finding_for(in.truth, o);
      if (findings[o].status != Finding::Status::Measured) continue;
      findings[o].relative = relative_error(f, in.truth, o);
      double error = findings[o].relative;
      // Beside a larger truth the floor changes nothing, and below this it would change no verdict.
      if (error > 64 * u) error = relative_error(f, in.truth, o, next_to_nothing(in.formula, in.sample, o));
      findings[o].error = error / u;
      findings[o].entry = furthest_entry(f, in.truth, o);
      findings[o].found = f.of(o)[static_cast<std::size_t>(findings[o].entry)];
    }
    return findings;
  }

 private:
  static constexpr double u = 0x1p-53;
};

}  // namespace

void add_digits_check(CheckList& list) { list.push_back(std::make_unique<DigitsCheck>()); }

}  // namespace cageproof::validation
