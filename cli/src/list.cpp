// SPDX-License-Identifier: MIT
#include "cage_text.h"
#include "catalogue_json.h"
#include "catalogue_names.h"
#include "commands.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/core/coordinates/purposes.h"
#include "cageproof/deformation/constrained.h"
#include "cageproof/deformation/purposes.h"
#include "cageproof/reports/checked_file.h"
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

// Whether a name among the rows matches, so that their heading is printed.
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

void print_kind(const CoordinateKind& kind) {
  std::vector<std::string> labels;
  labels.reserve(kind.blocks.size());
  for (const SummedBlock& b : kind.blocks) labels.emplace_back(b.label);
  if (!kind.is_sum())
    for (const CoordinateBlock& b : own_blocks(kind)) labels.push_back(b.label);
  fmt::print("    {} ({}", kind.name, fmt::join(labels, ", "));
  for (const std::string_view evaluation : whole_evaluations_of(kind)) fmt::print("; {}", evaluation);
  fmt::print(")");
  print_parameters(parameters_of(kind));
  fmt::print("   ({})\n", kind.source);
  if (const std::string_view purpose = purpose_of_kind(kind.name); !purpose.empty())
    fmt::print("        {}\n", purpose);
}

// The dimensions of a kind's cages.
struct Dimensions {
  bool space, plane;
  bool operator==(const Dimensions&) const = default;
};

Dimensions dimensions_of(const CoordinateKind& kind) {
  return {exists_on(kind, embedded_cage("cube")), exists_on(kind, embedded_cage("square"))};
}

// The rows that are asked for and belong in a group, under its heading.
void print_group(std::string_view heading, const auto& rows, const std::string& asked, auto belongs, auto print) {
  bool first = true;
  for (const auto& row : rows) {
    if (!matches(asked, row.name) || !belongs(row)) continue;
    if (first) fmt::print("{}:\n", heading);
    first = false;
    print(row);
  }
}

void print_kinds(const std::string& asked) {
  for (const auto& [where, heading] : {std::pair(Dimensions{true, true}, "coordinates in space and in the plane"),
                                       {Dimensions{true, false}, "coordinates in space"},
                                       {Dimensions{false, true}, "coordinates in the plane"}})
    print_group(
        heading, coordinate_kinds(), asked,
        [&, where = where](const CoordinateKind& kind) { return dimensions_of(kind) == where; }, print_kind);
}

void print_deformer(const auto& method, const std::vector<KindParameter>& parameters) {
  fmt::print("    {}", method.name);
  print_parameters(parameters);
  fmt::print("   ({}; keeps {})\n", method.source, method.keeps);
  if (const std::string_view purpose = deformation::purpose_of_method(method.name); !purpose.empty())
    fmt::print("        {}\n", purpose);
}

void print_deformers(const std::string& asked) {
  for (const auto& [where, heading] :
       {std::pair(Dimensions{true, true}, "deformers by posed cages in space and in the plane"),
        {Dimensions{true, false}, "deformers by posed cages in space"},
        {Dimensions{false, true}, "deformers by posed polygons"}})
    print_group(
        heading, deformation::deform_methods(), asked,
        [&, where = where](const deformation::DeformMethod& method) {
          return dimensions_of(coordinate_kind_named(method.kind)) == where;
        },
        [](const deformation::DeformMethod& method) { print_deformer(method, deformation::parameters_of(method)); });
  print_group(
      "deformers by constraints", deformation::constraint_methods(), asked, [](const auto&) { return true; },
      [](const deformation::ConstraintMethod& method) { print_deformer(method, method.parameters); });
}

void print_text(const std::string& asked) {
  for (const Formula& f : catalogue()) {
    if (!matches(asked, f.name)) continue;
    fmt::print("{}\n    {} = {}   ({})\n    evaluations:", f.name, f.symbol, f.definition, f.source);
    for (const EvaluationFamily* family : EvaluationRegister::instance().families(f.name))
      fmt::print(" {}", family->pattern);
    fmt::print("\n");
  }
  if (asked == "*") fmt::print("\n");
  print_kinds(asked);
  print_deformers(asked);
  print_names("regimes", regime_names(), asked);
  std::vector<std::string_view> checks = validation::check_names();
  for (const std::string_view name : other_checks()) checks.push_back(name);
  print_names("checks", checks, asked);
  for (const int dimension : {3, 2}) {
    std::vector<std::string_view> cages = embedded_cage_names();
    std::erase_if(cages, [&](std::string_view cage) { return embedded_cage(cage).dimension() != dimension; });
    print_names(dimension == 3 ? "embedded cages" : "embedded polygons", cages, asked);
  }
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

void write_cage(const std::string& name, const std::string& out) {
  if (!is_embedded_cage(name)) {
    std::vector<std::string_view> known = embedded_cage_names();
    for (const std::string_view extreme : extreme_cage_names()) known.push_back(extreme);
    throw unknown_single_name("embedded cage", name, known);
  }
  reports::require_writable({out});
  reports::replace_file(out, cage_text(out, embedded_cage(name)));
}

}  // namespace

void add_list(CommandLine& line) {
  Command command = line.command(
      "list",
      "print the catalogue: formulas, sources, evaluations, kinds of coordinates, deformers, regimes, checks, cages");
  struct Arguments {
    std::string names = "*", cage, out;
    bool json = false;
  };
  auto a = std::make_shared<Arguments>();
  const Option names =
      command
          .option("names", a->names,
                  "only entries with such a name: names and globs with commas between; all if not given")
          .taking("NAMES");
  Option json = command.flag("--json", a->json, "as JSON, with scalars, ranges and descriptions").excludes(names);
  Option cage = command.option("--cage", a->cage, "an embedded cage, which is written to --out").taking("CAGE");
  const Option out =
      command
          .option("--out", a->out,
                  "a file for it: .obj, .ply, .stl or .vtp of cages in space, .obj, .svg or .vtp of polygons")
          .taking("FILE")
          .needs(cage);
  cage.needs(out).excludes(names).excludes(json);
  command.example("cageproof list 'triangle.*'");
  command.example("cageproof list --json");
  command.example("cageproof list --cage cube --out cube.obj");
  command.runs([a] {
    if (!a->cage.empty()) {
      write_cage(a->cage, a->out);
      return success;
    }
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
