// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/scalar_text.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/vtk_text.h"
#include "cageproof/validation/campaign.h"

#include <fmt/format.h>
#include <xtensor/xadapt.hpp>
#include <xtensor/xnpy.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <span>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, kind, evaluation = "closed_form", out;
  std::vector<std::string> parameters;
  int jobs = 0;
};

// Coordinates of all points, point by point, blocks one after the other.
struct Table {
  std::vector<std::string> columns;
  std::vector<double> values;
};

Table compute(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points, int jobs) {
  Table table;
  const auto& blocks = coordinates.kind().blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (int i = 0; i < coordinates.size(static_cast<int>(b)); ++i)
      for (int e = 0, width = coordinates.entries(static_cast<int>(b)); e < width; ++e)
        table.columns.push_back(width == 1 ? fmt::format("{}_{}", blocks[b].label, i)
                                           : fmt::format("{}_{}_{}{}", blocks[b].label, i, "xyz"[e / 3], "xyz"[e % 3]));
  table.values.resize(points.size() * table.columns.size());
  validation::for_each_parallel(points.size(), jobs, [&](std::size_t p) {
    double* to = &table.values[p * table.columns.size()];
    for (const Result<double>& block : coordinates.at<double>(points[p], 0)) to = std::ranges::copy(block.value, to).out;
  });
  return table;
}

std::string csv_text(const Table& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    text += format_scalar(table.values[i]);
    text += (i + 1) % table.columns.size() == 0 ? '\n' : ',';
  }
  return text;
}

std::string npy_text(const Table& table, std::size_t points) {
  const std::vector<std::size_t> shape{points, table.columns.size()};
  return xt::dump_npy(xt::adapt(table.values, shape));
}

std::string vtp_text(const Table& table, const CageCoordinates& coordinates, const Mesh& mesh) {
  MeshField field{"coordinates", mesh.vertices, mesh.faces, {}};
  const std::size_t columns = table.columns.size();
  std::size_t first = 0;
  for (std::size_t b = 0; b < coordinates.kind().blocks.size(); ++b) {
    const int size = coordinates.size(static_cast<int>(b)) * coordinates.entries(static_cast<int>(b));
    ImageField::Array array{std::string(coordinates.kind().blocks[b].label), "1", size, {}};
    for (std::size_t p = 0; p < mesh.vertices.size(); ++p)
      for (int i = 0; i < size; ++i) array.values.push_back(table.values[p * columns + first + i]);
    first += size;
    field.arrays.push_back(std::move(array));
  }
  return reports::vtp_text(field);
}

// Aside and renamed, so that no half file is left.
void write_whole(const std::string& path, const std::string& text) {
  const std::string aside = path + ".partial";
  try {
    reports::write_file(aside, text);
    std::filesystem::rename(aside, path);
  } catch (const std::filesystem::filesystem_error& e) {
    std::filesystem::remove(aside);
    throw InputError(fmt::format("cannot write {}: {}", path, e.code().message()));
  } catch (const InputError&) {
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    throw;
  }
}

void warn(const std::string& text) { fmt::print(stderr, "warning: {}\n", text); }

// Says how many points have no coordinates, and why.
void warn_of_missing(const Table& table, std::size_t points, const CoordinateKind& kind) {
  std::size_t missing = 0;
  for (std::size_t p = 0; p < points; ++p) {
    const auto row = std::span(table.values).subspan(p * table.columns.size(), table.columns.size());
    missing += std::ranges::any_of(row, [](double x) { return std::isnan(x); });
  }
  if (missing > 0)
    warn(fmt::format("{} of {} points have no {} coordinates (nan): {}", missing, points, kind.name,
                     kind.missing_because.empty() ? "the cage's quads are not valid there" : kind.missing_because));
}

int run(const Arguments& a) {
  const CoordinateKind* kind = find_coordinate_kind(a.kind);
  if (!kind) throw InputError(fmt::format("unknown kind of coordinates '{}'; see `cageproof list`", a.kind));
  if (a.cage.allow_invalid_quads && !kind->keeps_quads())
    throw InputError(fmt::format("--allow-invalid-quads: {} splits quads in triangles", kind->name));
  const std::string extension = std::filesystem::path(a.out).extension();
  if (!a.out.empty() && extension != ".csv" && extension != ".npy" && extension != ".vtp")
    throw InputError(fmt::format("{}: cannot write '{}' files; use .csv, .npy or .vtp", a.out, extension));
  const Cage cage = a.cage.load();
  if (cage.allows_invalid_quads())
    for (const std::string& fault : invalid_quads(cage)) warn(fmt::format("{}: {} (faces counted from 0)", cage.name(), fault));
  const Mesh mesh = load_points(a.points);
  const CageCoordinates coordinates(cage, *kind, a.evaluation, a.cage.rule(), parameters_from(a.parameters, parameters_of(*kind), kind->name));
  const Table table = compute(coordinates, mesh.vertices, a.jobs);
  warn_of_missing(table, mesh.vertices.size(), *kind);
  const std::string text = extension == ".npy"   ? npy_text(table, mesh.vertices.size())
                           : extension == ".vtp" ? vtp_text(table, coordinates, mesh)
                                                 : csv_text(table);
  if (a.out.empty()) std::cout << text;
  else write_whole(a.out, text);
  return all_kept;
}

}  // namespace

void add_coordinates(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("coordinates", "coordinates of points in a cage");
  auto a = std::make_shared<Arguments>();
  a->cage.add_to(*command, true);
  command->add_option("--points", a->points, "a mesh, or text with three numbers a line")->required();
  command->add_option("--kind", a->kind, "mean_value, quad_mean_value, spherical_mean_value, maximum_entropy, green, biharmonic or somigliana")
      ->required();
  command->add_flag("--allow-invalid-quads", a->cage.allow_invalid_quads, "compute with quads that are not valid, of kinds that keep quads");
  command->add_option("--parameter", a->parameters, "mu=..., nu=... of somigliana; nu in (-1, 0.5] or inf or -inf");
  command->add_option("--evaluation", a->evaluation, "how its formulas are evaluated")->capture_default_str();
  command->add_option("--out", a->out, ".csv, .npy (points x coordinates) or .vtp; CSV on standard output if not given");
  command->add_option("--jobs", a->jobs, "threads; 0: all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  command->callback([&action, a] { action = [a] { return run(*a); }; });
}

}  // namespace cageproof::cli
