// SPDX-License-Identifier: MIT
// Properties under a change of the input that changes the result in a known way.
#include "checks.h"

#include <algorithm>
#include <cmath>

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
    const Result<double> plain = evaluate<double>(in.evaluation, in.sample, in.order);
    const Result<double> changed = evaluate<double>(in.evaluation, change(in.sample), in.order);
    const Mp100 u = roundoff_of(in.scalar);
    std::array<Finding, 3> findings;
    for (int o = 0; o <= in.order; ++o) {
      findings[o] = finding_for(in.truth, o);
      if (in.truth.on_element && !keeps_side()) findings[o].status = Finding::Status::Unasked;
      if (findings[o].status == Finding::Status::Measured)
        findings[o].error = ratio_of_difference(undo(in, changed.of(o), o), plain.of(o),
                                                Mp100(u * in.truth.conditioned[o]));
    }
    return findings;
  }

 protected:
  /// Whether a limit from inside remains one.
  virtual bool keeps_side() const { return true; }
  virtual Sample change(Sample sample) const = 0;
  /// The tensor of derivative order `order` as it would be without the change.
  virtual Values undo(const CheckInput& in, Values tensor, int order) const = 0;
};

class Scaling final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "scaling"; }
  std::string_view description() const override { return "f(s element, s point) = s^degree f, s = 2^20 or 2^-20; a power of two, so that the changed input is exact"; }

 private:
  Sample change(Sample sample) const override {
    const double factor = std::ldexp(1.0, exponent(sample));
    for (auto& corner : sample.corners) corner *= factor;
    sample.point *= factor;
    return sample;
  }
  // Towards one, so that nothing overflows that did not before.
  static int exponent(const Sample& sample) { return sample.corners[1].norm() + sample.point.norm() > 1 ? -20 : 20; }
  Values undo(const CheckInput& in, Values tensor, int order) const override {
    for (double& x : tensor) x = std::ldexp(x, -exponent(in.sample) * (in.formula.degree - order));
    return tensor;
  }
};

class CornerPermutation final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "corner_permutation"; }
  std::string_view description() const override { return "starting at the next corner changes nothing but the corners' order"; }

 private:
  Sample change(Sample sample) const override {
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
  std::string_view description() const override { return "reversing the element's orientation changes the sign, or nothing"; }

 private:
  bool keeps_side() const override { return false; }
  Sample change(Sample sample) const override {
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

/// A rotation that permutes the axes with signs, so that the changed input is exact.
class RigidMotion final : public SymmetryCheck {
 public:
  std::string_view name() const override { return "rigid_motion"; }
  std::string_view description() const override { return "turning element and point turns the tensors"; }

 private:
  // (x, y, z) -> (y, -z, -x): new axis i takes old axis source[i] with sign[i]; determinant one.
  static constexpr std::array<int, 3> source{1, 2, 0};
  static constexpr std::array<double, 3> sign{1, -1, -1};

  static Vec3<double> turn(const Vec3<double>& v) {
    return {sign[0] * v[source[0]], sign[1] * v[source[1]], sign[2] * v[source[2]]};
  }
  Sample change(Sample sample) const override {
    for (auto& corner : sample.corners) corner = turn(corner);
    sample.point = turn(sample.point);
    return sample;
  }
  Values undo(const CheckInput& in, Values tensor, int order) const override {
    const Formula& formula = in.formula;
    // Every index that runs over space turns: the derivatives', and the rows and columns of tensor formulas.
    const int dims = (formula.shape.rows == 3) + (formula.shape.columns == 3) + order;
    std::size_t span = 1;
    for (int i = 0; i < dims; ++i) span *= 3;
    Values plain(tensor.size());
    for (std::size_t at = 0; at < tensor.size(); ++at) {
      std::size_t target = 0, rest = at % span, weight = 1;
      double factor = 1;
      for (int i = 0; i < dims; ++i, rest /= 3, weight *= 3) {
        target += weight * source[rest % 3];
        factor *= sign[rest % 3];
      }
      plain[at - at % span + target] = factor * tensor[at];
    }
    return plain;
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
