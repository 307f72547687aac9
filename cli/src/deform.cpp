// SPDX-License-Identifier: MIT
#include "commands.h"
#include "deformation_report.h"
#include "posing.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/unknown_name.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/energy_history.h"
#include "cageproof/reports/mesh_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cageproof::cli {

using namespace deformation;
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, method, evaluation, out, derivatives, constraints, energies, outside = "error";
  std::vector<std::string> posed, parameters;
  DataFiles data;
  int order = 0, jobs = 0;
};

constexpr std::string_view schema = "cageproof-deformation";
constexpr std::array mesh_extensions{".obj", ".ply"};
constexpr std::array table_extensions{".csv", ".npy", ".vtp"};
constexpr std::array energy_extensions{".csv", ".png"};

bool is_one_of(std::span<const char* const> extensions, const std::string& file) {
  return std::ranges::find(extensions, std::filesystem::path(file).extension().string()) != extensions.end();
}

// The k-th file, from 1 on, where a name has {n} for the number, once or more.
std::string numbered(const std::string& name, std::size_t k) {
  std::string found = name;
  for (auto at = found.find("{n}"); at != std::string::npos; at = found.find("{n}"))
    found.replace(at, 3, std::to_string(k));
  return found;
}

// What poses have beside vertices, by option.
std::vector<std::pair<std::string, std::string>> given_data(const Arguments& a) {
  std::vector<std::pair<std::string, std::string>> given{{"normal-derivatives", a.data.normal_derivatives},
                                                         {"laplacians", a.data.laplacians},
                                                         {"laplacian-derivatives", a.data.laplacian_derivatives}};
  std::erase_if(given, [](const auto& option) { return option.second.empty(); });
  return given;
}

// Files that this run reads or writes twice.
void check_distinct(const Arguments& a) {
  std::vector<std::pair<std::filesystem::path, std::string>> known{{a.points, "--points"}, {a.cage.file, "--cage"}};
  for (const std::string& posed : a.posed) known.emplace_back(posed, "--posed");
  if (!a.constraints.empty()) known.emplace_back(a.constraints, "--constraints");
  for (const auto& [option, file] : given_data(a)) known.emplace_back(file, "--" + option);
  for (auto& [path, option] : known) path = std::filesystem::weakly_canonical(path);
  const auto write = [&](const std::filesystem::path& name, const std::string& option) {
    if (const auto folder = name.parent_path(); !folder.empty() && !std::filesystem::is_directory(folder))
      throw InputError(fmt::format("{}: there is no folder {}", name.string(), folder.string()));
    const std::filesystem::path path = std::filesystem::weakly_canonical(name);
    for (const auto& [other, its_option] : known)
      if (path == other)
        throw InputError(fmt::format("{}: {} is the file of {}, too", name.string(), option, its_option));
    known.emplace_back(path, option);
  };
  for (std::size_t k = 1; k <= std::max<std::size_t>(1, a.posed.size()); ++k) {
    const std::filesystem::path out = numbered(a.out, k);
    write(out, "--out");
    const std::filesystem::path report = std::filesystem::path(out).replace_extension(".json");
    write(report, "the .json beside --out");
    if (std::filesystem::exists(report) && read_file(report).find(schema) == std::string::npos)
      throw InputError(
          fmt::format("{}: is in the way of the report beside {}, and is none itself", report.string(), out.string()));
    if (!a.derivatives.empty()) write(numbered(a.derivatives, k), "--derivatives");
  }
  if (!a.energies.empty()) write(a.energies, "--energies");
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
  if (!a.energies.empty() && !is_one_of(energy_extensions, a.energies))
    throw InputError(fmt::format("--energies {}: use {}", a.energies, fmt::join(energy_extensions, ", ")));
  check_distinct(a);
}

std::string text_for(const std::string& file, const Deformed& deformed) {
  const std::string extension = std::filesystem::path(file).extension();
  if (extension == ".obj") return reports::obj_text(deformed.mesh);
  if (extension == ".ply") return reports::ply_text(deformed.mesh);
  if (extension == ".npy") return npy_text(deformed.table);
  if (extension == ".vtp") return vtp_text(deformed.table, deformed.mesh);
  return csv_text(deformed.table);
}

struct Chosen {
  std::string_view method;
  std::vector<KindParameter> known;
  std::vector<double> parameters;
};

nlohmann::ordered_json heading(const Arguments& a, const Chosen& chosen, const CageCoordinates& coordinates) {
  nlohmann::ordered_json json = {{"schema", schema}, {"schema_version", 1}};
  json["method"] = chosen.method;
  json["parameters"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < chosen.known.size(); ++i) {
    const KindParameter& p = chosen.known[i];
    const double value = chosen.parameters[i];
    if (p.whole && p.names.empty()) json["parameters"][std::string(p.name)] = static_cast<long long>(value);
    else if (p.names.empty() && !std::isfinite(value))
      json["parameters"][std::string(p.name)] = fmt::format("{}", value);
    else if (p.names.empty()) json["parameters"][std::string(p.name)] = value;
    else json["parameters"][std::string(p.name)] = p.names[static_cast<std::size_t>(value)];
  }
  json["evaluation"] = coordinates.evaluation();
  json["cage"] = a.cage.file;
  return json;
}

Chosen chosen_by(const Arguments& a, std::string_view method, std::vector<KindParameter> known) {
  std::vector<double> parameters = parameters_from(a.parameters, known, method);
  return {method, std::move(known), std::move(parameters)};
}

Posing posing_by(const Arguments& a, const ConstraintMethod* constrained, const Chosen& chosen, const Cage& cage) {
  const DeformOptions options{a.evaluation, a.cage.rule(), chosen.parameters};
  if (!constrained) return posed_by_cages(deform_method_named(a.method), cage, options, a.posed, a.data);
  return posed_by_constraints(*constrained, cage, options, a.constraints, [](int step, double energy) {
    fmt::print(stderr, "step {}: energy {:.6g}\n", step, energy);
  });
}

int run(const Arguments& a) {
  const ConstraintMethod* const constrained = find_constraint_method(a.method);
  const Chosen chosen = constrained ? chosen_by(a, constrained->name, constrained->parameters)
                                    : chosen_by(a, a.method, parameters_of(deform_method_named(a.method)));
  if (constrained ? a.constraints.empty() : a.posed.empty())
    throw InputError(fmt::format("{} takes {}", a.method, constrained ? "--constraints" : "--posed"));
  if (const auto given = given_data(a); constrained && !given.empty())
    throw InputError(fmt::format("--{}: {} takes none", given[0].first, a.method));
  if (!a.energies.empty() && !constrained) throw InputError(fmt::format("--energies: {} has no steps", a.method));
  check_names(a);
  const Cage cage = a.cage.load();
  const Mesh mesh = load_points(a.points, cage.dimension());
  const Posing posing = posing_by(a, constrained, chosen, cage);
  const CageCoordinates& coordinates = *posing.coordinates;
  if (a.order > posing.max_order)
    throw InputError(fmt::format("{} has derivatives up to order {} alone", a.method, posing.max_order));
  const OutsidePolicy outside = a.outside == "rest"  ? OutsidePolicy::Rest
                                : a.outside == "nan" ? OutsidePolicy::Nan
                                                     : OutsidePolicy::Error;
  const std::vector<Deformed> all = deform(coordinates, cage, mesh, posing.maps, a.order, outside, a.jobs);
  // Everything is made before anything is written.
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string out = numbered(a.out, k + 1);
    files.emplace_back(out, text_for(out, all[k]));
    if (!a.derivatives.empty()) {
      const std::string derivatives = numbered(a.derivatives, k + 1);
      files.emplace_back(derivatives, text_for(derivatives, all[k]));
    }
    nlohmann::ordered_json json = heading(a, chosen, coordinates);
    json[constrained ? "constraints" : "posed_cage"] = posing.names[k];
    for (auto [option, file] : given_data(a)) {
      std::ranges::replace(option, '-', '_');
      json[option] = file;
    }
    const DeformationReport& pose = posing.maps[k]->report();
    json.update(deformation_json(coordinates, cage, mesh, posing.vertices[k], all[k], a.order, posing.prepared, pose,
                                 constrained && !posing.vertices[k].empty()));
    for (const auto& warning : json["warnings"]) {
      const auto text = warning.get<std::string>();
      const bool of_method = std::ranges::find(posing.prepared.warnings, text) != posing.prepared.warnings.end();
      if (of_method && k > 0) continue;
      const std::string of_pose = of_method || all.size() == 1 ? "" : posing.names[k] + ": ";
      fmt::print(stderr, "warning: {}{}\n", of_pose, text);
    }
    files.emplace_back(std::filesystem::path(out).replace_extension(".json").string(), json.dump(2) + '\n');
    if (!a.energies.empty())
      files.emplace_back(a.energies,
                         is_one_of(std::array{".png"}, a.energies)
                             ? reports::energies_png(pose.energies, fmt::format("{}, {}", a.method, cage.name()))
                             : reports::energies_csv(pose.energies));
  }
  reports::replace_files(files);
  return success;
}

std::string names_of_methods() {
  std::vector<std::string_view> names;
  for (const DeformMethod& method : deform_methods()) names.push_back(method.name);
  for (const ConstraintMethod& method : constraint_methods()) names.push_back(method.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void add_deform(CommandLine& line) {
  Command command = line.command("deform", "a mesh deformed by a posed cage, or by constraints");
  auto a = std::make_shared<Arguments>();
  a->cage.add_to(command, true);
  Command pose = command.exactly_one_of("Pose");
  pose.option("--posed", a->posed, "the cage's vertices elsewhere: a mesh, text, or an embedded cage; repeats");
  pose.option("--constraints", a->constraints,
              "JSON: what is asked of the map at points, of methods without a posed cage");
  command.option("--normal-derivatives", a->data.normal_derivatives,
                 "text, three numbers a line, for polygons two, a line a triangle or segment: normal derivatives in "
                 "place of posed normals");
  command.option("--laplacians", a->data.laplacians, "the same, a line a vertex: densities of biharmonic_direct");
  command.option("--laplacian-derivatives", a->data.laplacian_derivatives,
                 "the same, a line a triangle or segment: densities of biharmonic_direct");
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
  command.option("--energies", a->energies, ".csv or .png: of methods that iterate, the energy at every half step");
  command.option("--outside", a->outside, "points without image: an error, left at rest, or nan")
      .one_of({"error", "rest", "nan"})
      .showing_default();
  command.option("--jobs", a->jobs, "threads; 0: all cores").in_range(0, 1024).showing_default();
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
