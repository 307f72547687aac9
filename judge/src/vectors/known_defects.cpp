// SPDX-License-Identifier: MIT
// Deliberately wrong forms. A vector is kept when one of them fails at it.
#include "cageproof/judge/vectors.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <cmath>
#include <numbers>

namespace cageproof::judge {
namespace {

using validation::Sample;
using Wrong = std::optional<Result<double>>;

// Absolute cut-off, as it is found in published code: the result depends on the unit of length.
constexpr double cutoff = 1e-6;

Vec3<double> normal_of(const Sample& s) {
  const Vec3<double> along = s.corners[1] - s.corners[0];
  return s.corners.size() == 2 ? Vec3<double>(along[1], -along[0], 0)
                               : Vec3<double>(along.cross(s.corners[2] - s.corners[0]));
}

bool is_flat(const Formula& formula) { return formula.element != ElementKind::Quad; }

Wrong evaluated(const Formula& formula, std::string_view name, const Sample& sample, int order) {
  const auto evaluation = EvaluationRegister::instance().find(formula.name, name);
  if (!evaluation || !evaluation->supports<double>() || evaluation->max_order() < order) return {};
  return validation::evaluate<double>(*evaluation, sample, order);
}

Wrong right(const Formula& formula, const Sample& sample, int order) {
  const auto evaluation = EvaluationRegister::instance().with_role(formula.name, Role::Recommended);
  if (!evaluation || evaluation->max_order() < order) return {};
  return validation::evaluate<double>(*evaluation, sample, order);
}

Wrong plain(const Formula& formula, const Sample& sample, int order) {
  return evaluated(formula, "plain", sample, order);
}

Wrong fixed_rule(const Formula& formula, const Sample& sample, int order) {
  return evaluated(formula, "gauss-16", sample, order);
}

Wrong height_threshold(const Formula& formula, const Sample& sample, int order) {
  if (!is_flat(formula)) return {};
  const Vec3<double> n = normal_of(sample).normalized();
  const double height = n.dot(sample.point - sample.corners[0]);
  if (!(std::abs(height) < cutoff) || height == 0) return {};
  Sample moved = sample;
  moved.point -= height * n;
  return right(formula, moved, order);
}

Wrong corner_threshold(const Formula& formula, const Sample& sample, int order) {
  for (const auto& corner : sample.corners) {
    const double distance = (sample.point - corner).norm();
    if (!(distance < cutoff) || distance == 0) continue;
    Sample moved = sample;
    moved.point = corner;
    return right(formula, moved, order);
  }
  return {};
}

Wrong size_threshold(const Formula& formula, const Sample& sample, int order) {
  if (!is_flat(formula) || !(normal_of(sample).norm() < cutoff)) return {};
  Wrong wrong = right(formula, sample, order);
  if (!wrong) return {};
  for (int o = 0; o <= order; ++o)
    for (auto* tensor : {&wrong->value, &wrong->gradient, &wrong->hessian}) std::ranges::fill(*tensor, 0.);
  return wrong;
}

// Half the jump everywhere in the element's plane: 2 pi of the solid angle.
Wrong half_in_plane(const Formula& formula, const Sample& sample, int order) {
  if (!is_flat(formula) || !formula.vanishes_in_plane || formula.behaviour_of || formula.face_jump.diverges ||
      formula.shape.entries() != 1 || formula.shape.per_corner)
    return {};
  const Vec3<double> n = normal_of(sample).normalized();
  const Vec3<double> to = sample.point - sample.corners[0];
  if (!(std::abs(n.dot(to)) <= 1e-14 * to.norm())) return {};
  Wrong wrong = right(formula, sample, order);
  if (wrong) wrong->value.assign(1, (formula.face_jump.number + formula.face_jump.pi_multiple * std::numbers::pi) / 2);
  return wrong;
}

// The single layer of a triangle with log((R + d) / (R - d)), R the sum of the distances to a side's ends, d its
// length.
Wrong logarithm_at_edge(const Formula& formula, const Sample& s, int order) {
  if (formula.name != "triangle.single_layer" || order != 0) return {};
  const Vec3<double> n = normal_of(s).normalized();
  double sum = 0, angle = 0;
  std::array<Vec3<double>, 3> x;
  for (int k = 0; k < 3; ++k) x[k] = s.corners[k] - s.point;
  const double height = n.dot(x[0]);
  const double above = x[0].dot(x[1].cross(x[2]));
  const double a = x[0].norm(), b = x[1].norm(), c = x[2].norm();
  angle = 2 * std::atan2(above, a * b * c + x[0].dot(x[1]) * c + x[1].dot(x[2]) * a + x[2].dot(x[0]) * b);
  for (int k = 0; k < 3; ++k) {
    const Vec3<double> side = x[(k + 1) % 3] - x[k];
    const double d = side.norm(), both = x[k].norm() + x[(k + 1) % 3].norm();
    sum += (side / d).cross(n).dot(x[k]) * std::log((both + d) / (both - d));
  }
  Result<double> result;
  result.value.assign(1, (sum - height * angle) / (4 * std::numbers::pi));
  return result;
}

}  // namespace

const std::vector<KnownDefect>& known_defects() {
  static const std::vector<KnownDefect> defects{
      {"height-threshold", "points nearer than 1e-6 to the element's plane are projected into it", height_threshold},
      {"corner-threshold", "points nearer than 1e-6 to a corner are taken for it", corner_threshold},
      {"size-threshold", "elements with a normal shorter than 1e-6 count as nothing", size_threshold},
      {"half-in-plane", "half the jump everywhere in the element's plane: 2 pi for the solid angle", half_in_plane},
      {"logarithm-at-edge", "log((R+d)/(R-d)) cancels next to an edge", logarithm_at_edge},
      {"cancellation", "the closed form in plain double arithmetic: far, sliver and near-plane cancellation", plain},
      {"fixed-rule", "a fixed rule of 16 Gauss points a direction, too coarse near the element", fixed_rule},
  };
  return defects;
}

}  // namespace cageproof::judge
