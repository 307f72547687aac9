// SPDX-License-Identifier: MIT
#include "commands.h"
#include "deformation.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/unknown_name.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/mesh_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace cageproof::cli {

using namespace deformation;
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, method, evaluation, out, derivatives, outside = "error";
  std::vector<std::string> posed, parameters;
  int order = 0, jobs = 0;
};

constexpr std::array mesh_extensions{".obj", ".ply"};
constexpr std::array table_extensions{".csv", ".npy", ".vtp"};

bool is_one_of(std::span<const char* const> extensions, const std::string& file) {
  return std::ranges::find(extensions, std::filesystem::path(file).extension().string()) != extensions.end();
}

std::vector<Vec3<double>> posed_vertices(const std::string& file, int dimension) {
  return is_embedded_cage(file) ? embedded_cage(file).vertices() : load_points(file, dimension).vertices;
}

// The k-th file, from 1 on, where a name has {n} for the number.
std::string numbered(const std::string& name, std::size_t k) {
  const auto at = name.find("{n}");
  return at == std::string::npos ? name : fmt::format("{}{}{}", name.substr(0, at), k, name.substr(at + 3));
}

void check_names(const Arguments& a) {
  if (!is_one_of(mesh_extensions, a.out) && !is_one_of(table_extensions, a.out))
    throw InputError(fmt::format("--out {}: use {} or {}", a.out, fmt::join(mesh_extensions, ", "),
                                 fmt::join(table_extensions, ", ")));
  if (!a.derivatives.empty() && !is_one_of(table_extensions, a.derivatives))
    throw InputError(fmt::format("--derivatives {}: use {}", a.derivatives, fmt::join(table_extensions, ", ")));
  if (a.order > 0 && is_one_of(mesh_extensions, a.out) && a.derivatives.empty())
    throw InputError(fmt::format("--order {}: '{}' files hold no derivatives; --derivatives FILE takes them", a.order,
                                 std::filesystem::path(a.out).extension().string()));
  if (a.order == 0 && !a.derivatives.empty()) throw InputError("--derivatives: --order says which, 1 or 2");
  for (const std::string* name : {&a.out, &a.derivatives})
    if (a.posed.size() > 1 && !name->empty() && name->find("{n}") == std::string::npos)
      throw InputError(fmt::format("{}: {} poses need a name with {{n}} for their number", *name, a.posed.size()));
  if (is_one_of(mesh_extensions, a.out) && a.outside == "nan")
    throw InputError(fmt::format("--outside nan: '{}' files hold no nan; use {}",
                                 std::filesystem::path(a.out).extension().string(), fmt::join(table_extensions, ", ")));
}

std::string text_for(const std::string& file, const Deformed& deformed) {
  const std::string extension = std::filesystem::path(file).extension();
  if (extension == ".obj") return reports::obj_text(deformed.mesh);
  if (extension == ".ply") return reports::ply_text(deformed.mesh);
  if (extension == ".npy") return npy_text(deformed.table);
  if (extension == ".vtp") return vtp_text(deformed.table, deformed.mesh);
  return csv_text(deformed.table);
}

nlohmann::ordered_json heading(const Arguments& a, const DeformMethod& method, const Deformer<double>& deformer,
                               const std::vector<double>& parameters) {
  nlohmann::ordered_json json = {{"schema", "cageproof-deformation"}, {"schema_version", 1}};
  json["method"] = method.name;
  json["parameters"] = nlohmann::ordered_json::object();
  const std::vector<KindParameter> known = parameters_of(method);
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i].names.empty()) json["parameters"][std::string(known[i].name)] = parameters[i];
    else json["parameters"][std::string(known[i].name)] = known[i].names[static_cast<std::size_t>(parameters[i])];
  }
  json["evaluation"] = deformer.coordinates().evaluation();
  json["cage"] = a.cage.file;
  return json;
}

int run(const Arguments& a) {
  const DeformMethod& method = deform_method_named(a.method);
  check_names(a);
  const std::vector<double> parameters = parameters_from(a.parameters, parameters_of(method), method.name);
  const Cage cage = a.cage.load();
  const Mesh mesh = load_points(a.points, cage.dimension());
  std::vector<std::pair<std::string, std::vector<Vec3<double>>>> poses;
  poses.reserve(a.posed.size());
  for (const std::string& file : a.posed) poses.emplace_back(file, posed_vertices(file, cage.dimension()));
  const auto deformer = prepare_deformer<double>(method, cage, {a.evaluation, a.cage.rule(), parameters});
  const OutsidePolicy outside = a.outside == "rest"  ? OutsidePolicy::Rest
                                : a.outside == "nan" ? OutsidePolicy::Nan
                                                     : OutsidePolicy::Error;
  const std::vector<Deformed> all = deform(*deformer, cage, mesh, poses, a.order, outside, a.jobs);
  // Everything is made before anything is written.
  std::vector<std::pair<std::string, std::string>> files;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string out = numbered(a.out, k + 1);
    files.emplace_back(out, text_for(out, all[k]));
    if (!a.derivatives.empty()) {
      const std::string derivatives = numbered(a.derivatives, k + 1);
      files.emplace_back(derivatives, text_for(derivatives, all[k]));
    }
    nlohmann::ordered_json json = heading(a, method, *deformer, parameters);
    json["posed_cage"] = poses[k].first;
    json.update(deformation_json(*deformer, cage, mesh, poses[k].second, all[k], a.order));
    for (const auto& warning : json["warnings"]) fmt::print(stderr, "warning: {}\n", warning.get<std::string>());
    files.emplace_back(std::filesystem::path(out).replace_extension(".json").string(), json.dump(2) + '\n');
    if (all[k].without_image > 0)
      fmt::print(stderr, "warning: {} of {} points have no image\n", all[k].without_image, mesh.vertices.size());
  }
  for (const auto& [file, text] : files) reports::replace_file(file, text);
  return success;
}

std::string names_of_methods() {
  std::vector<std::string_view> names;
  for (const DeformMethod& method : deform_methods()) names.push_back(method.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void add_deform(CommandLine& line) {
  Command command = line.command("deform", "a mesh deformed by a posed cage");
  auto a = std::make_shared<Arguments>();
  a->cage.add_to(command, true);
  command.option("--posed", a->posed, "the cage's vertices elsewhere: a mesh, text, or an embedded cage; repeats")
      .required();
  command.option("--points", a->points, "a mesh, or text with three numbers a line, for polygons two").required();
  command.option("--method", a->method, names_of_methods()).required();
  command.option("--parameter", a->parameters, "the method's, NAME=VALUE; `list` names them");
  command.option("--evaluation", a->evaluation, "how formulas are evaluated, instead of as recommended");
  command
      .option(
          "--out", a->out,
          ".obj, .ply, .vtp, .csv or .npy, with {n} for the number of the pose; a .json beside it says what was done")
      .required();
  command.option("--order", a->order, "1: Jacobians, 2: Hessians, too").in_range(0, 2).showing_default();
  command.option("--derivatives", a->derivatives, ".csv, .npy or .vtp, beside a mesh file");
  command.option("--outside", a->outside, "points without image: an error, left at rest, or nan")
      .one_of({"error", "rest", "nan"})
      .showing_default();
  command.option("--jobs", a->jobs, "threads; 0: all cores").in_range(0, 1024).showing_default();
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
