// SPDX-License-Identifier: MIT
#include "summands.h"

#include "cageproof/core/input_error.h"

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

// The degree that the area element adds to quads' formulas that have none.
int degree_of_measure(const SummedBlock& spec, const Formula& formula) {
  return spec.one_a_normal && formula.by_parameters ? 2 : 0;
}

CoordinateBlock block_of(const CoordinateKind& kind, const SummedBlock& spec, const Formula& formula,
                         const CageElements& elements, std::span<const double> parameters) {
  const Owner owner = spec.one_a_normal           ? Owner::Normal
                      : !formula.shape.per_corner ? Owner::Element
                      : spec.one_a_corner         ? Owner::Corner
                                                  : Owner::Vertex;
  CoordinateBlock block{.label = std::string(spec.label),
                        .owner = owner,
                        .size = static_cast<int>(elements.count(owner)),
                        .shape = {false, formula.shape.rows, formula.shape.columns},
                        .reproduces = spec.reproduces};
  if (spec.normal_factor) block.normal_factor = spec.normal_factor(parameters, elements.dimension());
  // Normalised weights have no unit, and no Laplacian of their own.
  if (kind.normalised) return block;
  const Behaviour behaviour = formula.behaviour(parameters);
  block.degree = behaviour.degree + degree_of_measure(spec, formula);
  block.logarithmic = behaviour.logarithmic;
  if (formula.laplacian.kind == Laplacian::Kind::Zero) block.trace.kind = CoordinateBlock::Trace::Kind::Zero;
  if (formula.laplacian.kind != Laplacian::Kind::Formula) return block;
  for (std::size_t b = 0; b < kind.blocks.size(); ++b)
    if (find_formula(formula.element, kind.blocks[b].kernel)->name == formula.laplacian.formula)
      block.trace = {CoordinateBlock::Trace::Kind::Block, b};
  return block;
}

int largest_exponent(const std::vector<Vec3<double>>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest > 0 ? std::ilogb(largest) : 0;
}

}  // namespace

Summands::Summands(const CoordinateKind& kind, std::shared_ptr<const CageElements> of_cage,
                   const CoordinateOptions& options)
    : normalised(kind.normalised),
      elements(std::move(of_cage)),
      size_exponent(largest_exponent(elements->vertices())),
      parameters(options.parameters) {
  for (std::size_t e = 0; e < elements->count(); ++e) add_evaluations(kind, elements->type(e).kind, options.evaluation);
  const ElementKind first = elements->type(0).kind;
  for (const SummedBlock& spec : kind.blocks) {
    const Formula& formula = *find_formula(first, spec.kernel);
    blocks.push_back(block_of(kind, spec, formula, *elements, parameters));
    const Behaviour behaviour = formula.behaviour(parameters);
    degrees.push_back(behaviour.degree + degree_of_measure(spec, formula));
    homogeneous = homogeneous && behaviour.logarithmic.factor == 0;
    jumps.push_back(formula.shape.per_corner ? behaviour.face_jump.number : 0);
    has_area_elements = has_area_elements || (blocks.back().owner == Owner::Normal && has_quads());
  }
}

void Summands::add_evaluations(const CoordinateKind& kind, ElementKind element, const std::string& name) {
  ElementEvaluations& found = evaluations[static_cast<std::size_t>(element)];
  if (!found.empty()) return;
  auto& known = EvaluationRegister::instance();
  for (const SummedBlock& spec : kind.blocks) {
    const std::string_view formula = find_formula(element, spec.kernel)->name;
    auto evaluation = name.empty() ? known.with_role(formula, Role::Recommended) : known.find(formula, name);
    if (!evaluation && name.empty()) evaluation = known.with_role(formula, Role::Integral);
    // Triangles among quads are computed as the quads are where they can be. A name that quads do not know is no
    // evaluation of the kind, whether the cage has any or not.
    const bool companion = kind.keeps_quads && type_of(element).splits.empty();
    if (!evaluation && companion) {
      evaluation_named(find_formula(ElementKind::Quad, spec.kernel)->name, name);
      evaluation = known.with_role(formula, Role::Recommended);
    }
    found.push_back(evaluation ? std::move(*evaluation) : evaluation_named(formula, name));
    max_order = std::min(max_order, found.back().max_order());
  }
}

bool Summands::goes_beyond_range() const {
  return std::ranges::all_of(evaluations, [](const ElementEvaluations& of_kind) {
    return std::ranges::all_of(of_kind, [](const Evaluation& e) { return e.supports<Wide>(); });
  });
}

bool Summands::has_quads() const {
  for (std::size_t e = 0; e < elements->count(); ++e)
    if (!elements->type(e).flat) return true;
  return false;
}

}  // namespace cageproof
