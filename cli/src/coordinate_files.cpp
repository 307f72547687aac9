// SPDX-License-Identifier: MIT
#include "coordinate_files.h"

#include "inputs_outside.h"
#include "npz.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/memory.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xtensor/xadapt.hpp>
#include <xtensor/xnpy.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace cageproof::cli {
namespace {

using Json = nlohmann::ordered_json;
using Members = std::vector<std::pair<std::string, std::string>>;

template <class T>
std::string npy_of(const std::vector<T>& values, const std::vector<std::size_t>& shape) {
  return xt::dump_npy(xt::adapt(values, shape));
}

template <class T>
void add(Members& members, const std::string& name, const std::vector<T>& values,
         const std::vector<std::size_t>& shape) {
  members.emplace_back(name + ".npy", npy_of(values, shape));
}

void add_vectors(Members& members, const std::string& name, const std::vector<Vec3<double>>& rows, int dimension) {
  std::vector<double> values;
  values.reserve(rows.size() * dimension);
  for (const Vec3<double>& row : rows) values.insert(values.end(), row.data(), row.data() + dimension);
  add(members, name, values, {rows.size(), static_cast<std::size_t>(dimension)});
}

void add_elements(Members& members, const reports::DescribedCage& cage) {
  std::size_t most = 0;
  for (const auto& element : cage.elements) most = std::max(most, element.size());
  std::vector<std::int64_t> corners;
  for (const auto& element : cage.elements)
    for (std::size_t k = 0; k < most; ++k) corners.push_back(k < element.size() ? element[k] : -1);
  add(members, "elements", corners, {cage.elements.size(), most});
  add(members, "element_faces", std::vector<std::int64_t>(cage.faces.begin(), cage.faces.end()), {cage.faces.size()});
}

// The owner of each coordinate of a block, where that is neither a vertex nor an element.
void add_corners(Members& members, const CoordinateBlock& block, const CageElements& elements) {
  if (block.owner == Owner::Vertex || block.owner == Owner::Element) return;
  std::vector<std::int64_t> element_of, vertex_of;
  std::vector<Vec3<double>> normals;
  element_of.reserve(block.size);
  vertex_of.reserve(block.size);
  normals.reserve(block.size);
  for (int i = 0; i < block.size; ++i) {
    const std::size_t e = elements.element_of(i, block.owner);
    element_of.push_back(static_cast<std::int64_t>(e));
    // A flat element's one normal belongs to no vertex.
    const bool whole = block.owner == Owner::Normal && elements.type(e).flat;
    vertex_of.push_back(whole ? -1 : elements.vertices_of(e)[i - elements.shares_of(e, block.owner).front()]);
    normals.push_back(elements.normal_of(i, block.owner));
  }
  const std::size_t count = element_of.size();
  add(members, block.label + "_elements", element_of, {count});
  add(members, block.label + "_vertices", vertex_of, {count});
  if (block.owner == Owner::Normal) add_vectors(members, block.label + "_normals", normals, elements.dimension());
}

std::string npz_text(const CoordinateColumns& table, const Mesh& mesh, const reports::DescribedCage& cage,
                     const CageCoordinates& coordinates) {
  Members members;
  const std::size_t columns = table.names.size(), points = mesh.vertices.size();
  std::size_t first = 0;
  for (const CoordinateColumns::Group& group : table.groups) {
    std::vector<double> values(points * group.columns);
    for (std::size_t p = 0; p < points; ++p)
      std::copy_n(&table.values[p * columns + first], group.columns, &values[p * group.columns]);
    std::vector<std::size_t> shape{points};
    shape.insert(shape.end(), group.shape.begin(), group.shape.end());
    add(members, group.array, values, shape);
    first += group.columns;
  }
  for (const CoordinateBlock& block : coordinates.blocks()) add_corners(members, block, coordinates.elements());
  add_vectors(members, "points", mesh.vertices, cage.dimension);
  std::ranges::move(cage_members(cage), std::back_inserter(members));
  return zip_text(members);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> cage_members(const reports::DescribedCage& cage) {
  Members members;
  add_vectors(members, "cage_vertices", cage.vertices, cage.dimension);
  add_elements(members, cage);
  add_vectors(members, "element_normals", cage.normals, cage.dimension);
  add(members, cage.dimension == 2 ? "element_lengths" : "element_areas", cage.measures, {cage.measures.size()});
  members.emplace_back("metadata.json", cage.metadata + '\n');
  return members;
}

std::string coordinate_extensions() { return ".csv, .npy, .npz or .vtp"; }

std::filesystem::path companion_of(const std::filesystem::path& out) {
  const std::string extension = extension_of(out);
  if (extension == ".npz") return {};
  return std::filesystem::path(out).replace_extension(extension == ".vtp" ? ".cage.vtp" : ".json");
}

void check_coordinate_files(const std::filesystem::path& out,
                            const std::vector<std::pair<std::string, std::string>>& others) {
  const std::string extension = extension_of(out);
  if (extension != ".csv" && extension != ".npy" && extension != ".npz" && extension != ".vtp")
    throw InputError(
        fmt::format("{}: cannot write '{}' files; use {}", out.string(), extension, coordinate_extensions()));
  const std::filesystem::path companion = companion_of(out);
  for (const auto& [file, option] : others) {
    if (file.empty()) continue;
    const auto other = place_of(file);
    if (other == place_of(out)) throw InputError(fmt::format("{}: --out is the file of {}, too", out.string(), option));
    if (!companion.empty() && other == place_of(companion))
      throw InputError(fmt::format("{}: is written next to {}, and is also the file of {}", companion.string(),
                                   out.string(), option));
  }
  std::vector<std::filesystem::path> written{out};
  if (!companion.empty()) written.push_back(companion);
  reports::require_writable(written);
  if (companion.empty() || !std::filesystem::is_regular_file(companion)) return;
  const std::string_view mark = extension == ".vtp" ? reports::metadata_array : coordinates_schema;
  if (read_file(companion).find(mark) == std::string::npos)
    throw InputError(fmt::format(
        "{}: the description of {} goes to this file, which is no such description; choose another --out, or move it",
        companion.string(), out.string()));
}

std::vector<std::pair<std::filesystem::path, std::string>> coordinate_files(
    const std::filesystem::path& out, const CoordinateColumns& table, const Mesh& mesh, reports::DescribedCage cage,
    const Json& description, const CageCoordinates& coordinates) {
  const std::string extension = extension_of(out);
  cage.metadata = description.dump(2);
  if (extension == ".npz") return {{out, npz_text(table, mesh, cage, coordinates)}};
  return {{out, vtp_text(table, mesh, cage)}, {companion_of(out), reports::cage_vtp_text(cage)}};
}

std::pair<std::filesystem::path, std::string> description_file(const std::filesystem::path& out,
                                                               const reports::DescribedCage& cage,
                                                               const Json& description) {
  Json whole = description;
  whole.update(geometry_json(cage));
  return {companion_of(out), whole.dump() + '\n'};
}

void require_memory_for(const std::filesystem::path& out, std::size_t points, std::size_t columns) {
  // The table, its arrays, and the file's text: of .npz as large each, of .vtp by four thirds.
  const double copies = extension_of(out) == ".npz" ? 3 : 4;
  const double table = static_cast<double>(points) * static_cast<double>(columns) * sizeof(double);
  require_memory(copies * table,
                 fmt::format("{}: a table of {} points with {} numbers each has {}, and making this file", out.string(),
                             points, columns, size_text(table)),
                 "write .npy or .csv, which are written by blocks of points, or let `deform` apply coordinates without "
                 "keeping them");
}

}  // namespace cageproof::cli
