// SPDX-License-Identifier: MIT
#include "deform_files.h"

#include "inputs_outside.h"
#include "numbered_name.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/carried_mesh.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/energy_history.h"
#include "cageproof/reports/mesh_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

namespace cageproof::cli {
namespace {

constexpr std::array mesh_extensions{".obj", ".ply", ".stl", ".svg"};
constexpr std::array table_extensions{".csv", ".npy", ".vtp"};
constexpr std::array cache_extensions{".pc2", ".mdd"};
constexpr std::array energy_extensions{".csv", ".png"};

bool is_one_of(std::span<const char* const> extensions, const std::string& file) {
  return std::ranges::find(extensions, extension_of(file)) != extensions.end();
}

// Files that this run reads or writes twice.
void check_distinct(const DeformArguments& a, std::size_t maps) {
  std::vector<std::pair<std::filesystem::path, std::string>> known{{a.points, "--points"}, {a.cage.file, "--cage"}};
  for (const std::string& posed : a.posed) known.emplace_back(posed, "--posed");
  if (!a.constraints.empty()) known.emplace_back(a.constraints, "--constraints");
  for (const auto& [option, file] : given_data(a)) known.emplace_back(file, "--" + option);
  if (!a.stress.normals.empty()) known.emplace_back(a.stress.normals, "--normals");
  for (auto& [path, option] : known) path = place_of(path);
  std::vector<std::filesystem::path> written;
  const auto write = [&](const std::filesystem::path& name, const std::string& option) {
    written.push_back(name);
    const std::filesystem::path path = place_of(name);
    for (const auto& [other, its_option] : known)
      if (path == other)
        throw InputError(fmt::format("{}: {} is the file of {}, too", name.string(), option, its_option));
    known.emplace_back(path, option);
  };
  const bool in_one = is_point_cache(a.out);
  if (in_one) write(a.out, "--out");
  const std::filesystem::path report = report_file(a, maps);
  write(report, "the .json beside --out");
  if (std::filesystem::exists(report) && read_file(report).find(deformation_schema) == std::string::npos)
    throw InputError(
        fmt::format("{}: the report on {} goes to this file, which is no such report; choose another --out, or move it",
                    report.string(), in_one || maps > 1 ? a.out : numbered(a.out, 1)));
  for (std::size_t k = 1; k <= maps; ++k) {
    if (!in_one) write(numbered(a.out, k), "--out");
    if (!a.derivatives.empty()) write(numbered(a.derivatives, k), "--derivatives");
    if (a.stress.asked()) write(numbered(a.stress.file, k), "--stress");
  }
  if (!a.collection.empty()) write(a.collection, "--out");
  if (!a.energies.empty()) write(a.energies, "--energies");
  if (!a.solved.empty()) write(a.solved, "--solved");
  reports::require_writable(written);
}

void check_standard_input(const DeformArguments& a) {
  std::vector<std::pair<std::string, std::string>> inputs{{a.cage.file, "--cage"}, {a.points, "--points"}};
  for (const std::string& posed : a.posed) inputs.emplace_back(posed, "--posed");
  for (const auto& [option, file] : given_data(a)) inputs.emplace_back(file, "--" + option);
  if (!a.stress.normals.empty()) inputs.emplace_back(a.stress.normals, "--normals");
  require_one_reader_of_input(inputs);
}

// One file holds all maps, so its name has no mark for their numbers.
void require_no_mark(const std::string& out) {
  require_marks("--out", out);
  if (has_mark(out))
    throw InputError(fmt::format("--out {}: one '{}' file holds all maps; leave out {{n}}", out, extension_of(out)));
}

void check_numbers(const DeformArguments& a, std::size_t maps) {
  if (is_point_cache(a.out)) require_no_mark(a.out);
  for (const auto& [option, name] : {std::pair{"--out", &a.out}, std::pair{"--derivatives", &a.derivatives},
                                     std::pair{"--stress", &a.stress.file}}) {
    require_marks(option, *name);
    const bool holds_all = name == &a.out && is_point_cache(a.out);
    if (maps > 1 && !name->empty() && !holds_all && !has_mark(*name))
      throw InputError(fmt::format("{}: {} maps need a name with {{n}} or {{n:03d}} for their number{}", *name, maps,
                                   name == &a.out ? ", or one file of all: .pc2, .mdd or .pvd" : ""));
  }
  if (a.frame_rate > 0 && extension_of(a.out) != ".mdd")
    throw InputError(fmt::format("--frame-rate: '{}' files hold no times; .mdd files do",
                                 extension_of(a.collection.empty() ? a.out : a.collection)));
}

}  // namespace

bool is_point_cache(const std::string& file) { return is_one_of(cache_extensions, file); }

void split_collection(DeformArguments& a) {
  if (extension_of(a.out) != ".pvd") return;
  require_no_mark(a.out);
  a.collection = a.out;
  std::filesystem::path series = a.out;
  series.replace_filename(series.stem().string() + "_{n:03d}.vtp");
  a.out = series.string();
}

std::filesystem::path report_file(const DeformArguments& a, std::size_t maps) {
  if (!a.collection.empty()) return std::filesystem::path(a.collection).replace_extension(".json");
  if (is_point_cache(a.out)) return std::filesystem::path(a.out).replace_extension(".json");
  std::filesystem::path file = numbered(a.out, 1);
  if (maps > 1) {
    std::string stem = without_marks(std::filesystem::path(a.out).stem().string());
    // The separator between name and number.
    stem.erase(stem.find_last_not_of("_-. ") + 1);
    file.replace_filename(stem.empty() ? "maps" : stem + ".x");
  }
  return file.replace_extension(".json");
}

std::vector<std::pair<std::string, std::string>> given_data(const DeformArguments& a) {
  std::vector<std::pair<std::string, std::string>> given{{"normal-derivatives", a.data.normal_derivatives},
                                                         {"laplacians", a.data.laplacians},
                                                         {"laplacian-derivatives", a.data.laplacian_derivatives}};
  std::erase_if(given, [](const auto& option) { return option.second.empty(); });
  return given;
}

void check_names(const DeformArguments& a, std::size_t maps) {
  const bool places_only = is_one_of(mesh_extensions, a.out) || is_point_cache(a.out);
  if (!places_only && !is_one_of(table_extensions, a.out))
    throw InputError(fmt::format("--out {}: use {} or {}; {} or .pvd for all maps in one", a.out,
                                 fmt::join(mesh_extensions, ", "), fmt::join(table_extensions, ", "),
                                 fmt::join(cache_extensions, ", ")));
  for (const auto& [option, name] : {std::pair{"--derivatives", &a.derivatives}, std::pair{"--stress", &a.stress.file}})
    if (!name->empty() && !is_one_of(table_extensions, *name))
      throw InputError(fmt::format("{} {}: use {}", option, *name, fmt::join(table_extensions, ", ")));
  if (a.order > 0 && places_only && a.derivatives.empty())
    throw InputError(fmt::format("--order {}: '{}' files hold no derivatives; --derivatives FILE takes them", a.order,
                                 extension_of(a.out)));
  if (a.order == 0 && !a.derivatives.empty()) throw InputError("--derivatives needs --order 1 or 2");
  check_numbers(a, maps);
  if (places_only && a.outside == "nan")
    throw InputError(fmt::format("--outside nan: '{}' files hold no nan; use {}", extension_of(a.out),
                                 fmt::join(table_extensions, ", ")));
  if (!a.energies.empty() && !is_one_of(energy_extensions, a.energies))
    throw InputError(fmt::format("--energies {}: use {}", a.energies, fmt::join(energy_extensions, ", ")));
  check_standard_input(a);
  check_distinct(a, maps);
}

void check_shapes(const DeformArguments& a, const Mesh& mesh, int dimension) {
  const std::string extension = extension_of(a.out);
  const bool stl = extension == ".stl", svg = extension == ".svg";
  std::string reason;
  if (svg && dimension != 2) reason = "drawings lie in the plane, and the cage in space";
  else if (stl && mesh.faces.empty()) reason = fmt::format("STL is made of faces, and {} has none", a.points);
  else if (svg && mesh.segments.empty()) reason = fmt::format("SVG is made of polylines, and {} has none", a.points);
  if (reason.empty()) return;
  throw InputError(fmt::format("--out {}: {}; use .obj, .ply or {}", a.out, reason, fmt::join(table_extensions, ", ")));
}

MeshSource::MeshSource(const std::string& points) : file_(points), extension_(extension_of(points)) {
  if (extension_ == ".obj" || extension_ == ".ply") text_ = read_file(points);
}

bool MeshSource::is_carried_to(std::string_view extension) const {
  return extension == extension_ && (extension == ".obj" || extension == ".ply" || extension == ".vtp");
}

std::string MeshSource::with_images(const Mesh& mesh, const CoordinateColumns& images) {
  reports::CarriedMesh carried = extension_ == ".obj" ? reports::obj_with_vertices(text_, mesh.vertices)
                                 : extension_ == ".ply"
                                     ? reports::ply_with_vertices(text_, mesh.vertices)
                                     : reports::vtp_with_vertices(file_, mesh.vertices, field_of(images, mesh));
  say_left_out(carried.left_out, "which turn with the surface");
  say_left_out(carried.replaced, "in whose place this run's stand");
  return std::move(carried.text);
}

void MeshSource::say_left_out_of(std::string_view extension, const std::vector<std::string>& also) {
  std::vector<std::string> what = reports::beside_places(file_);
  what.insert(what.end(), also.begin(), also.end());
  const std::string_view kept = extension == ".stl"   ? "triangles"
                                : extension == ".svg" ? "polylines"
                                                      : "vertices, faces and polylines";
  say_left_out(what, fmt::format("since {} files are written with {} only", extension, kept));
}

void MeshSource::say_left_out(const std::vector<std::string>& what, std::string_view why) {
  if (!what.empty()) say(fmt::format("left out: {}, {}", fmt::join(what, ", "), why));
}

void MeshSource::say(const std::string& warning) {
  if (said_.insert(warning).second) fmt::print(stderr, "warning: {}: {}\n", file_, warning);
}

std::string MeshSource::text_of(const std::filesystem::path& file, const Mesh& mesh) {
  const std::string extension = extension_of(file);
  reports::PartialMeshText made;
  try {
    made = extension == ".stl" ? reports::stl_text(mesh) : reports::svg_text(mesh);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  say_left_out_of(extension, made.left_out);
  for (const std::string& change : made.changed) say(change);
  return std::move(made.text);
}

std::string text_for(const std::filesystem::path& file, const Mesh& mesh, const CoordinateColumns& images,
                     MeshSource& source) {
  const std::string extension = extension_of(file);
  if (source.is_carried_to(extension)) return source.with_images(mesh, images);
  if (extension == ".stl" || extension == ".svg") return source.text_of(file, mesh);
  if (is_one_of(mesh_extensions, file) || extension == ".vtp") source.say_left_out_of(extension);
  if (extension == ".obj") return reports::obj_text(mesh);
  if (extension == ".ply") return reports::ply_text(mesh);
  if (extension == ".npy") return npy_text(images);
  if (extension == ".vtp") return vtp_text(images, mesh);
  return csv_text(images);
}

std::string energies_text(const DeformArguments& a, const std::string& title, const std::vector<double>& energies) {
  return is_one_of(std::array{".png"}, a.energies) ? reports::energies_png(energies, title)
                                                   : reports::energies_csv(energies);
}

}  // namespace cageproof::cli
