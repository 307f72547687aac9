// SPDX-License-Identifier: MIT
// Figures of cages and meshes from files.
#include "embedded_figures.h"

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/mesh_thinning.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view cage_ending = "_Cage.obj";
// Limit for a mesh's points, about as many as a panel shows; the coordinates of each cost milliseconds.
constexpr std::size_t most_figure_points = 16000;

std::vector<std::string> names_in(const fs::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (file.ends_with(cage_ending)) names.push_back(file.substr(0, file.size() - cage_ending.size()));
  }
  if (error) throw InputError(fmt::format("--data {}: {}", folder.string(), error.message()));
  if (names.empty()) throw InputError(fmt::format("--data {}: no file NAME{}", folder.string(), cage_ending));
  std::ranges::sort(names);
  return names;
}

// The faces all of whose vertices are inside the cage, or on it, and these vertices.
Mesh inside_of(const Cage& cage, const Mesh& mesh) {
  const CageElements elements(cage, false, Triangulation::Shortest);
  const WindingNumbers windings(elements);
  std::vector<char> inside;
  inside.reserve(mesh.vertices.size());
  for (const Vec3<double>& point : mesh.vertices)
    inside.push_back(static_cast<char>(windings.around(point).value_or(1) != 0));
  Mesh found;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (const auto& face : mesh.faces) {
    if (!std::ranges::all_of(face, [&](int v) { return inside[v] != 0; })) continue;
    std::vector<int> kept;
    kept.reserve(face.size());
    for (const int v : face) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(found.vertices.size());
        found.vertices.push_back(mesh.vertices[v]);
      }
      kept.push_back(number[v]);
    }
    found.faces.push_back(std::move(kept));
  }
  return found;
}

// \throws InputError where a polygon's points leave the plane
void require_in_plane(const fs::path& file, const std::vector<Vec3<double>>& points) {
  const auto found = std::ranges::find_if(points, [](const Vec3<double>& p) { return p[2] != 0; });
  if (found != points.end())
    throw InputError(fmt::format("{}: vertex {} has z = {}; the cage is a polygon, and z must be 0", file.string(),
                                 found - points.begin() + 1, (*found)[2]));
}

std::vector<PanelPlan> plane_panels(const std::vector<Vec3<double>>& posed) {
  std::vector<PanelPlan> panels{{.title = "at rest", .file = "rest"},
                                {.title = "mean value", .file = "mean_value", .method = "mean_value"},
                                {.title = "harmonic", .file = "harmonic", .method = "harmonic"},
                                {.title = "Green (Cauchy)", .file = "cauchy", .method = "cauchy"}};
  for (const std::string normals : {"unit", "complex"})
    panels.push_back({.title = normals == "unit" ? "biharmonic, unit normals" : "biharmonic, complex",
                      .file = "biharmonic_boundary." + normals,
                      .method = "biharmonic_boundary",
                      .parameters = {{"normals", normals}}});
  for (const std::string variant : {"global", "local"})
    panels.push_back({.title = "Somigliana, " + variant,
                      .file = "somigliana." + variant,
                      .method = "somigliana",
                      .parameters = {{"variant", variant}}});
  for (PanelPlan& panel : panels)
    if (!panel.method.empty()) panel.posed = posed;
  return panels;
}

DeformedPlan plan_of(const fs::path& folder, const std::string& name) {
  const fs::path files[]{folder / (name + std::string(cage_ending)), folder / (name + "_Cage_Deformed.obj"),
                         folder / (name + ".obj")};
  for (const fs::path& file : files)
    if (!fs::exists(file))
      throw InputError(fmt::format("{}: there is no such file, which goes with {}", file.string(), files[0].string()));
  const auto cage = std::make_shared<const Cage>(read_cage(files[0]));
  const std::vector<Vec3<double>> posed = read_mesh(files[1]).vertices;
  if (posed.size() != cage->vertices().size())
    throw InputError(fmt::format("{}: {} vertices, {} has {}", files[1].string(), posed.size(), files[0].string(),
                                 cage->vertices().size()));
  const Mesh whole = read_mesh(files[2]);
  if (cage->dimension() == 2) {
    require_in_plane(files[1], posed);
    require_in_plane(files[2], whole.vertices);
  }
  if (whole.faces.empty()) throw InputError(fmt::format("{}: no faces to draw", files[2].string()));
  const Mesh thin = reports::thinned(whole, most_figure_points);
  DeformedPlan plan{.name = name, .cage = cage, .mesh = {inside_of(*cage, thin), {}}, .sheets = {}};
  if (plan.mesh.mesh.faces.empty())
    throw InputError(fmt::format("{}: nothing of it is inside {}", files[2].string(), files[0].string()));
  const std::string about =
      fmt::format(" {} of the {} vertices of {} are shown, {} faces.", plan.mesh.mesh.vertices.size(),
                  whole.vertices.size(), files[2].filename().string(), plan.mesh.mesh.faces.size());
  if (cage->dimension() == 2) {
    plan.sheets.push_back(
        {.name = "w12-" + name,
         .heading = "Deformers of the plane compared: " + name,
         .source = "[W12] Figures 2, 5 and 6, [C23] Figure 10",
         .text =
             "One posed polygon (blue), and what each deformer makes of the mesh in it. Mean value and harmonic "
             "coordinates meet it; Green coordinates (Cauchy's) keep angles and leave it; biharmonic ones follow it "
             "with unit normals, or with normals stretched as edges are; Somigliana coordinates behave as an "
             "elastic body." +
             about,
         .columns = 4,
         .panels = plane_panels(posed)});
    return plan;
  }
  // Files of the field have y upwards.
  const reports::FigureView view{{0.45, 0.3, 1}, {0, 1, 0}};
  plan.sheets.push_back({.name = "t24-" + name,
                         .heading = "Deformers compared: " + name,
                         .source = "[T24] Figures 1 and 2, [C23] Figure 11",
                         .text = comparison_text() + about,
                         .columns = 4,
                         .panels = comparison_panels(posed),
                         .view = view});
  if (cage->has_quads() && accepts(coordinate_kind_named("quad_mean_value"), *cage))
    plan.sheets.front().panels.push_back(
        {.title = "mean value, quads", .file = "quad_mean_value", .method = "quad_mean_value", .posed = posed});
  for (const std::string variant : {"global", "local"})
    plan.sheets.push_back({.name = fmt::format("c23-{}-{}", name, variant),
                           .heading = fmt::format("Poisson's ratio and bulging: {}, {} variant", name, variant),
                           .source = "[C23] Figures 1, 2 and 5",
                           .text = elastic_text(variant) + about,
                           .columns = 4,
                           .panels = elastic_panels(posed, variant),
                           .view = view});
  return plan;
}

}  // namespace

PaperFigures figures_of_data(const fs::path& folder) {
  PaperFigures figures;
  for (const std::string& name : names_in(folder)) figures.push_back(deformed_figure(plan_of(folder, name)));
  return figures;
}

}  // namespace cageproof::validation
