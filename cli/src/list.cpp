// SPDX-License-Identifier: MIT
#include "catalogue_json.h"
#include "catalogue_names.h"
#include "commands.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/deformation/constrained.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/regime.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

namespace cageproof::cli {
namespace {

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

// The formulas and kinds that have an evaluation, each evaluation by the name that a list gives it.
std::map<std::string, std::vector<std::string_view>> evaluations_by_name() {
  std::map<std::string, std::vector<std::string_view>> all;
  for (const Formula& f : catalogue())
    for (const std::string_view name : evaluation_names(f.name)) all[std::string(name)].push_back(f.name);
  for (const CoordinateKind& kind : coordinate_kinds())
    for (const std::string_view name : whole_evaluations_of(kind)) all[std::string(name)].push_back(kind.name);
  return all;
}

// The list with its family in the place of each member that has a number of its own: gauss-9 is gauss-<N>.
std::string with_families(const std::string& asked, const std::vector<std::string>& known) {
  std::vector<std::string> names = names_in(asked);
  for (std::string& name : names) {
    if (std::ranges::find(known, name) != known.end()) continue;
    const bool exists = std::ranges::any_of(
        catalogue(), [&](const Formula& f) { return EvaluationRegister::instance().find(f.name, name).has_value(); });
    if (exists) name = family_of_number(name);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

// Where names are given; without any, each formula lists its own.
void print_evaluations(const std::string& asked) {
  const auto all = evaluations_by_name();
  for (const auto& [name, owners] : all) {
    if (!matches(asked, name)) continue;
    const std::string_view range = range_of_pattern(name);
    fmt::print("evaluation {}{}{} of: {}\n", name, range.empty() ? "" : ", ", range, fmt::join(owners, " "));
  }
}

// Everything that has a name.
std::vector<std::string> all_names() {
  std::vector<std::string> all;
  for (const auto& [name, owners] : evaluations_by_name()) all.push_back(name);
  const auto add = [&](const std::vector<std::string_view>& names) {
    all.insert(all.end(), names.begin(), names.end());
  };
  for (const Formula& f : catalogue()) all.emplace_back(f.name);
  for (const CoordinateKind& kind : coordinate_kinds()) all.emplace_back(kind.name);
  for (const auto& method : deformation::deform_methods()) all.emplace_back(method.name);
  for (const auto& method : deformation::constraint_methods()) all.emplace_back(method.name);
  add(regime_names());
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
    const std::vector<std::string> all = all_names();
    a->names = with_families(a->names, all);
    require_known("name", a->names, {all.begin(), all.end()});
    if (a->json) std::cout << catalogue_json();
    else print_text(a->names);
    if (!a->json && a->names != "*") print_evaluations(a->names);
    return success;
  });
}

}  // namespace cageproof::cli
