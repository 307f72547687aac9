// SPDX-License-Identifier: MIT
#include "cageproof/reports/report_writer.h"

#include "cageproof/reports/worst_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/journal.h"
#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/summary.h"
#include "colours.h"
#include "curve_picture.h"
#include "field_page.h"
#include "field_picture.h"
#include "figure.h"
#include "gnuplot.h"
#include "page/pages.h"
#include "paraview_state.h"
#include "report_folder.h"
#include "tables.h"
#include "worst_places.h"
#include "cageproof/reports/vtk_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace cageproof::reports {

struct ReportWriter::State {
  State(const std::filesystem::path& out, Kind what)
      : kind(what), folder(out, what == Kind::Field ? field_kind() : report_kind()) {}
  Kind kind;
  ReportFolder folder;
  std::set<std::string> names;    ///< of fields, so that none overwrites another
  std::vector<Picture> pictures;  ///< drawn by write(), all at once
  std::vector<FigureEntry> figures;
  bool has_page = false;  ///< field.html

  // Fields whose names differ only in characters that file names cannot hold get different files.
  std::string fresh_name(const std::string& name) {
    std::string fresh = file_name(name);
    for (int n = 2; !names.insert(fresh).second; ++n) fresh = fmt::format("{}-{}", file_name(name), n);
    return fresh;
  }
};

namespace {

// Files by name, in folders that are made for them.
void write_files(const std::filesystem::path& folder, const std::map<std::string, std::string>& files) {
  std::error_code ignored;
  for (const auto& [name, text] : files) {
    const std::filesystem::path path = folder / name;
    std::filesystem::create_directory(path.parent_path(), ignored);
    write_file(path, text);
  }
}

}  // namespace

ReportWriter::ReportWriter(const std::filesystem::path& out, Kind kind) : state_(std::make_unique<State>(out, kind)) {}
ReportWriter::~ReportWriter() = default;

FieldEntry ReportWriter::write_image(const ImageField& field, const std::string& title, const std::string& shown,
                                     ColourScale scale, std::optional<ColourLimits> limits, const MeshField* outline) {
  const std::size_t samples = static_cast<std::size_t>(field.points[0]) * field.points[1] * field.points[2];
  const ImageField::Array& array = array_named(field.arrays, shown, samples);
  const Colours colours = colours_of(array, scale, limits);
  const std::string name = state_->fresh_name(field.name);
  FieldEntry entry{title, array.unit, "fields/" + name + ".vti", "pictures/field." + name + ".png", colours.largest};
  write_file(state_->folder.path() / entry.data, vti_text(field, FieldArrays::WithLogarithms));
  state_->pictures.push_back(image_picture(field, colours, title, entry.picture, outline));
  return entry;
}

FieldEntry ReportWriter::write_mesh(const MeshField& field, const std::string& title, const std::string& shown,
                                    ColourScale scale) {
  const ImageField::Array& array = array_named(field.arrays, shown, field.vertices.size());
  const Colours colours = colours_of(array, scale);
  const std::string name = state_->fresh_name(field.name);
  FieldEntry entry{title, array.unit, "fields/" + name + ".vtp", "pictures/field." + name + ".png", colours.largest};
  write_file(state_->folder.path() / entry.data, vtp_text(field, FieldArrays::WithLogarithms));
  state_->pictures.push_back(mesh_picture(field, colours, title, entry.picture));
  return entry;
}

std::vector<FieldEntry> ReportWriter::write_scene(const FieldScene& scene) {
  constexpr ColourLimits limits{1e-17, 1};
  const std::filesystem::path& folder = state_->folder.path();
  // The picture shows one evaluation, and says which.
  const std::string pictured = fmt::format("{}: error of {}", scene.title.substr(0, scene.title.find(": errors of ")),
                                           short_name(scene.compared.front()));
  std::vector<FieldEntry> entries{
      write_image(scene.image, pictured, scene.compared.front(), ColourScale::Log10, limits, &scene.cage)};
  FieldEntry& image = entries.front();
  image.title = scene.title;
  const auto name_of = [](const std::string& path) { return path.substr(path.find('/') + 1); };
  const std::string stem = name_of(image.data).substr(0, name_of(image.data).size() - 4);
  SceneFiles files{name_of(image.data), stem + ".cage.vtp", ""};
  std::vector<std::string> data{image.data, "fields/" + files.cage};
  MeshField cage = geometry_of(scene.cage);
  cage.facts = scene.image.facts;
  write_file(folder / data.back(), vtp_text(cage));
  if (!scene.mesh.vertices.empty()) {
    entries.push_back(
        write_mesh(scene.mesh, scene.title + ", on the mesh", scene.compared.front(), ColourScale::Log10));
    files.mesh = name_of(entries.back().data);
    data.push_back(entries.back().data);
  }
  const std::string state = "fields/" + stem + ".pvsm";
  write_file(folder / state, paraview_state(scene, files));
  data.push_back(state);
  const std::string page = state_->has_page ? "" : "field.html";
  if (!page.empty()) write_file(folder / page, field_page(scene, entries.front().picture, data));
  state_->has_page = true;
  for (FieldEntry& entry : entries) entry.page = page, entry.state = state;
  return entries;
}

FieldEntry unwritten_entry(const std::vector<ImageField::Array>& arrays, const std::string& title,
                           const std::string& shown, ColourScale scale) {
  const auto array = std::ranges::find(arrays, shown, &ImageField::Array::name);
  if (array == arrays.end()) throw std::invalid_argument(fmt::format("no array '{}'", shown));
  return {title, array->unit, {}, {}, colours_of(*array, scale).largest};
}

void ReportWriter::write_figure(FigureSheet sheet) {
  std::error_code error;
  std::filesystem::create_directory(state_->folder.path() / "figures", error);
  state_->figures.push_back(reports::write_figure(state_->folder.path(), std::move(sheet)));
}

std::vector<std::string> ReportWriter::write(const RunResult& result) {
  const std::vector<CurvePicture> curves = curve_pictures(result);
  std::vector<Picture> pictures = std::move(state_->pictures);
  for (const CurvePicture& curve : curves) pictures.push_back(curve.picture);
  std::vector<std::string> undrawn = draw(pictures, state_->folder.path());
  if (undrawn.empty()) {
    write_text(result, curves);
    return undrawn;
  }
  // Gnuplot's failures depend on the machine, as the notes of sessions do.
  RunResult noted = result;
  noted.session_notes.insert(noted.session_notes.end(), undrawn.begin(), undrawn.end());
  write_text(noted, curves);
  return undrawn;
}

void ReportWriter::write_text(const RunResult& result, const std::vector<CurvePicture>& curves) {
  const std::filesystem::path& folder = state_->folder.path();
  Packer summary;
  put_summary(result, state_->kind == Kind::Field ? "cageproof-field" : "cageproof-summary",
              [&](std::string_view part) { summary.add(part); });
  write_file(folder / summary_file, summary.finish());
  write_file(folder / "summary.md", summary_markdown(result, state_->figures));
  write_file(folder / "results.csv.gz", packed(results_csv(result)));
  write_files(folder, worst_files(result));
  write_files(folder, pages(result, curves, state_->figures));
  if (!state_->figures.empty()) write_file(folder / "figures/figures.json", figures_json(state_->figures));
}

void ReportWriter::write_journal(const Journal& journal) {
  Packer packer;
  put_journal(journal, [&](std::string_view line) { packer.add(line); });
  write_file(state_->folder.path() / journal_file, packer.finish());
}

void ReportWriter::commit() { state_->folder.commit(); }

}  // namespace cageproof::reports
