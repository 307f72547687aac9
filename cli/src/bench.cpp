// SPDX-License-Identifier: MIT
#include "commands.h"
#include "inputs_outside.h"
#include "judge_option.h"
#include "progress.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/reports/work_precision.h"
#include "cageproof/benchmarks/coordinate_times.h"
#include "cageproof/validation/machine_facts.h"
#include "cageproof/benchmarks/work_precision.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage{.file = "cube"};
  std::string kind, formula, points, out, command_line;
  std::vector<std::string> regimes{"generic", "near-face"}, parameters;
  benchmarks::WorkPrecisionOptions options;
  bool csv = false, coordinates = false;
  JudgeOption judge;
};

// Notes say what the groups of given points are, and how many points are in none.
void tell_of_points(const std::vector<benchmarks::PointGroup>& groups, std::size_t given, WorkPrecision& result) {
  std::size_t taken = 0;
  for (const benchmarks::PointGroup& group : groups) taken += group.points.size();
  result.notes.emplace_back("places are distances of the points from the cage, in cage sizes");
  if (taken < given)
    result.notes.push_back(fmt::format("{} of {} points lie nearer to the cage than {} of its size and are left out",
                                       given - taken, given, validation::CageLocator::promised_distance));
}

WorkPrecision measure_cage(const Arguments& a, benchmarks::WorkPrecisionOptions options) {
  const CoordinateKind* kind = &coordinate_kind_named(a.kind);
  if (!a.parameters.empty()) options.parameters = parameters_from(a.parameters, parameters_of(*kind), kind->name);
  options.triangulation = a.cage.rule();
  const Cage cage = a.cage.load();
  const validation::CageLocator locator(cage, options.triangulation, kind->keeps_quads);
  std::vector<Vec3<double>> given;
  if (!a.points.empty()) given = load_points(a.points, cage.dimension()).vertices;
  const auto groups = a.points.empty() ? benchmarks::groups_inside(cage, locator, options.seed, options.samples)
                                       : benchmarks::groups_of(cage, locator, given);
  WorkPrecision result = benchmarks::cage_work_precision(cage, *kind, groups, options);
  if (!a.points.empty()) tell_of_points(groups, given.size(), result);
  result.settings = {{"triangulation", a.cage.triangulate}, {"points", a.points.empty() ? "random" : a.points}};
  return result;
}

// Regimes that lists of names and globs select, each once; globs select only those that exist for the element.
std::vector<const validation::Regime*> regimes_named(const std::vector<std::string>& lists, ElementKind element) {
  std::vector<std::string_view> known;
  for (const validation::Regime& regime : validation::regimes()) known.push_back(regime.name);
  std::vector<const validation::Regime*> found;
  for (const std::string& list : lists) {
    for (const std::string& name : names_in(list))
      if (name == validation::hull_regime || name == validation::hunted_regime)
        throw InputError(fmt::format("regime '{}': only `verify` has it; others are {}", name, fmt::join(known, ", ")));
    require_known("regime", list, known);
    for (const std::string& name : names_in(list))
      for (const validation::Regime& regime : validation::regimes())
        if (matches(name, regime.name) && (!is_glob(name) || validation::exists_for(regime, element)) &&
            std::ranges::find(found, &regime) == found.end())
          found.push_back(&regime);
  }
  if (found.empty())
    throw InputError(fmt::format("no regime of a {} matches '{}'", name_of(element), fmt::join(lists, ",")));
  return found;
}

WorkPrecision measure_formula(const Arguments& a, benchmarks::WorkPrecisionOptions options) {
  const Formula* formula = &formula_named(a.formula);
  if (!a.parameters.empty()) options.parameters = parameters_from(a.parameters, parameters_of(*formula), formula->name);
  return benchmarks::formula_work_precision(*formula, regimes_named(a.regimes, formula->element), options);
}

WorkPrecision measure_coordinates(const Arguments& a) {
  const Cage cage = a.cage.load();
  std::vector<Vec3<double>> points;
  if (a.points.empty()) {
    const validation::CageLocator locator(cage, a.cage.rule());
    for (const auto& group : benchmarks::groups_inside(cage, locator, a.options.seed, 400))
      for (const auto& p : group.points) points.push_back(p.point);
  } else {
    points = load_points(a.points, cage.dimension()).vertices;
  }
  benchmarks::WorkPrecisionOptions options = a.options;
  options.triangulation = a.cage.rule();
  std::vector<benchmarks::KindAndEvaluation> what;
  what.reserve(options.evaluations.size());
  for (const std::string& list : options.evaluations)
    for (const std::string& evaluation : names_in(list)) what.push_back({"quad_mean_value", evaluation});
  WorkPrecision result =
      benchmarks::coordinate_times(cage, points, what.empty() ? benchmarks::table_one() : what, options);
  result.settings = {{"triangulation", a.cage.triangulate}, {"points", a.points.empty() ? "random" : a.points}};
  return result;
}

WorkPrecision measure(const Arguments& a) {
  if (a.coordinates) return measure_coordinates(a);
  return a.kind.empty() ? measure_formula(a, a.options) : measure_cage(a, a.options);
}

int run(Arguments& a) {
  // Before anything is measured: a folder that cannot be written should not cost a wait.
  require_outside(a.out, {{a.cage.file, "--cage"}, {a.points, "--points"}});
  std::unique_ptr<reports::WorkPrecisionWriter> writer;
  if (!a.out.empty()) writer = std::make_unique<reports::WorkPrecisionWriter>(a.out);
  a.judge.begin(a.formula.empty() ? "*" : a.formula);
  const std::string started = validation::timestamp();
  WorkPrecision result = measure(a);
  result.version = CAGEPROOF_VERSION;
  result.command_line = a.command_line;
  result.started = started;
  result.machine = validation::machine_facts(a.options.jobs);
  result.settings["parameters"] = fmt::format("{}", fmt::join(a.parameters, " "));
  result.settings["seconds"] = fmt::format("{}", a.options.seconds);
  result.settings["timed"] = fmt::format("{}", a.options.timed);
  std::cout << (a.csv ? reports::work_precision_csv(result) : reports::work_precision_text(result));
  if (writer) remark(fmt::format("written to {}: {}", a.out, fmt::join(writer->write(result), ", ")));
  return success;
}

}  // namespace

void add_bench(CommandLine& line, const std::string& command_line) {
  Command command = line.command("bench", "measure time and error of evaluations side by side");
  auto a = std::make_shared<Arguments>();
  a->command_line = command_line;
  Command what = command.exactly_one_of("Subject");
  const Option kind =
      what.option("--kind", a->kind, "cage coordinates: mean_value, green, biharmonic_boundary ...").taking("KIND");
  const Option formula = what.option("--formula", a->formula, "one formula of the catalogue").taking("FORMULA");
  const Option coordinates =
      what.flag("--coordinates", a->coordinates,
                "whole coordinates in a cage: the kinds and evaluations of [T18] Table 1, or quad_mean_value by those "
                "of --evaluations");
  a->cage.add_to(command, false).excludes(formula).showing_default("cube");
  command
      .option(
          "--points", a->points,
          "a mesh, or text with three numbers per line (for polygons two), instead of random points inside: all are "
          "taken; of a kind in groups by their distance from the cage, as 1e-2..1e-1 of its size" +
              std::string(y_of_points))
      .taking("FILE")
      .excludes(formula);
  command.option("--regime,--regimes", a->regimes, "regimes of a formula's samples")
      .taking("REGIMES")
      .excludes(kind)
      .excludes(coordinates)
      .showing_default("generic,near-face");
  command
      .option("--evaluations,--evaluation", a->options.evaluations,
              "evaluations to compare; if not given, rules from coarse to fine, the recommended evaluation, printed "
              "forms, and batched for a kind")
      .taking("EVALUATIONS");
  command.option("--parameter", a->parameters, "a parameter of the formula or kind, such as nu=... or pieces=...")
      .taking("NAME=VALUE")
      .excludes(coordinates);
  command.option("--order", a->options.order, "derivative order of a formula: 0 value, 1 gradient, 2 Hessian")
      .in_range(0, 2)
      .excludes(kind)
      .excludes(coordinates);
  command
      .option("--samples", a->options.samples,
              "number of random points per distance or regime; those of --points are all taken")
      .in_range(1, 1000000)
      .showing_default();
  command.option("--seed", a->options.seed, "seed of all samples").showing_default();
  command
      .flag("--by-parameter", a->options.by_parameter,
            "one row for each distance, or other parameter that the regime sweeps, of a formula's errors")
      .excludes(kind)
      .excludes(coordinates);
  command.flag("--relative", a->options.relative, "leave out a formula's conditioned units")
      .excludes(kind)
      .excludes(coordinates);
  command.option("--timed", a->options.timed, "number of pairs that are timed one by one, per evaluation and place")
      .in_range(1, 10000000)
      .showing_default();
  command
      .option("--seconds", a->options.seconds,
              "time limit for pairs beyond the first 64, per evaluation and place; for --coordinates the least time "
              "that is measured")
      .in_range(0.0, 3600.0)
      .showing_default();
  command.option("--jobs", a->options.jobs, "threads for the errors; 0: one per core")
      .in_range(0, 1024)
      .showing_default();
  a->judge.add_to(command);
  command.flag("--csv", a->csv, "print CSV");
  command.option("--out", a->out, "a folder for CSV, JSON and pictures").taking("FOLDER");
  command.example("cageproof bench --formula triangle.kelvin_traction --regime near-face --order 1");
  command.example("cageproof bench --kind green --cage torus --out green-times");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
