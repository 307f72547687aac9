// SPDX-License-Identifier: MIT
// Check of the sum of double and single layers of an element around its sides: the relation holds for each element, and
// catches a normal, a sheet or a side taken wrongly.
#include "checks/check_makers.h"

#include "element/element_sampling.h"

#include <cmath>
#include <span>

namespace cageproof::validation {
namespace {

// Beside a side, and far away, its integral is what is left of terms that cancel by powers of the distance.
using Wide = Mp800;

Mp100 length_of(const Vec3<Mp100>& v) { return sqrt(v.dot(v)); }

// The integral of r^power, power -1 or 1, along a side, over its length; the point is not on its line.
Wide mean_along(const Vec3<Wide>& from, const Vec3<Wide>& to, int power) {
  const auto length_of = [](const Vec3<Wide>& v) { return Wide(sqrt(Wide(v.dot(v)))); };
  const Vec3<Wide> side = to - from, area = from.cross(to);
  const Wide length = length_of(side), start = length_of(from), end = length_of(to);
  // Along the side from the foot of the perpendicular, whose squared length is `square`.
  const Wide first = from.dot(side) / length, last = to.dot(side) / length, square = area.dot(area) / (length * length);
  Wide logarithm;
  if (first < 0 && last > 0) logarithm = log(Wide((end + last) * (start - first) / square));
  else if (first >= 0) logarithm = log(Wide((end + last) / (start + first)));
  else logarithm = log(Wide((start - first) / (end - last)));
  if (power < 0) return logarithm / length;
  return (last * end - first * start + square * logarithm) / (2 * length);
}

// \param corners and the point, whose differences are exact
Vec3<Mp100> around_sides(const SideRelation& relation, std::span<const Vec3<double>> corners,
                         const Vec3<double>& point) {
  Vec3<Wide> sum = Vec3<Wide>::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3<Wide> from = corners[k].cast<Wide>() - point.cast<Wide>(),
                     to = corners[(k + 1) % corners.size()].cast<Wide>() - point.cast<Wide>();
    const Vec3<Wide> moment = from.cross(to);
    // Where the side's line passes through the point, whatever the integral is.
    if (moment[0] == 0 && moment[1] == 0 && moment[2] == 0) continue;
    sum += mean_along(from, to, relation.power) * moment;
  }
  Vec3<Mp100> rounded;
  for (int i = 0; i < 3; ++i) rounded[i] = Mp100(sum[i]) / Mp100(relation.weight * pi<Mp100>());
  return rounded;
}

// The vectors that the single layer's numbers are multiplied by; for a flat element its unit normal.
std::vector<Vec3<Mp100>> normals_of(const Formula& single, std::span<const Vec3<double>> corners) {
  std::vector<Vec3<Mp100>> normals;
  normals.reserve(single.tensors());
  const std::size_t count = corners.size();
  const auto side = [&](std::size_t from, std::size_t to) {
    return Vec3<Wide>(corners[to].cast<Wide>() - corners[from].cast<Wide>());
  };
  for (std::size_t k = 0; k < static_cast<std::size_t>(single.tensors()); ++k) {
    const Vec3<Wide> normal = side(k, (k + 1) % count).cross(side(k, (k + count - 1) % count));
    normals.emplace_back(Mp100(normal[0]), Mp100(normal[1]), Mp100(normal[2]));
  }
  if (!single.shape.per_corner) normals[0] /= length_of(normals[0]);
  return normals;
}

/// Sums of the products of numbers with vectors, and the root of the sum of squared lengths.
struct Moments {
  Vec3<Mp100> sum = Vec3<Mp100>::Zero();
  Mp100 size = 0;

  Moments(const std::vector<double>& numbers, const std::vector<Vec3<Mp100>>& vectors) {
    for (std::size_t k = 0; k < vectors.size(); ++k) {
      sum += Mp100(numbers[k]) * vectors[k];
      size += vectors[k].dot(vectors[k]);
    }
    size = sqrt(size);
  }
};

class SideRelationCheck final : public Check {
 public:
  std::string_view name() const override { return "side_relation"; }
  Orders orders() const override { return {0, 0}; }
  Cost cost(ScalarKind) const override { return Cost::Truths; }
  std::string_view description() const override {
    return "moments of the double layer and normals of the single layer against integrals along the sides";
  }
  bool applies(const Formula& formula, const Evaluation& evaluation, ScalarKind scalar,
               std::string_view regime) const override {
    return !formula.side_relation.single_layer.empty() && scalar == ScalarKind::Double &&
           EvaluationRegister::instance().find(formula.side_relation.single_layer, evaluation.name()).has_value() &&
           truth_is_promised(formula, evaluation, scalar, regime);
  }
  std::array<Finding, 3> measure(const CheckInput& in) const override {
    std::array<Finding, 3> findings;
    const SideRelation& relation = in.formula.side_relation;
    const auto single = EvaluationRegister::instance().find(relation.single_layer, in.evaluation.name());
    findings[0] = relation_finding_for(in.truth, 0);
    if (findings[0].status != Finding::Status::Measured) return findings;
    const Truth of_single = truth_from(truth_source(single->formula()), in.sample, 0);
    findings[0] = relation_finding_for(of_single, 0);
    if (findings[0].status != Finding::Status::Measured) return findings;
    std::vector<Vec3<Mp100>> x;
    x.reserve(in.sample.corners.size());
    const Vec3<Mp100> point = convert<Mp100>(in.sample.point);
    for (const Vec3<double>& corner : in.sample.corners) x.push_back(convert<Mp100>(corner) - point);
    const Moments positions(in.results.of<double>(in.evaluation, 0).value, x);
    const Moments normals(in.results.of<double>(*single, 0).value, normals_of(single->formula(), in.sample.corners));
    const Vec3<Mp100> sum = positions.sum + relation.factor * normals.sum,
                      expected = around_sides(relation, in.sample.corners, in.sample.point);
    const Mp100 unit =
        in.truth.conditioned[0] * positions.size + relation.factor * of_single.conditioned[0] * normals.size;
    findings[0].error = ratio_of_difference(std::vector<Mp100>{sum[0], sum[1], sum[2]},
                                            std::vector<Mp100>{expected[0], expected[1], expected[2]},
                                            Mp100(roundoff_of(in.scalar) * unit));
    return findings;
  }
};

}  // namespace

void add_side_relation_check(CheckList& list) { list.push_back(std::make_unique<SideRelationCheck>()); }

}  // namespace cageproof::validation
