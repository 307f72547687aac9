// SPDX-License-Identifier: MIT
#include "coordinate_table.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/reports/vtk_text.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <xtensor/xadapt.hpp>
#include <xtensor/xnpy.hpp>

#include <algorithm>
#include <atomic>

namespace cageproof::cli {
namespace {

constexpr const char* axes = "xyz";

// "", "_dx", "_dxy": the derivative that entry i of the last indices is.
std::string derivative_name(std::size_t i, int dim, int order) {
  std::string letters(order, ' ');
  for (int o = order - 1; o >= 0; --o, i /= dim) letters[o] = axes[i % dim];
  return order == 0 ? "" : "_d" + letters;
}

// "" of a number, "_xy" of a matrix's entry.
std::string entry_name(int entry, const Shape& shape) {
  return shape.entries() == 1 ? "" : fmt::format("_{}{}", axes[entry / shape.columns], axes[entry % shape.columns]);
}

// "phi_7" of a vertex or element, "psi_7_2" of an element's corner, or of the normal there.
std::string coordinate_name(const CoordinateBlock& block, const CageElements& elements, int i) {
  if (block.owner == Owner::Vertex || block.owner == Owner::Element) return fmt::format("{}_{}", block.label, i);
  const std::size_t element = elements.element_of(i, block.owner);
  if (block.owner == Owner::Normal && elements.type(element).flat) return fmt::format("{}_{}", block.label, element);
  return fmt::format("{}_{}_{}", block.label, element, i - elements.shares_of(element, block.owner).front());
}

void add_columns(const CoordinateBlock& block, const CageElements& elements, int order, CoordinateColumns& table) {
  constexpr std::array titles{"", " gradient", " Hessian"};
  const int dim = elements.dimension();
  const std::size_t first = table.names.size();
  for (int i = 0; i < block.size; ++i)
    for (int e = 0; e < block.entries(); ++e)
      for (std::size_t d = 0; d < derivative_count(dim, order); ++d)
        table.names.push_back(coordinate_name(block, elements, i) + entry_name(e, block.shape) +
                              derivative_name(d, dim, order));
  constexpr std::array words{"", "_gradient", "_hessian"};
  std::vector<std::size_t> shape{static_cast<std::size_t>(block.size)};
  for (const int entries : {block.shape.rows, block.shape.columns})
    if (block.entries() > 1) shape.push_back(entries);
  shape.insert(shape.end(), order, dim);
  table.groups.push_back(
      {block.label + titles[order], table.names.size() - first, block.label + words[order], std::move(shape)});
}

}  // namespace

CoordinateColumns coordinate_columns(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points,
                                     int order, int jobs, const std::function<void(std::size_t)>& progress) {
  if (order > coordinates.max_order())
    throw InputError(fmt::format("{} by {} gives derivatives up to order {}, not {}", coordinates.kind().name,
                                 coordinates.evaluation(), coordinates.max_order(), order));
  CoordinateColumns table;
  for (const CoordinateBlock& block : coordinates.blocks())
    for (int o = 0; o <= order; ++o) add_columns(block, coordinates.elements(), o, table);
  const std::size_t columns = table.names.size();
  table.values.resize(points.size() * columns);
  // Blocks of points share what evaluations prepare for an element.
  constexpr std::size_t together = 64;
  std::atomic<std::size_t> done = 0;
  for_each_parallel((points.size() + together - 1) / together, jobs, [&](std::size_t part) {
    const std::size_t first = part * together, count = std::min(together, points.size() - first);
    const auto found = coordinates.at<double>(std::span(points).subspan(first, count), order);
    for (std::size_t p = 0; p < count; ++p) {
      double* to = &table.values[(first + p) * columns];
      for (const CoordinateTable<double>& block : found)
        for (int o = 0; o <= order; ++o)
          to = std::copy_n(block.tensors[o].data() + p * block.stride[o], block.stride[o], to);
    }
    done += count;
    if (progress) progress(done);
  });
  return table;
}

std::string csv_text(const CoordinateColumns& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.names, ","));
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    text += format_scalar(table.values[i]);
    text += (i + 1) % table.names.size() == 0 ? '\n' : ',';
  }
  return text;
}

std::string npy_text(const CoordinateColumns& table) {
  const std::vector<std::size_t> shape{table.values.size() / table.names.size(), table.names.size()};
  return xt::dump_npy(xt::adapt(table.values, shape));
}

MeshField field_of(const CoordinateColumns& table, const Mesh& mesh) {
  MeshField field{"coordinates", mesh.vertices, mesh.faces, {}, mesh.segments};
  const std::size_t columns = table.names.size();
  std::size_t first = 0;
  for (const CoordinateColumns::Group& group : table.groups) {
    ImageField::Array array{group.label, "1", static_cast<int>(group.columns), {}};
    for (std::size_t p = 0; p < mesh.vertices.size(); ++p)
      for (std::size_t i = 0; i < group.columns; ++i) array.values.push_back(table.values[p * columns + first + i]);
    first += group.columns;
    field.arrays.push_back(std::move(array));
  }
  return field;
}

std::string vtp_text(const CoordinateColumns& table, const Mesh& mesh) {
  return reports::vtp_text(field_of(table, mesh));
}

std::string vtp_text(const CoordinateColumns& table, const Mesh& mesh, const reports::DescribedCage& cage) {
  return reports::vtp_text_with_cage(field_of(table, mesh), cage);
}

}  // namespace cageproof::cli
