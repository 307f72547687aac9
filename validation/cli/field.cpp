// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/report_writer.h"
#include "cageproof/validation/error_fields.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>

#include <chrono>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string formula, evaluation, out, command_line;
  int order = 0, resolution = 0, jobs = 0;
};

// Without a cage: one triangle, cut by a plane at right angles to it that meets face, edge and outside.
constexpr std::array<std::array<double, 3>, 3> default_triangle{
    std::array{0.0, 0.0, 0.0}, std::array{1.0, 0.0, 0.0}, std::array{0.3, 0.0, -0.8}};

int run(const Arguments& a) {
  const Formula* formula = find_formula(a.formula);
  if (!formula) throw InputError(fmt::format("unknown formula '{}'; see `cageproof list`", a.formula));
  const auto evaluation = EvaluationRegister::instance().find(a.formula, a.evaluation);
  if (!evaluation) throw InputError(fmt::format("{} has no evaluation '{}'; see `cageproof list`", a.formula, a.evaluation));
  if (a.order > evaluation->max_order())
    throw InputError(fmt::format("{} of {} gives no derivatives of order {}", a.evaluation, a.formula, a.order));
  RunResult result;
  result.version = CAGEPROOF_VERSION;
  result.suite = "field";
  result.command_line = a.command_line;
  result.started = validation::timestamp();
  result.machine = validation::machine_facts();
  std::vector<std::array<Vec3<double>, 3>> triangles;
  validation::SlicePlan slice;
  std::string where;
  if (a.cage.file.empty()) {
    auto& t = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) t[k] = Vec3<double>(default_triangle[k][0], default_triangle[k][1], default_triangle[k][2]);
    const int n = a.resolution > 0 ? a.resolution : 160;
    slice = {{-0.6, -0.8, -0.271}, {2.2 / (n - 1), 1.6 / (n - 1), 1}, {n, n, 1}};
    where = "one triangle";
  } else {
    const Cage cage = a.cage.load();
    for (const auto& t : cage.triangulate(a.cage.rule()).triangles)
      triangles.push_back({cage.vertices()[t[0]], cage.vertices()[t[1]], cage.vertices()[t[2]]});
    slice = validation::slice_through(cage, a.resolution > 0 ? a.resolution : 64);
    where = cage.name();
    result.settings = {{"cage", cage.name()}, {"triangulation", a.cage.triangulate}};
  }
  const auto start = std::chrono::steady_clock::now();
  reports::ReportWriter writer(a.out);
  const ImageField field = validation::formula_error_field(triangles, *formula, *evaluation, a.order, slice, a.jobs);
  constexpr std::array orders{"value", "gradient", "Hessian"};
  result.fields.push_back(writer.write_image(
      field, fmt::format("{}, {} of {}, {}", a.formula, orders[a.order], a.evaluation, where), "relative error", reports::ColourScale::Log10));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writer.write(result);
  writer.commit();
  fmt::print("largest relative error {:.3g}; {}/{}, {}/{}\n", result.fields[0].largest, a.out, result.fields[0].data, a.out,
             result.fields[0].picture);
  return all_kept;
}

}  // namespace

void add_field(CLI::App& app, Action& action, const std::string& command_line) {
  CLI::App* command = app.add_subcommand("field", "the error field of one evaluation, as VTK file and picture");
  auto a = std::make_shared<Arguments>();
  a->command_line = command_line;
  command->add_option("--formula", a->formula, "a formula of the catalogue")->required();
  command->add_option("--evaluation", a->evaluation, "one of its evaluations")->required();
  command->add_option("--order", a->order, "0 value, 1 gradient, 2 Hessian")->check(CLI::Range(0, 2))->capture_default_str();
  a->cage.add_to(*command, false);
  command->add_option("--resolution", a->resolution, "samples a side")->check(CLI::Range(2, 4096));
  command->add_option("--jobs", a->jobs, "threads; 0: all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  command->add_option("--out", a->out, "the report's folder")->required();
  command->callback([&action, a] { action = [a] { return run(*a); }; });
}

}  // namespace cageproof::cli
