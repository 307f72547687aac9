// SPDX-License-Identifier: MIT
#include "commands.h"
#include "inputs_outside.h"
#include "judge_option.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/reports/report_writer.h"
#include "cageproof/validation/compared_fields.h"
#include "cageproof/validation/error_fields.h"
#include "cageproof/validation/machine_facts.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string formula, kind, coordinate, evaluation, points, out, command_line;
  std::vector<std::string> compare;
  std::vector<std::string> parameters;
  std::vector<double> colours;
  int order = 0, resolution = 0, jobs = 0;
  JudgeOption judge;
};

// A field, and the array that its picture shows.
struct Shown {
  ImageField field;
  std::string title, array;
  MeshField outline;
};

Evaluation recommended_or_integral(const std::string& formula) {
  auto& known = EvaluationRegister::instance();
  auto recommended = known.with_role(formula, Role::Recommended);
  return recommended ? *recommended : known.with_role(formula, Role::Integral).value();
}

Shown formula_field(const Arguments& a, RunResult& result) {
  const Formula& formula = formula_named(a.formula);
  const Evaluation evaluation =
      a.evaluation.empty() ? recommended_or_integral(a.formula) : evaluation_named(a.formula, a.evaluation);
  if (a.order > evaluation.max_order())
    throw InputError(fmt::format("{} of {} gives no derivatives of order {}", evaluation.name(), a.formula, a.order));
  std::vector<std::vector<Vec3<double>>> elements;
  validation::SlicePlan slice;
  std::string where = fmt::format("one {}", name_of(formula.element));
  if (a.cage.file.empty()) {
    auto one = validation::slice_of(formula.element, a.resolution > 0 ? a.resolution : 160);
    elements.push_back(std::move(one.corners));
    slice = one.slice;
  } else {
    const Cage cage = a.cage.load();
    elements = validation::elements_of(cage, formula.element, a.cage.rule());
    slice = validation::slice_through(cage, a.resolution > 0 ? a.resolution : 64);
    where = cage.name();
    result.settings = {{"cage", cage.name()}, {"triangulation", a.cage.triangulate}};
  }
  MeshField outline;
  for (const auto& corners : elements) {
    std::vector<int>& face = outline.faces.emplace_back();
    for (const auto& corner : corners) {
      face.push_back(static_cast<int>(outline.vertices.size()));
      outline.vertices.push_back(corner);
    }
  }
  constexpr std::array orders{"value", "gradient", "Hessian"};
  return {validation::formula_error_field(elements, formula, evaluation, a.order, slice, a.jobs),
          fmt::format("{}, {} of {}, {}", a.formula, orders[a.order], evaluation.name(), where), "relative error",
          outline};
}

// "alpha:3": the block's label and the coordinate's index.
std::pair<std::string, int> coordinate_of(const std::string& text) {
  const auto colon = text.rfind(':');
  const std::string digits = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (digits.empty() || digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos)
    throw InputError(fmt::format("--coordinate {}: not a block and an index, such as lambda:0", text));
  return {text.substr(0, colon), std::stoi(digits)};
}

Shown value_field(const Arguments& a, RunResult& result) {
  const CoordinateKind& kind = coordinate_kind_named(a.kind);
  const auto cage = std::make_shared<const Cage>(a.cage.load());
  result.settings = {{"cage", cage->name()}};
  const auto [label, index] = coordinate_of(a.coordinate);
  const auto plan = validation::coordinate_field(cage, kind, label, index, a.resolution > 0 ? a.resolution : 128);
  const std::string array = plan.field.arrays.front().name;
  return {validation::sampled(plan, a.jobs), fmt::format("{} of {}, {}", array, a.kind, cage->name()), array,
          validation::outline_of(*cage)};
}

Shown kind_field(const Arguments& a, RunResult& result) {
  const CoordinateKind& kind = coordinate_kind_named(a.kind);
  const auto cage = std::make_shared<const Cage>(a.cage.load());
  result.settings = {{"cage", cage->name()}, {"triangulation", a.cage.triangulate}};
  for (const std::string& parameter : a.parameters) result.settings["parameters"] += parameter + " ";
  const int n = a.resolution > 0 ? a.resolution : 64;
  const auto plan = validation::reproduction_field(cage, kind, a.evaluation, a.cage.rule(), n,
                                                   parameters_from(a.parameters, parameters_of(kind), kind.name));
  return {validation::sampled(plan, a.jobs),
          fmt::format("{}, partition of unity of {}, {}", a.kind, a.evaluation.empty() ? "recommended" : a.evaluation,
                      cage->name()),
          "partition of unity", validation::outline_of(*cage)};
}

// A solved kind is compared with the true coordinates that it approximates.
Shown scheme_field(const Arguments& a, const CoordinateKind& kind, RunResult& result) {
  if (kind.approximates.empty())
    throw InputError(fmt::format("--compare: {} coordinates are no sums over elements, and have no truth", kind.name));
  if (a.compare != std::vector<std::string>{std::string(kind.approximates)})
    throw InputError(fmt::format("--compare: {} coordinates are solved for, and compared with {} only", kind.name,
                                 kind.approximates));
  if (!a.points.empty()) throw InputError(fmt::format("--points: {} is compared on a grid only", kind.name));
  const auto cage = std::make_shared<const Cage>(a.cage.load());
  result.settings = {{"cage", cage->name()}, {"triangulation", a.cage.triangulate}};
  for (const std::string& parameter : a.parameters) result.settings["parameters"] += parameter + " ";
  const auto plan = validation::scheme_error_field(cage, kind, a.cage.rule(), a.resolution > 0 ? a.resolution : 64,
                                                   parameters_from(a.parameters, parameters_of(kind), kind.name));
  return {validation::sampled(plan, a.jobs),
          fmt::format("{} against {}, {}", kind.name, kind.approximates, cage->name()), "scheme error",
          validation::outline_of(*cage)};
}

// Vertices of a mesh that are compared with 50 digits at most: seconds to a minute.
constexpr std::size_t most_vertices = 2000;

// Two to four evaluations, each once; globs select among those that verification runs.
std::vector<std::string> compared_names(const std::vector<std::string>& lists, const CoordinateKind& kind,
                                        const Cage& cage) {
  std::vector<std::string_view> known = whole_evaluation_names(kind, cage);
  // The last one's, of quads where the kind keeps them; there is none where the kind does not exist on the cage.
  const std::vector<const Formula*> formulas = formulas_of(kind, cage);
  if (formulas.empty())
    throw InputError(fmt::format("{}: {} coordinates do not exist on cages of this dimension", cage.name(), kind.name));
  for (const std::string_view name : evaluation_names(formulas.back()->name))
    if (EvaluationRegister::instance().find(formulas.back()->name, name)) known.push_back(name);
  std::vector<std::string> names;
  const auto add = [&](std::string_view name) {
    if (std::ranges::find(names, name) != names.end()) throw InputError(fmt::format("--compare: {} twice", name));
    names.emplace_back(name);
  };
  for (const std::string& list : lists)
    for (const std::string& name : names_in(list)) {
      if (!is_glob(name)) {
        add(name);
        continue;
      }
      require_known(fmt::format("evaluation of {}", kind.name), name, known);
      for (const std::string_view one : known)
        if (matches(name, one)) add(one);
    }
  for (const std::string& name : names) require_evaluation(kind, cage, name);
  if (names.size() < 2 || names.size() > 4)
    throw InputError(fmt::format("--compare: {} evaluations; 2 to 4 are compared", names.size()));
  return names;
}

reports::FieldScene scene_of(const Arguments& a, RunResult& result) {
  const CoordinateKind& kind = coordinate_kind_named(a.kind);
  const auto cage = std::make_shared<const Cage>(a.cage.load());
  const std::vector<std::string> compare = compared_names(a.compare, kind, *cage);
  const validation::Comparison comparison{cage, &kind, compare, a.cage.rule()};
  result.settings = {{"cage", cage->name()}, {"triangulation", a.cage.triangulate}};
  const int side = a.resolution > 0 ? a.resolution : validation::affordable_side(comparison, 200'000, 32);
  reports::FieldScene scene;
  scene.title = validation::scene_title(comparison);
  scene.explanation = validation::scene_explanation;
  for (const std::string& evaluation : compare) scene.compared.push_back(evaluation + ": relative error");
  scene.cage = validation::outline_of(*cage);
  if (!a.points.empty())
    scene.mesh = validation::compared_mesh(comparison, load_points(a.points, cage->dimension()), most_vertices, a.jobs);
  scene.image = validation::sampled(validation::compared_field(comparison, side), a.jobs);
  return scene;
}

std::optional<reports::ColourLimits> limits_of(const Arguments& a) {
  if (a.colours.empty()) return std::nullopt;
  const bool ordered = a.colours[0] < a.colours[1] && std::isfinite(a.colours[0]) && std::isfinite(a.colours[1]);
  if (!ordered || (a.coordinate.empty() && !(0 < a.colours[0])))
    throw InputError(a.coordinate.empty() ? "--colours: two numbers, 0 < LOW < HIGH"
                                          : "--colours: two numbers, LOW < HIGH");
  return reports::ColourLimits{a.colours[0], a.colours[1]};
}

void write_all(reports::ReportWriter& writer, const RunResult& result) {
  for (const std::string& undrawn : writer.write(result)) fmt::print(stderr, "warning: {}\n", undrawn);
  writer.commit();
}

int run(Arguments& a) {
  require_outside(a.out, {{a.cage.file, "--cage"}, {a.points, "--points"}});
  const auto limits = limits_of(a);
  a.judge.begin(a.formula.empty() ? "*" : a.formula);
  RunResult result;
  result.version = CAGEPROOF_VERSION;
  result.suite = "field";
  result.sessions = {{validation::timestamp(), 0, a.command_line, validation::machine_facts(a.jobs)}};
  const auto start = std::chrono::steady_clock::now();
  reports::ReportWriter writer(a.out, reports::ReportWriter::Kind::Field);
  const bool is_scheme = !a.compare.empty() && !coordinate_kind_named(a.kind).is_sum();
  if (!a.compare.empty() && !is_scheme) {
    reports::FieldScene scene = scene_of(a, result);
    scene.image.facts["version"] = scene.mesh.facts["version"] = CAGEPROOF_VERSION;
    result.fields = writer.write_scene(scene);
    result.sessions.front().seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    write_all(writer, result);
    for (const auto& array : scene.image.arrays)
      if (!array.linear) {
        double largest = 0;
        for (const double error : array.values) largest = std::max(largest, std::isnan(error) ? 0 : error);
        fmt::print("{}: largest found {:.3g}\n", array.name, largest);
      }
    fmt::print("{0}/{1} in a browser; {0}/{2} in ParaView\n", a.out, result.fields[0].page, result.fields[0].state);
    return success;
  }
  Shown shown = a.kind.empty()         ? formula_field(a, result)
                : is_scheme            ? scheme_field(a, coordinate_kind_named(a.kind), result)
                : a.coordinate.empty() ? kind_field(a, result)
                                       : value_field(a, result);
  shown.field.facts["version"] = CAGEPROOF_VERSION;
  const auto scale = a.coordinate.empty() ? reports::ColourScale::Log10 : reports::ColourScale::Linear;
  result.fields.push_back(writer.write_image(shown.field, shown.title, shown.array, scale, limits, &shown.outline));
  result.sessions.front().seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_all(writer, result);
  fmt::print("largest {} {:.3g}; {}/{}, {}/{}\n",
             a.kind.empty()         ? "relative error"
             : is_scheme            ? "scheme error"
             : a.coordinate.empty() ? "residual of the partition of unity"
                                    : shown.array,
             result.fields[0].largest, a.out, result.fields[0].data, a.out, result.fields[0].picture);
  return success;
}

}  // namespace

void add_field(CommandLine& line, const std::string& command_line) {
  Command command = line.command("field", "draw the error field of evaluations, as VTK files and a picture or scene");
  auto a = std::make_shared<Arguments>();
  a->command_line = command_line;
  Command what = command.exactly_one_of("Subject");
  const Option formula =
      what.option("--formula", a->formula, "relative error of a formula of the catalogue").taking("FORMULA");
  Option kind = what.option("--kind", a->kind, "partition of unity of a kind of cage coordinates").taking("KIND");
  Option evaluation =
      command.option("--evaluation", a->evaluation, "one of its evaluations; by default the recommended one")
          .taking("EVALUATION");
  command
      .option("--coordinate", a->coordinate, "draw the values of one coordinate, such as lambda:0, instead of errors")
      .needs(kind)
      .excludes(evaluation);
  const Option compare =
      command
          .option("--compare", a->compare,
                  "2 to 4 evaluations, such as gauss-8,published,closed_form: their errors against 50 digits side by "
                  "side, in 3D; for harmonic and biharmonic_boundary in the plane the true kind, such as "
                  "harmonic_goursat: a slice of errors")
          .taking("EVALUATIONS")
          .needs(kind)
          .excludes(evaluation);
  command.option("--points", a->points, "a mesh, whose vertices are compared too (2000 of them, spread evenly)")
      .taking("FILE")
      .needs(compare);
  command.option("--order", a->order, "0 value, 1 gradient, 2 Hessian").in_range(0, 2).showing_default().excludes(kind);
  command.option("--parameter", a->parameters, "mu=..., nu=... of a kind").excludes(formula);
  kind.needs(a->cage.add_to(command, false));
  command
      .option(
          "--resolution", a->resolution,
          "samples per side; default: 64, for a formula 160, for --coordinate 128, for --compare up to 32, fewer for "
          "slow evaluations")
      .in_range(2, 4096);
  a->judge.add_to(command);
  command.option("--jobs", a->jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  command
      .option("--colours", a->colours,
              "LOW HIGH: the range of the colours, the same in every run; if not given, the field's own range")
      .values(2)
      .excludes(compare);
  command.option("--out", a->out, "a folder for the field, its picture and a summary").taking("FOLDER").required();
  command.example("cageproof field --kind green --cage cube --compare gauss-8,hybrid --resolution 8 --out errors");
  command.example("cageproof field --formula triangle.double_layer --evaluation plain --out slice");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
