// SPDX-License-Identifier: MIT
#include "whole_coordinates.h"

#include <cmath>

namespace cageproof::benchmarks {
namespace {

// What a whole evaluation leaves to sums by recommended evaluations. Prepared coordinates are hidden in
// CageCoordinates, which answer the same questions.
class Sums : public CoordinatesIn<Sums> {
 public:
  explicit Sums(CageCoordinates coordinates) : coordinates_(std::move(coordinates)) {}
  const std::vector<CoordinateBlock>& blocks() const override { return coordinates_.blocks(); }
  int max_order() const override { return coordinates_.max_order(); }
  std::string evaluation() const override { return coordinates_.evaluation(); }
  bool is_exact_in(ScalarKind scalar) const override { return coordinates_.is_exact_in(scalar); }
  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    auto made = coordinates_.at<R>(points, order);
    for (std::size_t b = 0; b < tables.size(); ++b)
      for (int o = 0; o <= order; ++o) std::ranges::copy(made[b].tensors[o], tables[b].tensors[o].begin());
  }

 private:
  CageCoordinates coordinates_;
};

CoordinateOptions options_of(const CoordinateKind& kind) {
  CoordinateOptions options;
  for (const KindParameter& p : parameters_of(kind)) options.parameters.push_back(p.preset);
  return options;
}

CoordinateOptions options_of(const CoordinateKind& kind, const std::string& evaluation) {
  CoordinateOptions options = options_of(kind);
  options.evaluation = evaluation;
  return options;
}

// Of an element's corners, wherever they are; its length is that of the segment or twice the area.
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

WholeCoordinates::WholeCoordinates(const Cage& cage, const CoordinateKind& kind, const TimedEvaluation& evaluation)
    : coordinates_(cage, kind, options_of(kind, evaluation.name)) {
  if (!evaluation.whole) return;
  auto elements = std::make_shared<const CageElements>(cage, kind.keeps_quads, Triangulation::Shortest);
  prepared_ = find_whole_evaluation(evaluation.name)
                  ->prepare(kind, std::move(elements), options_of(kind, evaluation.name),
                            std::make_shared<const Sums>(CageCoordinates(cage, kind, options_of(kind))));
}

std::vector<CoordinateTable<double>> WholeCoordinates::tables_for(std::size_t points, int order) const {
  std::vector<CoordinateTable<double>> tables;
  if (!prepared_) return tables;
  tables.resize(coordinates_.blocks().size());
  for (std::size_t b = 0; b < tables.size(); ++b)
    for (int o = 0; o <= order; ++o) {
      const CoordinateBlock& block = coordinates_.blocks()[b];
      tables[b].stride[o] =
          static_cast<std::size_t>(block.size) * block.entries() * derivative_count(coordinates_.dimension(), o);
      tables[b].tensors[o].assign(points * tables[b].stride[o], 0.0);
    }
  return tables;
}

void WholeCoordinates::fill(std::span<const Vec3<double>> points, int order,
                            std::vector<CoordinateTable<double>>& tables) const {
  if (prepared_) prepared_->fill(points, order, tables);
  else tables = coordinates_.at<double>(points, order);
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
