// SPDX-License-Identifier: MIT
// Properties that relate an evaluation to itself elsewhere, or to another formula.
#include "checks/check_makers.h"

#include "element/element_sampling.h"
#include "sampling/generic_direction.h"
#include "truth/required_limits.h"

#include <algorithm>

namespace cageproof::validation {
namespace {

Mp100 norm_of(const std::vector<Mp200>& tensor) { return norm(std::vector<Mp100>(tensor.begin(), tensor.end())); }

/// The trace of the Hessian: zero for harmonic formulas, another formula's value for biharmonic ones.
class LaplacianCheck final : public Check {
 public:
  std::string_view name() const override { return "laplacian"; }
  Orders orders() const override { return {2, 2}; }
  std::string_view description() const override {
    return "trace of the Hessian: zero (harmonic) or the harmonic partner";
  }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return formula.laplacian.kind != Laplacian::Kind::Unknown && evaluation.max_order() >= 2 &&
           scalar == ScalarKind::Double && truth_is_promised(formula, evaluation, scalar, regime);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    if (in.order < 2) return findings;
    findings[2] = relation_finding_for(in.truth, 2);
    if (findings[2].status != Finding::Status::Measured) return findings;
    const Result<double>& f = in.results.of<double>(in.evaluation, 2);
    std::vector<double> expected(f.value.size(), 0.0), trace;
    if (in.formula.laplacian.kind == Laplacian::Kind::LowerOrder && in.sample.parameters.back() > 1) {
      Sample lower = in.sample;
      lower.parameters.back() -= 1;
      expected = evaluate<double>(in.evaluation, lower, 0).value;
    }
    if (in.formula.laplacian.kind == Laplacian::Kind::Formula) {
      const auto partner = partner_of(in.formula, in.evaluation);
      if (!partner) {
        findings[2].status = Finding::Status::Unasked;
        return findings;
      }
      expected = in.results.of<double>(*partner, 0).value;
    }
    const std::size_t dim = in.formula.dim();
    for (std::size_t c = 0; c < f.value.size(); ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < dim; ++i) sum += f.hessian[(c * dim + i) * dim + i];
      trace.push_back(sum);
    }
    findings[2].error = ratio_of_difference(trace, expected, Mp100(roundoff_of(in.scalar) * in.truth.conditioned[2]));
    return findings;
  }

 private:
  // The partner formula by the evaluation of that name, or its recommended one; nothing where it has neither in double.
  static std::optional<Evaluation> partner_of(const Formula& formula, const Evaluation& evaluation) {
    auto& known = EvaluationRegister::instance();
    auto partner = known.find(formula.laplacian.formula, evaluation.name());
    if (!partner) partner = known.with_role(formula.laplacian.formula, Role::Recommended);
    if (!partner || !partner->supports<double>()) return std::nullopt;
    return partner;
  }
};

/// An element's value is the sum over its parts.
class SubdivisionCheck final : public Check {
 public:
  std::string_view name() const override { return "subdivision"; }
  Cost cost(ScalarKind) const override { return Cost::Truths; }
  std::string_view description() const override { return "the sum over the parts at the edges' midpoints"; }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return scalar == ScalarKind::Double && regime == "generic" &&
           truth_is_promised(formula, evaluation, scalar, regime);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    const Result<double>& whole = in.result<double>();
    Result<double> sum;
    sum.reset(in.formula.components(), in.formula.dim(), in.order);
    const TruthSource source = truth_source(in.formula);
    std::array<Mp100, 3> yardstick = in.truth.conditioned;
    std::array<bool, 3> exists = in.truth.exists, required = in.truth.required;
    const auto parts = type_of(in.formula.element).parts;
    // Parameters are shared equally by the parts.
    const double share = in.formula.by_parameters ? 1.0 / static_cast<double>(parts.size()) : 1;
    for (const ElementPart& part : parts) {
      Sample sub = in.sample;
      for (int j = 0; j < in.formula.corners(); ++j) {
        sub.corners[j].setZero();
        for (int k = 0; k < in.formula.corners(); ++k)
          if (part[j][k] != 0) sub.corners[j] += part[j][k] * in.sample.corners[k];
      }
      const Truth truth = truth_from(source, sub, in.order);
      const Result<double> f = evaluate<double>(in.evaluation, sub, in.order);
      for (int o = 0; o <= in.order; ++o) {
        yardstick[o] += share * truth.conditioned[o];
        exists[o] = exists[o] && truth.exists[o];
        required[o] = required[o] && truth.required[o];
        add_part(in.formula, part, share, f.of(o), sum.of(o));
      }
    }
    std::array<Finding, 3> findings;
    for (int o = 0; o <= in.order; ++o) {
      findings[o].status = exists[o]     ? Finding::Status::Measured
                           : required[o] ? Finding::Status::Unreached
                                         : Finding::Status::NoTruth;
      if (exists[o])
        findings[o].error = ratio_of_difference(sum.of(o), whole.of(o), Mp100(roundoff_of(in.scalar) * yardstick[o]));
    }
    return findings;
  }

 private:
  static void add_part(const Formula& formula, const ElementPart& part, double share, const std::vector<double>& f,
                       std::vector<double>& sum) {
    if (!formula.shape.per_corner) {
      for (std::size_t i = 0; i < f.size(); ++i) sum[i] += share * f[i];
      return;
    }
    const std::size_t corners = formula.corners(), block = f.size() / corners;
    for (std::size_t k = 0; k < corners; ++k)
      for (std::size_t j = 0; j < corners; ++j)
        for (std::size_t i = 0; i < block; ++i) sum[k * block + i] += share * part[j][k] * f[j * block + i];
  }
};

/// Gradient and Hessian along a direction against central differences of value and gradient, in 200 digits.
class DifferencesCheck final : public Check {
 public:
  std::string_view name() const override { return "gradient_by_differences"; }
  Orders orders() const override { return {1, 2}; }
  std::string_view unit() const override { return "relative"; }
  std::string_view description() const override {
    return "derivatives along a direction against central differences, in 200 digits";
  }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return stands_for_truth(evaluation) && scalar == ScalarKind::Digits200 && !regime.starts_with("on-") &&
           regime != "tiny";  // whose distances are far below any step that 200 digits leave room for
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    const Result<Mp200>& f = in.result<Mp200>();
    // Far below every distance of a regime, far above the rounding of 200 digits.
    const Mp200 step = Mp200(longest_edge<double>(in.sample.corners)) * Mp200("1e-40");
    // One direction that no symmetry knows tells as much of a tensor as all axes do, from a third of the evaluations.
    const int dim = in.formula.dim();
    const auto direction = generic_direction<Mp200>(in.sample.point, dim);
    const auto moved = [&](const Mp200& by) {
      QueryOf<Mp200> input(in.sample, in.order - 1);
      for (int i = 0; i < dim; ++i) input.coordinate(input.point_vertex(), i) += by * direction[i];
      Result<Mp200> result;
      in.evaluation(input.query(), result);
      return result;
    };
    const Result<Mp200> plus = moved(step), minus = moved(-step);
    std::array<Finding, 3> findings;
    for (int o = 1; o <= in.order; ++o) {
      findings[o] = finding_for(in.truth, o);
      if (findings[o].status != Finding::Status::Measured) continue;
      // A derivative that vanishes is measured by the order below it, over the longest edge.
      const Mp100 own = norm_of(f.of(o));
      const Mp100 size = own > 0 ? own : Mp100(norm_of(f.of(o - 1)) / Mp100(longest_edge<double>(in.sample.corners)));
      std::vector<Mp200> differences;
      differences.reserve(plus.of(o - 1).size());
      for (std::size_t k = 0; k < plus.of(o - 1).size(); ++k)
        differences.push_back((plus.of(o - 1)[k] - minus.of(o - 1)[k]) / (2 * step));
      if (size == 0 && !is_input(in.formula, in.sample)) findings[o].status = Finding::Status::NoTruth;
      else findings[o].error = ratio_of_difference(differences, along(direction, f.of(o), dim), size);
    }
    return findings;
  }
};

/// The value just inside a face minus just outside it.
class FaceJumpCheck final : public Check {
 public:
  std::string_view name() const override { return "face_jump"; }
  Orders orders() const override { return {0, 0}; }
  std::string_view unit() const override { return "relative"; }
  std::string_view description() const override {
    return "value just inside minus just outside the face, in 100 digits";
  }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return stands_for_truth(evaluation) && scalar == ScalarKind::Digits100 && regime == "on-face" &&
           !formula.face_jump.diverges;
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    if (!in.truth.on_element) {
      findings[0].status = Finding::Status::NoTruth;
      return findings;
    }
    std::vector<Vec3<Mp100>> corners;
    corners.reserve(in.sample.corners.size());
    for (const auto& corner : in.sample.corners) corners.push_back(convert<Mp100>(corner));
    const Vec3<Mp100> p = convert<Mp100>(in.sample.point);
    const ExactShape& shape = sampling_of(in.formula.element).exact;
    const std::array<Mp100, 4> basis = shape.basis(in.sample.corners, in.sample.point);
    Vec3<Mp100> n = shape.normal(corners, basis);
    n /= sqrt(n.dot(n));
    const Mp100 step = Mp100(longest_edge<double>(in.sample.corners)) * Mp100("1e-40");
    const std::vector<Mp100> parameters(in.sample.parameters.begin(), in.sample.parameters.end());
    const auto at = [&](const Mp100& height) {
      const Vec3<Mp100> point = p + height * n;
      Result<Mp100> result;
      in.evaluation(Query<Mp100>{corners, point, 0, parameters}, result);
      return result.value;
    };
    const std::vector<Mp100> inside = at(-step), outside = at(step);
    const Behaviour behaviour = in.formula.behaviour(in.sample.parameters);
    std::vector<Mp100> jump(inside.size()), expected(inside.size(), Mp100(0));
    const std::size_t columns = in.formula.shape.columns, entries = columns * in.formula.shape.rows;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      jump[i] = inside[i] - outside[i];
      if (i % entries % (columns + 1) != 0) continue;  // off the diagonal
      expected[i] = behaviour.face_jump.number + behaviour.face_jump.pi_multiple * pi<Mp100>();
      if (!in.formula.shape.per_corner) continue;
      expected[i] *= basis[i / entries];
    }
    findings[0].status = Finding::Status::Measured;
    // Values that vanish on the face can be compared only with the element's size.
    const Mp100 natural = pow(Mp100(longest_edge<double>(in.sample.corners)), behaviour.degree);
    findings[0].error = ratio_of_difference(jump, expected, Mp100(natural + norm(expected)));
    return findings;
  }
};

}  // namespace

void add_identity_checks(CheckList& list) {
  list.push_back(std::make_unique<LaplacianCheck>());
  list.push_back(std::make_unique<SubdivisionCheck>());
  list.push_back(std::make_unique<DifferencesCheck>());
  list.push_back(std::make_unique<FaceJumpCheck>());
}

}  // namespace cageproof::validation
