// SPDX-License-Identifier: MIT
#include "catalogue_json.h"

#include "catalogue_names.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/field_words.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/core/coordinates/purposes.h"
#include "cageproof/deformation/constrained.h"
#include "cageproof/deformation/purposes.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"

#include <nlohmann/json.hpp>

namespace cageproof::cli {
namespace {

using Json = nlohmann::ordered_json;

// The range of a parameter, and which of its ends are in it.
Json range_json(const Parameter& p) {
  return {{"default", p.preset},
          {"lowest", p.lowest},
          {"lowest_included", p.allows(p.lowest)},
          {"highest", p.highest},
          {"highest_included", p.allows(p.highest)},
          {"infinity_included", p.includes_infinity}};
}

Json formula_json(const Formula& f) {
  Json evaluations = Json::array();
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(f.name)) {
    Json scalars = Json::array();
    const Evaluation example = family->example();
    for (const ScalarKind kind : scalar_kinds)
      if (example.supports(kind)) scalars.push_back(name_of(kind));
    evaluations.push_back({{"name", family->pattern},
                           {"range", range_of_pattern(family->pattern)},
                           {"standard", family->standard},
                           {"role", name_of(family->role)},
                           {"description", example.description()},
                           {"max_order", example.max_order()},
                           {"scalars", scalars}});
  }
  Json parameters = Json::array();
  for (const Parameter& p : f.parameters) {
    parameters.push_back({{"name", p.name}});
    parameters.back().update(range_json(p));
    parameters.back()["whole"] = p.whole;
  }
  return {{"name", f.name},
          {"symbol", f.symbol},
          {"source", f.source},
          {"definition", f.definition},
          {"element", name_of(f.element)},
          {"shape", {{"per_corner", f.shape.per_corner}, {"rows", f.shape.rows}, {"columns", f.shape.columns}}},
          {"degree", f.degree},
          {"parameters", parameters},
          {"evaluations", evaluations}};
}

Json parameter_json(const KindParameter& p) {
  Json parameter = {{"name", p.name}};
  parameter.update(range_json(p));
  if (!p.names.empty())
    parameter = {{"name", p.name}, {"default", p.names[static_cast<std::size_t>(p.preset)]}, {"names", p.names}};
  if (!p.meaning.empty()) parameter["meaning"] = p.meaning;
  return parameter;
}

}  // namespace

std::string catalogue_json() {
  Json all = {{"schema", "cageproof-catalogue"}, {"schema_version", 1}, {"formulas", Json::array()}};
  for (const Formula& f : catalogue()) all["formulas"].push_back(formula_json(f));
  for (const CoordinateKind& kind : coordinate_kinds()) {
    Json blocks = Json::array();
    for (const SummedBlock& b : kind.blocks) {
      blocks.push_back({{"label", b.label}, {"kernel", b.kernel}});
      if (b.one_a_corner) blocks.back()["one_a"] = name_of(Owner::Corner);
      if (b.one_a_normal) blocks.back()["one_a"] = name_of(Owner::Normal);
    }
    if (!kind.is_sum())
      for (const CoordinateBlock& b : own_blocks(kind))
        blocks.push_back({{"label", b.label}, {"one_a", name_of(b.owner)}});
    Json parameters = Json::array();
    for (const KindParameter& p : parameters_of(kind)) parameters.push_back(parameter_json(p));
    all["coordinates"].push_back({{"name", kind.name},
                                  {"source", kind.source},
                                  {"good_for", purpose_of_kind(kind.name)},
                                  {"blocks", blocks},
                                  {"parameters", parameters}});
    all["coordinates"].back()["whole_evaluations"] = whole_evaluations_of(kind);
  }
  const auto add_deformer = [&](const auto& method, const std::vector<KindParameter>& known, const Json& taken) {
    Json parameters = Json::array();
    for (const KindParameter& p : known) parameters.push_back(parameter_json(p));
    Json& all_of_them = all["deformers"];
    all_of_them.push_back({{"name", method.name}, {"source", method.source}, {"keeps", method.keeps}});
    all_of_them.back().update(taken);
    all_of_them.back()["parameters"] = std::move(parameters);
    all_of_them.back()["good_for"] = deformation::purpose_of_method(method.name);
  };
  for (const deformation::DeformMethod& method : deformation::deform_methods())
    add_deformer(method, deformation::parameters_of(method),
                 {{"coordinates", method.kind},
                  {"keeps_quads", coordinate_kind_named(method.kind).keeps_quads},
                  {"takes", "posed cages"}});
  for (const deformation::ConstraintMethod& method : deformation::constraint_methods())
    add_deformer(method, method.parameters, {{"takes", method.positions_alone ? "positions" : "constraints"}});
  for (const auto& regime : validation::regimes())
    all["regimes"].push_back(
        {{"name", regime.name}, {"parameter", regime.parameter_name}, {"description", regime.description}});
  all["regimes"].push_back({{"name", validation::hull_regime},
                            {"parameter", ""},
                            {"description", "on and near the convex hull of a twisted quad; only for hull_jump"}});
  all["regimes"].push_back({{"name", validation::hunted_regime},
                            {"parameter", ""},
                            {"description", "the stored worst cases, measured again in every run"}});
  for (const auto& check : validation::checks())
    all["checks"].push_back({{"name", check->name()}, {"unit", check->unit()}, {"description", check->description()}});
  for (const std::string_view name : other_checks())
    all["checks"].push_back({{"name", name},
                             {"unit", ""},
                             {"description", "of whole cages, their elements and deformers; docs/errors.md"}});
  for (const auto name : embedded_cage_names()) all["cages"].push_back(name);
  for (const auto name : extreme_cage_names()) all["extreme_cages"].push_back(name);
  for (const FieldWord& word : field_words()) {
    all["words"].push_back({{"word", word.word}, {"here", word.here}});
    if (!word.missing.empty()) all["words"].back()["missing"] = word.missing;
  }
  return all.dump(2) + '\n';
}

}  // namespace cageproof::cli
