// SPDX-License-Identifier: MIT
// Properties under a change of the input that changes the result in a known way.
#include "checks/check_makers.h"

#include "element/element_sampling.h"
#include "truth/logarithmic_part.h"
#include "checks/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cageproof::validation {
namespace {

using Values = std::vector<double>;

/// Evaluates at a changed sample, undoes the change on the result, and compares with the result at the sample itself.
class SymmetryCheck : public Check {
 public:
  std::string_view unit() const override { return "conditioned"; }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return scalar == ScalarKind::Double && truth_is_promised(formula, evaluation, scalar, regime);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    const Result<double>& plain = in.result<double>();
    const Result<double> changed = evaluate<double>(in.evaluation, change(in.formula, in.sample), in.order);
    const Mp100 u = roundoff_of(in.scalar);
    std::array<Finding, 3> findings;
    for (int o = 0; o <= in.order; ++o) {
      findings[o] = relation_finding_for(in.truth, o);
      if (in.truth.on_element && !keeps_side()) findings[o].status = Finding::Status::Unasked;
      // Both results have all of a double's digits, or nothing can be told from them.
      const Mp100 &norm = in.truth.norm[o], changed_norm = norm * factor(in, o);
      if (!representable<double>(norm) || !representable<double>(changed_norm))
        findings[o].status = Finding::Status::NoTruth;
      if (findings[o].status != Finding::Status::Measured) continue;
      const Mp100 yardstick = in.truth.conditioned[o] + Mp100(added(in, o));
      findings[o].error = ratio_of_difference(undo(in, changed.of(o), o), plain.of(o), Mp100(u * yardstick));
    }
    return findings;
  }

 protected:
  /// Whether a limit from inside remains one.
  virtual bool keeps_side() const { return true; }
  virtual Sample change(const Formula& formula, Sample sample) const = 0;
  /// The tensor of derivative order `order` as it would be without the change.
  virtual Values undo(const CheckInput& in, Values tensor, int order) const = 0;
  /// By how much the change multiplies the tensor.
  virtual Mp100 factor(const CheckInput&, int) const { return 1; }
  /// Norm of the term that the change adds to the tensor; its rounding is not the evaluation's fault.
  virtual double added(const CheckInput&, int) const { return 0; }
};

class Scaling final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "scaling"; }
  std::string_view description() const override {
    return "f(s element, s point) = s^degree f, s = 2^20 or 2^-20; a power of two, so that the changed input is exact";
  }

 private:
  Sample change(const Formula&, Sample sample) const override {
    const double factor = std::ldexp(1.0, exponent(sample));
    for (auto& corner : sample.corners) corner *= factor;
    sample.point *= factor;
    return sample;
  }
  // Towards one, so that nothing overflows that did not before; but up where down would cost denormals their digits.
  static int exponent(const Sample& sample) {
    double smallest = 1;
    const auto look_at = [&](const Vec3<double>& v) {
      for (const double x : v)
        if (x != 0) smallest = std::min(smallest, std::abs(x));
    };
    for (const auto& corner : sample.corners) look_at(corner);
    look_at(sample.point);
    const bool down = sample.corners[1].norm() + sample.point.norm() > 1 && smallest > 0x1p-900;
    return down ? -20 : 20;
  }
  Mp100 factor(const CheckInput& in, int order) const override {
    return ldexp(Mp100(1), exponent(in.sample) * (behaviour(in).degree - order));
  }
  Values undo(const CheckInput& in, Values tensor, int order) const override {
    for (double& x : tensor) x = std::ldexp(x, -exponent(in.sample) * (behaviour(in).degree - order));
    if (behaviour(in).logarithmic.factor == 0) return tensor;
    const Values added = logarithm(in, order);
    for (std::size_t i = 0; i < tensor.size(); ++i) tensor[i] -= added[i];
    return tensor;
  }
  double added(const CheckInput& in, int order) const override {
    double size = 0;
    if (behaviour(in).logarithmic.factor != 0)
      for (const double x : logarithm(in, order)) size = std::hypot(size, x);
    return size;
  }
  static Behaviour behaviour(const CheckInput& in) { return in.formula.behaviour(in.sample.parameters); }
  // The term that scaling adds to kernels with the logarithm of the distance, over s^(degree - order).
  static Values logarithm(const CheckInput& in, int order) {
    const Formula& formula = in.formula;
    const Logarithm logarithm = behaviour(in).logarithmic;
    Values part = logarithmic_part(logarithm, formula.shape, in.sample.corners, in.sample.point, order);
    for (double& x : part) x *= exponent(in.sample) * std::numbers::ln2;
    return part;
  }
};

class CornerPermutation final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "corner_permutation"; }
  std::string_view description() const override {
    return "starting at the next corner changes nothing but the corners' order";
  }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return sampling_of(formula.element).cyclic && SymmetryCheck::applies(formula, evaluation, scalar, regime);
  }

 private:
  Sample change(const Formula&, Sample sample) const override {
    std::ranges::rotate(sample.corners, sample.corners.begin() + 1);
    return sample;
  }
  Values undo(const CheckInput& in, Values tensor, int) const override {
    const Formula& formula = in.formula;
    if (!formula.shape.per_corner) return tensor;
    const auto block = static_cast<std::ptrdiff_t>(tensor.size()) / formula.corners();
    std::ranges::rotate(tensor, tensor.end() - block);
    return tensor;
  }
};

class OrientationFlip final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "orientation_flip"; }
  std::string_view description() const override {
    return "reversing the element's orientation changes the sign, or nothing";
  }

 private:
  bool keeps_side() const override { return false; }
  Sample change(const Formula&, Sample sample) const override {
    std::ranges::reverse(sample.corners);
    return sample;
  }
  Values undo(const CheckInput& in, Values tensor, int) const override {
    const Formula& formula = in.formula;
    for (double& x : tensor) x *= formula.flip_sign;
    if (!formula.shape.per_corner) return tensor;
    const std::size_t corners = formula.corners(), block = tensor.size() / corners;
    Values reversed(tensor.size());
    for (std::size_t c = 0; c < corners; ++c)
      std::copy_n(tensor.begin() + c * block, block, reversed.begin() + (corners - 1 - c) * block);
    return reversed;
  }
};

/// Turns element and point, in the plane within it.
class RigidMotion final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "rigid_motion"; }
  std::string_view description() const override { return "turning element and point turns the tensors"; }

 private:
  Sample change(const Formula& formula, Sample sample) const override {
    const Turn turn(formula.dim());
    for (auto& corner : sample.corners) corner = turn(corner);
    sample.point = turn(sample.point);
    return sample;
  }
  Values undo(const CheckInput& in, Values tensor, int order) const override {
    // Every index that runs over space turns: the derivatives', and the rows and columns of tensor formulas.
    return Turn(in.formula.dim()).undo(tensor, in.formula.shape.space_indices() + order);
  }
};

}  // namespace

void add_symmetry_checks(CheckList& list) {
  list.push_back(std::make_unique<Scaling>());
  list.push_back(std::make_unique<RigidMotion>());
  list.push_back(std::make_unique<CornerPermutation>());
  list.push_back(std::make_unique<OrientationFlip>());
}

}  // namespace cageproof::validation
