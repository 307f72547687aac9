// SPDX-License-Identifier: MIT
#include "whole_coordinates.h"

#include <cmath>

namespace cageproof::benchmarks {
namespace {

// Normal of an element at these vertices; its length is that of the segment or twice the area.
Vec3<double> extent_at(const CageElements& elements, std::size_t element, const std::vector<Vec3<double>>& vertices) {
  std::vector<Vec3<double>> corners;
  corners.reserve(4);
  for (const int v : elements.vertices_of(element)) corners.push_back(vertices[v]);
  return elements.type(element).extent(corners);
}

}  // namespace

std::vector<TimedEvaluation> timed_evaluations(const CoordinateKind& kind, const Cage& cage) {
  std::vector<TimedEvaluation> found;
  for (const WholeEvaluation& whole : whole_evaluations())
    if (whole.exists(kind, cage)) found.push_back({std::string(whole.name), true});
  const auto formulas = formulas_of(kind, cage);
  const auto& known = EvaluationRegister::instance();
  const std::string_view formula = formulas.back()->name;
  if (const auto recommended = known.with_role(formula, Role::Recommended))
    found.push_back({recommended->name(), false});
  if (!kind.keeps_quads) return found;
  for (const EvaluationFamily* family : known.families(formula)) {
    const bool direct = family->role == Role::Rule && family->example().cost() == CostClass::Direct;
    if (family->role != Role::Scheme && !direct) continue;
    for (const std::string& name : family->standard) found.push_back({name, false});
  }
  return found;
}

CageData data_of_pose(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& posed) {
  const CageElements& elements = coordinates.elements();
  CageData data;
  const bool matrices = coordinates.blocks().front().shape.columns > 1;
  data.sets = matrices ? 1 : elements.dimension();
  for (const CoordinateBlock& block : coordinates.blocks()) {
    auto& numbers = data.blocks.emplace_back();
    const double scale = block.reproduces == Reproduces::Nothing ? 0.1 : block.normal_factor;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.size); ++i) {
      Vec3<double> x;
      if (block.owner == Owner::Vertex) {
        x = posed[i];
      } else {
        const std::size_t element = elements.element_of(i, block.owner);
        const double before = extent_at(elements, element, elements.vertices()).norm();
        const Vec3<double> after = extent_at(elements, element, posed);
        x = after.normalized() * std::sqrt(after.norm() / before);
      }
      for (int c = 0; c < elements.dimension(); ++c) numbers.push_back(scale * x[c]);
    }
  }
  return data;
}

}  // namespace cageproof::benchmarks
