// SPDX-License-Identifier: MIT
#include "conversions.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::library {
namespace {

Cage plain(const cageproof::Cage& cage) {
  Cage found;
  found.dimension = cage.dimension();
  found.name = cage.name();
  for (const Vec3<double>& v : cage.vertices())
    found.vertices.insert(found.vertices.end(), v.data(), v.data() + cage.dimension());
  for (const Face& face : cage.faces())
    found.faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
  return found;
}

}  // namespace

Cage read_obj(const std::string& file) {
  Mesh mesh = as_cage_mesh(read_mesh(file), file);
  Cage cage;
  cage.name = file;
  cage.warnings = std::move(mesh.warnings);
  cage.dimension = mesh.faces.empty() && !mesh.segments.empty() ? 2 : 3;
  if (cage.dimension == 2) check_plane(mesh, file);
  for (const Vec3<double>& v : mesh.vertices)
    cage.vertices.insert(cage.vertices.end(), v.data(), v.data() + cage.dimension);
  cage.faces = mesh.faces;
  for (const auto& [from, to] : mesh.segments)
    if (cage.dimension == 2) cage.faces.push_back({from, to});
  return cage;
}

Cage embedded_cage(const std::string& name) { return plain(cageproof::embedded_cage(name)); }

cageproof::Cage checked_cage(const Cage& cage, const Options& options) {
  if (cage.dimension != 2 && cage.dimension != 3)
    throw InputError(fmt::format("{}: a dimension of {}, not 2 or 3", cage.name, cage.dimension));
  std::vector<Face> faces;
  faces.reserve(cage.faces.size());
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int>& given = cage.faces[f];
    const std::size_t least = cage.dimension, most = cage.dimension == 2 ? 2 : 4;
    if (given.size() < least || given.size() > most)
      throw InputError(fmt::format("{}: face {} has {} vertices, not {} (faces counted from 0)", cage.name, f,
                                   given.size(), cage.dimension == 2 ? "2" : "3 or 4"));
    // -1 stands for none in a Face.
    if (const auto negative = std::ranges::find_if(given, [](int v) { return v < 0; }); negative != given.end())
      throw InputError(fmt::format("{}: face {}: index {} is out of range (faces and vertices counted from 0)",
                                   cage.name, f, *negative));
    std::ranges::copy(given, faces.emplace_back().vertices.begin());
  }
  std::vector<Vec3<double>> vertices = vectors_of(cage.vertices, cage.dimension, cage.name + ": vertices");
  CageOptions checked{.flip_inward = options.flip_inward, .allow_invalid_quads = options.allow_invalid_quads};
  return cage.dimension == 2
             ? cageproof::Cage::make_polygon(cage.name, std::move(vertices), std::move(faces), std::move(checked))
             : cageproof::Cage::make(cage.name, std::move(vertices), std::move(faces), std::move(checked));
}

Triangulation triangulation_of(const Options& options) {
  if (options.triangulation == "shortest") return Triangulation::Shortest;
  if (options.triangulation == "fan") return Triangulation::Fan;
  throw InputError(fmt::format("triangulation '{}' is none of shortest, fan", options.triangulation));
}

std::vector<double> parameters_of(const Options& options, const std::vector<KindParameter>& known,
                                  std::string_view owner) {
  return parameter_values(parameter_texts(options.parameters), known, {owner});
}

std::vector<Vec3<double>> vectors_of(std::span<const double> numbers, int dimension, std::string_view what) {
  const auto width = static_cast<std::size_t>(dimension);
  check_multiple(numbers.size(), width, what);
  std::vector<Vec3<double>> vectors(numbers.size() / width, Vec3<double>::Zero());
  for (std::size_t i = 0; i < numbers.size(); ++i) vectors[i / width][static_cast<int>(i % width)] = numbers[i];
  return vectors;
}

void check_multiple(std::size_t numbers, std::size_t of, std::string_view what) {
  if (numbers % of != 0) throw InputError(fmt::format("{}: {} numbers are no multiple of {}", what, numbers, of));
}

void check_size(std::size_t given, std::size_t wanted, std::string_view what) {
  if (given != wanted) throw InputError(fmt::format("{}: room for {} numbers, not {}", what, given, wanted));
}

void for_blocks(std::size_t points, int threads, const std::function<void(std::size_t, std::size_t)>& task) {
  for_each_parallel((points + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    const std::size_t first = block * kBlock;
    task(first, std::min(kBlock, points - first));
  });
}

}  // namespace cageproof::library
