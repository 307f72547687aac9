// SPDX-License-Identifier: MIT
#include "commands.h"
#include "coordinate_table.h"
#include "inputs_outside.h"
#include "progress.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/cage/point_places.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, out;
  bool keep_quads = false, any_mesh = false;
  int jobs = 0;
};

// The surface: a cage, or with --any-mesh the faces of a file, closed or not.
struct Surface {
  PointPlaces places;
  int dimension;
};

Surface surface_of(const Arguments& a) {
  if (!a.any_mesh || is_embedded_cage(a.cage.file)) {
    const Cage cage = a.cage.load();
    return {PointPlaces(cage, a.keep_quads, a.cage.rule()), cage.dimension()};
  }
  if (a.keep_quads || a.cage.flip_inward || !std::isnan(a.cage.merge))
    throw InputError("--any-mesh takes faces as they are: without --keep-quads, --flip-inward and --merge");
  const Mesh mesh = read_mesh(a.cage.file);
  for (const std::string& warning : mesh.warnings) fmt::print(stderr, "warning: {}\n", warning);
  if (mesh.faces.empty()) throw InputError(fmt::format("{}: no faces", a.cage.file));
  try {
    return {PointPlaces(mesh.vertices, mesh.faces), 3};
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", a.cage.file, e.what()));
  }
}

std::string csv_of(const std::vector<PointPlace>& places) {
  std::string text = "place,face,winding_number,bound\n";
  for (const PointPlace& at : places)
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", name_of(at.place), at.face, at.winding, at.bound);
  return text;
}

std::string npy_of(const std::vector<PointPlace>& places) {
  CoordinateColumns table{.names = {"place", "face", "winding_number", "bound"}, .values = {}, .groups = {}};
  for (const PointPlace& at : places)
    table.values.insert(table.values.end(),
                        {static_cast<double>(at.place), static_cast<double>(at.face), at.winding, at.bound});
  return npy_text(table);
}

int run(const Arguments& a) {
  require_one_reader_of_input({{a.cage.file, "--cage"}, {a.points, "--points"}});
  const std::string extension = a.out.empty() ? ".csv" : extension_of(a.out);
  if (extension != ".csv" && extension != ".npy") throw InputError(fmt::format("--out {}: .csv or .npy", a.out));
  if (!a.out.empty()) {
    reports::require_writable({a.out});
    for (const auto& [file, option] : {std::pair(a.cage.file, "--cage"), {a.points, "--points"}})
      if (place_of(file) == place_of(a.out))
        throw InputError(fmt::format("{}: --out is the file of {}, too", a.out, option));
  }
  const Surface surface = surface_of(a);
  const std::vector<Vec3<double>> points = load_points(a.points, surface.dimension).vertices;
  std::vector<PointPlace> places(points.size());
  constexpr std::size_t together = 256;
  for_each_parallel((points.size() + together - 1) / together, a.jobs, [&](std::size_t block) {
    for (std::size_t p = block * together; p < std::min(points.size(), (block + 1) * together); ++p)
      places[p] = surface.places.at(points[p]);
  });
  const std::string text = extension == ".npy" ? npy_of(places) : csv_of(places);
  if (a.out.empty()) std::cout << text;
  else reports::replace_file(a.out, text);
  std::array<std::size_t, 3> counts{};
  double bound = 0;
  for (const PointPlace& at : places) {
    const int slot = static_cast<int>(at.place) + 1;
    ++counts[static_cast<std::size_t>(slot)];
    bound = std::max(bound, at.bound);
  }
  const std::string how = surface.places.is_closed() ? "exactly" : fmt::format("winding numbers to {:.2g}", bound);
  remark(fmt::format("{} inside, {} on, {} outside, {}", counts[2], counts[1], counts[0], how));
  return success;
}

}  // namespace

void add_inside(CommandLine& line) {
  Command command = line.command("inside", "decide exactly whether points are inside a cage or mesh, on it or outside");
  auto a = std::make_shared<Arguments>();
  command.heading("Cage and points");
  a->cage.add_to(command, true);
  command
      .option("--points", a->points,
              "a mesh, .npy, .npz, or text with three numbers per line, for polygons two; - is standard input" +
                  std::string(y_of_points))
      .taking("FILE")
      .required();
  command.flag("--any-mesh", a->any_mesh,
               "accept open, overlapping or inconsistently oriented faces; a point is inside if its winding number is "
               "above 1/2 or below -1/2");
  command.flag("--keep-quads", a->keep_quads, "keep quads as bilinear surfaces");
  command.heading("Output");
  command
      .option(
          "--out", a->out,
          ".csv, or .npy (points x 4: 1 inside, 0 on, -1 outside; the face, -1 for none; winding number; its bound); "
          "CSV on standard output if not given")
      .taking("FILE");
  command.heading("Running");
  command.option("--jobs", a->jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  add_quiet(command);
  command.example("cageproof inside --cage cube --points points.csv");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
