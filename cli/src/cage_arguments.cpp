// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace cageproof::cli {
namespace {

// SVG gives a polygon's direction no meaning, and readers of GeoJSON should not refuse either (RFC 7946, 3.1.6).
bool is_drawn_either_way(const std::string& file) {
  constexpr std::array<std::string_view, 3> extensions{".svg", ".geojson", ".json"};
  return std::ranges::find(extensions, extension_of(file)) != extensions.end();
}

Mesh say_warnings(Mesh mesh) {
  for (const std::string& warning : mesh.warnings) fmt::print(stderr, "warning: {}\n", warning);
  return mesh;
}

}  // namespace

Option CageArguments::add_to(Command command, bool required) {
  Option cage = command
                    .option("--cage", file,
                            "cage: a file (OBJ, PLY, STL, OFF, VTP; polygons: SVG, GeoJSON, OBJ, VTP), or the name of "
                            "an embedded cage")
                    .required(required)
                    .taking("CAGE");
  command.flag("--flip-inward", flip_inward,
               "reverse a cage whose normals point inward, or a polygon that runs clockwise");
  command
      .option("--merge", merge,
              "join vertices of the cage's file that lie within this distance of each other, in its unit of length; "
              "0: those in one place")
      .taking("DISTANCE");
  command
      .option("--triangulate", triangulate,
              "how quads become triangles: shortest diagonal, or fan from the first corner")
      .one_of({"shortest", "fan"})
      .showing_default();
  return cage;
}

CageArguments::Merged CageArguments::load_merged() const {
  if (merge < 0) throw InputError(fmt::format("--merge {}: a distance must be 0 or more", merge));
  const auto names = embedded_cage_names();
  if (is_embedded_cage(file)) return {embedded_cage(file), std::nullopt};
  if (std::filesystem::path(file).extension().empty() && !std::filesystem::exists(file)) {
    const std::string_view nearest = nearest_name(file, names);
    throw InputError(
        fmt::format("--cage {}: no such file, and no embedded cage of that name{} ({}, and extreme ones, "
                    "see `cageproof list`)",
                    file, nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest), fmt::join(names, ", ")));
  }
  Mesh mesh = read_mesh(file);
  std::optional<Merging> merging;
  if (!std::isnan(merge)) {
    merging = merging_of(mesh.vertices, merge);
    mesh = merged(std::move(mesh), *merging, file);
  }
  Cage cage =
      cage_from(say_warnings(as_cage_mesh(std::move(mesh), file)), file,
                {.flip_inward = flip_inward || is_drawn_either_way(file), .allow_invalid_quads = allow_invalid_quads});
  for (const auto& warning : {folding_warning(cage), meeting_warning(cage), crossing_warning(cage)})
    if (warning) fmt::print(stderr, "warning: {}\n", *warning);
  return {std::move(cage), std::move(merging)};
}

std::vector<double> parameters_from(const std::vector<std::string>& given, const std::vector<KindParameter>& known,
                                    std::string_view owner) {
  return parameter_values(given, known, {owner, "--parameter"});
}

std::vector<std::vector<double>> parameter_sets_from(const std::vector<std::string>& given,
                                                     const std::vector<KindParameter>& known, std::string_view owner) {
  return parameter_sets(given, known, {owner, "--parameter"});
}

Mesh load_points(const std::string& file, int dimension) {
  Mesh mesh = say_warnings(read_points_and_faces(file, dimension));
  return mesh;
}

}  // namespace cageproof::cli
