// SPDX-License-Identifier: MIT
// Properties that relate an evaluation to itself elsewhere, or to another formula.
#include "checks.h"

#include <algorithm>

namespace cageproof::validation {
namespace {

double longest_edge(const Sample& sample) {
  double longest = 0;
  const std::size_t n = sample.corners.size();
  for (std::size_t i = 0; i < n; ++i) longest = std::max(longest, (sample.corners[(i + 1) % n] - sample.corners[i]).norm());
  return longest;
}

Mp100 norm_of(const std::vector<Mp200>& tensor) {
  std::vector<Mp100> narrow;
  for (const Mp200& x : tensor) narrow.emplace_back(x);
  return norm(narrow);
}

/// The trace of the Hessian: zero for harmonic formulas, another formula's value for biharmonic ones.
class LaplacianCheck final : public Check {
 public:
  std::string_view name() const override { return "laplacian"; }
  std::string_view description() const override { return "trace of the Hessian: zero (harmonic) or the harmonic partner"; }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return formula.laplacian.kind != Laplacian::Kind::Unknown && evaluation.max_order() >= 2 &&
           scalar == ScalarKind::Double && truth_is_promised(formula, evaluation, scalar, regime);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    if (in.order < 2) return findings;
    findings[2] = finding_for(in.truth, 2);
    if (findings[2].status != Finding::Status::Measured) return findings;
    const Result<double> f = evaluate<double>(in.evaluation, in.sample, 2);
    std::vector<double> expected(f.value.size(), 0.0), trace;
    if (in.formula.laplacian.kind == Laplacian::Kind::Formula) {
      const auto partner = EvaluationRegister::instance().find(in.formula.laplacian.formula, in.evaluation.name());
      expected = evaluate<double>(*partner, in.sample, 0).value;
    }
    const std::size_t dim = in.formula.dim();
    for (std::size_t c = 0; c < f.value.size(); ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < dim; ++i) sum += f.hessian[(c * dim + i) * dim + i];
      trace.push_back(sum);
    }
    findings[2].error =
        ratio_of_difference(trace, expected, Mp100(roundoff_of(in.scalar) * in.truth.conditioned[2]));
    return findings;
  }
};

/// An element's value is the sum over its four parts.
class SubdivisionCheck final : public Check {
 public:
  std::string_view name() const override { return "subdivision"; }
  Cost cost(ScalarKind) const override { return Cost::Truths; }
  std::string_view description() const override { return "the sum over the four parts at the edges' midpoints"; }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return formula.element != ElementKind::Segment && scalar == ScalarKind::Double && regime == "generic" &&
           truth_is_promised(formula, evaluation, scalar, regime);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    const Result<double> whole = evaluate<double>(in.evaluation, in.sample, in.order);
    Result<double> sum;
    sum.reset(in.formula.components(), in.formula.dim(), in.order);
    const Evaluation reference = *EvaluationRegister::instance().find(in.formula.name, "closed_form");
    std::array<Mp100, 3> yardstick = in.truth.conditioned;
    std::array<bool, 3> exists = in.truth.exists;
    for (const Part& part : parts_of(in.formula.element)) {
      Sample sub = in.sample;
      for (int j = 0; j < in.formula.corners(); ++j) {
        sub.corners[j].setZero();
        for (int k = 0; k < in.formula.corners(); ++k)
          if (part[j][k] != 0) sub.corners[j] += part[j][k] * in.sample.corners[k];
      }
      const Truth truth = truth_from(reference, sub, in.order);
      const Result<double> f = evaluate<double>(in.evaluation, sub, in.order);
      for (int o = 0; o <= in.order; ++o) {
        yardstick[o] += truth.conditioned[o];
        exists[o] = exists[o] && truth.exists[o];
        add_part(in.formula, part, f.of(o), sum.of(o));
      }
    }
    std::array<Finding, 3> findings;
    for (int o = 0; o <= in.order; ++o) {
      findings[o].status = exists[o] ? Finding::Status::Measured : Finding::Status::NoTruth;
      if (exists[o])
        findings[o].error = ratio_of_difference(sum.of(o), whole.of(o), Mp100(roundoff_of(in.scalar) * yardstick[o]));
    }
    return findings;
  }

 private:
  // A part's corners in basis functions of the whole's; unused entries are zero.
  using Part = std::array<std::array<double, 4>, 4>;

  static const std::array<Part, 4>& parts_of(ElementKind element) {
    static constexpr std::array<double, 4> a{1, 0, 0, 0}, b{0, 1, 0, 0}, c{0, 0, 1, 0}, d{0, 0, 0, 1}, ab{.5, .5, 0, 0}, bc{0, .5, .5, 0},
        ca{.5, 0, .5, 0}, cd{0, 0, .5, .5}, da{.5, 0, 0, .5}, middle{.25, .25, .25, .25};
    static constexpr std::array<Part, 4> triangle{Part{a, ab, ca}, Part{ab, b, bc}, Part{ca, bc, c}, Part{ab, bc, ca}};
    static constexpr std::array<Part, 4> quad{Part{a, ab, middle, da}, Part{ab, b, bc, middle}, Part{middle, bc, c, cd}, Part{da, middle, cd, d}};
    return element == ElementKind::Quad ? quad : triangle;
  }
  static void add_part(const Formula& formula, const Part& part, const std::vector<double>& f, std::vector<double>& sum) {
    if (!formula.shape.per_corner) {
      for (std::size_t i = 0; i < f.size(); ++i) sum[i] += f[i];
      return;
    }
    const std::size_t corners = formula.corners(), block = f.size() / corners;
    for (std::size_t k = 0; k < corners; ++k)
      for (std::size_t j = 0; j < corners; ++j)
        for (std::size_t i = 0; i < block; ++i) sum[k * block + i] += part[j][k] * f[j * block + i];
  }
};

/// Gradient and Hessian against central differences of value and gradient, in 200 digits.
class DifferencesCheck final : public Check {
 public:
  std::string_view name() const override { return "gradient_by_differences"; }
  std::string_view unit() const override { return "relative"; }
  std::string_view description() const override { return "derivatives against central differences, in 200 digits"; }
  bool applies(const Formula&, const Evaluation& evaluation, ScalarKind scalar, std::string_view regime) const override {
    return evaluation.name() == "closed_form" && scalar == ScalarKind::Digits200 && !regime.starts_with("on-");
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    const Result<Mp200> f = evaluate<Mp200>(in.evaluation, in.sample, in.order);
    // Far below every distance of a regime, far above the rounding of 200 digits.
    const Mp200 step = Mp200(longest_edge(in.sample)) * Mp200("1e-40");
    Result<Mp200> plus, minus;
    Result<Mp200> differences;
    differences.reset(in.formula.components(), in.formula.dim(), in.order);
    const int dim = in.formula.dim();
    for (int i = 0; i < dim; ++i) {
      QueryOf<Mp200> input(in.sample, in.order - 1);
      Mp200& x = input.coordinate(input.coordinate_count() - 3 + i);
      const Mp200 original = x;
      x = original + step;
      in.evaluation(input.query(), plus);
      x = original - step;
      in.evaluation(input.query(), minus);
      for (int o = 1; o <= in.order; ++o)
        for (std::size_t k = 0; k < plus.of(o - 1).size(); ++k)
          differences.of(o)[k * dim + i] = (plus.of(o - 1)[k] - minus.of(o - 1)[k]) / (2 * step);
    }
    std::array<Finding, 3> findings;
    for (int o = 1; o <= in.order; ++o) {
      findings[o] = finding_for(in.truth, o);
      if (findings[o].status == Finding::Status::Measured)
        findings[o].error = ratio_of_difference(differences.of(o), f.of(o), norm_of(f.of(o)));
    }
    return findings;
  }
};

/// The value just inside a face minus just outside it.
class FaceJumpCheck final : public Check {
 public:
  std::string_view name() const override { return "face_jump"; }
  std::string_view unit() const override { return "relative"; }
  std::string_view description() const override { return "value just inside minus just outside the face, in 100 digits"; }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return evaluation.name() == "closed_form" && scalar == ScalarKind::Digits100 && regime == "on-face" &&
           !formula.face_jump.diverges;
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    if (!in.truth.on_element) {
      findings[0].status = Finding::Status::NoTruth;
      return findings;
    }
    std::array<Vec3<Mp100>, 3> t;
    for (int i = 0; i < 3; ++i) t[i] = convert<Mp100>(in.sample.corners[i]);
    const Vec3<Mp100> p = convert<Mp100>(in.sample.point);
    Vec3<Mp100> n = Vec3<Mp100>(t[1] - t[0]).cross(Vec3<Mp100>(t[2] - t[0]));
    const Mp100 area2 = sqrt(n.dot(n));
    n /= area2;
    const Mp100 step = Mp100(longest_edge(in.sample)) * Mp100("1e-40");
    const std::vector<Mp100> parameters(in.sample.parameters.begin(), in.sample.parameters.end());
    const auto at = [&](const Mp100& height) {
      const Vec3<Mp100> point = p + height * n;
      Result<Mp100> result;
      in.evaluation(Query<Mp100>{t, point, 0, parameters}, result);
      return result.value;
    };
    const std::vector<Mp100> inside = at(-step), outside = at(step);
    std::vector<Mp100> jump(inside.size()), expected(inside.size(), Mp100(0));
    const std::size_t columns = in.formula.shape.columns, entries = columns * in.formula.shape.rows;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      jump[i] = inside[i] - outside[i];
      if (i % entries % (columns + 1) != 0) continue;  // off the diagonal
      expected[i] = in.formula.face_jump.number + in.formula.face_jump.pi_multiple * pi<Mp100>();
      if (!in.formula.shape.per_corner) continue;
      const std::size_t k = i / entries;
      const Vec3<Mp100> a = t[(k + 1) % 3] - p, b = t[(k + 2) % 3] - p;
      expected[i] *= a.cross(b).dot(n) / area2;
    }
    findings[0].status = Finding::Status::Measured;
    // Values that vanish on the face have the element's size alone to be compared with.
    const Mp100 natural = pow(Mp100(longest_edge(in.sample)), in.formula.degree);
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
