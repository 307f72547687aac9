// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/coordinates.h"
#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/name_pattern.h"
#include "cageproof/core/unknown_name.h"
#include "cageproof/core/whole_evaluation.h"
#include "cageproof/deformation/constrained.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <iostream>

namespace cageproof::cli {
namespace {

using Json = nlohmann::ordered_json;

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
  for (const Parameter& p : f.parameters)
    parameters.push_back(
        {{"name", p.name}, {"default", p.preset}, {"lowest", p.lowest}, {"highest", p.highest}, {"whole", p.whole}});
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

// Checks that samples of elements are not asked one by one.
std::vector<std::string_view> other_checks() {
  std::vector<std::string_view> names = validation::promised_checks();
  std::erase_if(names, [](std::string_view name) { return validation::find_check(name) != nullptr; });
  return names;
}

// Of a kind that is no sum: as it has them in a cage of its dimension.
std::vector<CoordinateBlock> own_blocks(const CoordinateKind& kind) {
  return CageCoordinates(embedded_cage(kind.own_dimension == 2 ? "square" : "cube"), kind, {}).blocks();
}

// What computes a kind at once in a cage of space or of the plane.
std::vector<std::string_view> whole_evaluations_of(const CoordinateKind& kind) {
  std::vector<std::string_view> names;
  if (!kind.is_sum()) return names;
  for (const WholeEvaluation& evaluation : whole_evaluations())
    if (evaluation.exists(kind, embedded_cage("cube")) || evaluation.exists(kind, embedded_cage("square")))
      names.push_back(evaluation.name);
  return names;
}

Json parameter_json(const KindParameter& p) {
  Json parameter = {{"name", p.name}, {"default", p.preset}, {"lowest", p.lowest}, {"highest", p.highest}};
  if (!p.names.empty())
    parameter = {{"name", p.name}, {"default", p.names[static_cast<std::size_t>(p.preset)]}, {"names", p.names}};
  if (!p.meaning.empty()) parameter["meaning"] = p.meaning;
  return parameter;
}

Json catalogue_json() {
  Json all = {{"schema", "cageproof-catalogue"}, {"schema_version", 1}, {"formulas", Json::array()}};
  for (const Formula& f : catalogue()) all["formulas"].push_back(formula_json(f));
  for (const CoordinateKind& kind : coordinate_kinds()) {
    Json blocks = Json::array();
    for (const SummedBlock& b : kind.blocks) {
      blocks.push_back({{"label", b.label}, {"kernel", b.kernel}});
      if (b.one_a_corner) blocks.back()["one_a"] = name_of(Owner::Corner);
    }
    if (!kind.is_sum())
      for (const CoordinateBlock& b : own_blocks(kind))
        blocks.push_back({{"label", b.label}, {"one_a", name_of(b.owner)}});
    Json parameters = Json::array();
    for (const KindParameter& p : parameters_of(kind)) parameters.push_back(parameter_json(p));
    all["coordinates"].push_back(
        {{"name", kind.name}, {"source", kind.source}, {"blocks", blocks}, {"parameters", parameters}});
    all["coordinates"].back()["whole_evaluations"] = whole_evaluations_of(kind);
  }
  const auto add_deformer = [&](const auto& method, const std::vector<KindParameter>& known, const Json& taken) {
    Json parameters = Json::array();
    for (const KindParameter& p : known) parameters.push_back(parameter_json(p));
    Json& all_of_them = all["deformers"];
    all_of_them.push_back({{"name", method.name}, {"source", method.source}, {"keeps", method.keeps}});
    all_of_them.back().update(taken);
    all_of_them.back()["parameters"] = std::move(parameters);
  };
  for (const deformation::DeformMethod& method : deformation::deform_methods())
    add_deformer(method, deformation::parameters_of(method), {{"coordinates", method.kind}, {"takes", "posed cages"}});
  for (const deformation::ConstraintMethod& method : deformation::constraint_methods())
    add_deformer(method, method.parameters, {{"takes", method.positions_alone ? "positions" : "constraints"}});
  for (const auto& regime : validation::regimes())
    all["regimes"].push_back(
        {{"name", regime.name}, {"parameter", regime.parameter_name}, {"description", regime.description}});
  all["regimes"].push_back({{"name", validation::hull_regime},
                            {"parameter", ""},
                            {"description", "on and beside the convex hull of a twisted quad; hull_jump alone"}});
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
  return all;
}

std::vector<std::string_view> regime_names() {
  std::vector<std::string_view> names;
  for (const auto& regime : validation::regimes()) names.push_back(regime.name);
  names.insert(names.end(), {validation::hull_regime, validation::hunted_regime});
  return names;
}

void print_parameters(const std::vector<KindParameter>& parameters) {
  for (const KindParameter& p : parameters) {
    if (p.names.empty()) fmt::print(" {}={:g}", p.name, p.preset);
    if (p.names.empty()) continue;
    // The default first.
    std::vector<std::string_view> names = p.names;
    const auto preset = names.begin() + static_cast<std::ptrdiff_t>(p.preset);
    std::rotate(names.begin(), preset, preset + 1);
    fmt::print(" {}={}", p.name, fmt::join(names, "|"));
  }
}

// Whether what is printed of them has anything to show.
bool any_of(const auto& rows, const std::string& asked, auto name) {
  return std::ranges::any_of(rows, [&](const auto& row) { return matches(asked, name(row)); });
}

void print_names(const char* heading, const std::vector<std::string_view>& names, const std::string& asked) {
  if (!any_of(names, asked, std::identity())) return;
  fmt::print("{}:", heading);
  for (const std::string_view name : names)
    if (matches(asked, name)) fmt::print(" {}", name);
  fmt::print("\n");
}

void print_text(const std::string& asked) {
  const auto name_of_row = [](const auto& row) { return row.name; };
  for (const Formula& f : catalogue()) {
    if (!matches(asked, f.name)) continue;
    fmt::print("{}\n    {} = {}   ({})\n    evaluations:", f.name, f.symbol, f.definition, f.source);
    for (const EvaluationFamily* family : EvaluationRegister::instance().families(f.name))
      fmt::print(" {}", family->pattern);
    fmt::print("\n");
  }
  if (asked == "*") fmt::print("\n");
  const bool kinds = any_of(coordinate_kinds(), asked, name_of_row);
  if (kinds) fmt::print("coordinates:");
  for (const CoordinateKind& kind : coordinate_kinds()) {
    if (!matches(asked, kind.name)) continue;
    std::vector<std::string> labels;
    labels.reserve(kind.blocks.size());
    for (const SummedBlock& b : kind.blocks) labels.emplace_back(b.label);
    if (!kind.is_sum())
      for (const CoordinateBlock& b : own_blocks(kind)) labels.push_back(b.label);
    fmt::print(" {} ({}", kind.name, fmt::join(labels, ", "));
    for (const std::string_view evaluation : whole_evaluations_of(kind)) fmt::print("; {}", evaluation);
    fmt::print(")");
  }
  if (kinds) fmt::print("\n");
  if (any_of(deformation::deform_methods(), asked, name_of_row) ||
      any_of(deformation::constraint_methods(), asked, name_of_row))
    fmt::print("deformers:\n");
  for (const deformation::DeformMethod& method : deformation::deform_methods()) {
    if (!matches(asked, method.name)) continue;
    fmt::print("    {}", method.name);
    print_parameters(deformation::parameters_of(method));
    fmt::print("   ({}; keeps {})\n", method.source, method.keeps);
  }
  for (const deformation::ConstraintMethod& method : deformation::constraint_methods()) {
    if (!matches(asked, method.name)) continue;
    fmt::print("    {}", method.name);
    print_parameters(method.parameters);
    fmt::print("   ({}; by constraints; keeps {})\n", method.source, method.keeps);
  }
  print_names("regimes", regime_names(), asked);
  std::vector<std::string_view> checks = validation::check_names();
  for (const std::string_view name : other_checks()) checks.push_back(name);
  print_names("checks", checks, asked);
  print_names("embedded cages", embedded_cage_names(), asked);
  print_names("extreme cages", extreme_cage_names(), asked);
}

// Everything that has a name.
std::vector<std::string_view> all_names() {
  std::vector<std::string_view> all = regime_names();
  const auto add = [&](const std::vector<std::string_view>& names) {
    all.insert(all.end(), names.begin(), names.end());
  };
  for (const Formula& f : catalogue()) all.push_back(f.name);
  for (const CoordinateKind& kind : coordinate_kinds()) all.push_back(kind.name);
  for (const auto& method : deformation::deform_methods()) all.push_back(method.name);
  for (const auto& method : deformation::constraint_methods()) all.push_back(method.name);
  add(validation::check_names());
  add(other_checks());
  add(embedded_cage_names());
  add(extreme_cage_names());
  return all;
}

}  // namespace

void add_list(CommandLine& line) {
  Command command = line.command(
      "list", "the catalogue: formulas, sources, evaluations, kinds of coordinates, deformers, regimes, checks, cages");
  struct Arguments {
    std::string names = "*";
    bool json = false;
  };
  auto a = std::make_shared<Arguments>();
  const Option names =
      command.option("names", a->names, "what has such a name alone, names and globs with commas between; without, all")
          .taking("NAMES");
  command.flag("--json", a->json, "as JSON, with scalars, ranges and descriptions").excludes(names);
  command.example("cageproof list 'triangle.*'");
  command.example("cageproof list --json");
  command.runs([a] {
    require_known("name", a->names, all_names());
    if (a->json) std::cout << catalogue_json().dump(2) << '\n';
    else print_text(a->names);
    return success;
  });
}

}  // namespace cageproof::cli
