// SPDX-License-Identifier: MIT
#include "coordinate_table.h"

#include "npz.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/reports/vtk_text.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/reused.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

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

// The memory that a block of points is computed in.
struct RowBuffer {
  std::vector<CoordinateTable<double>> tables;
  std::vector<double> rows;
};

std::size_t columns_of(const CageCoordinates& coordinates, int order) {
  std::size_t columns = 0;
  for (const CoordinateBlock& block : coordinates.blocks())
    for (int o = 0; o <= order; ++o)
      columns += static_cast<std::size_t>(block.size) * block.entries() * derivative_count(coordinates.dimension(), o);
  return columns;
}

}  // namespace

CoordinateColumns headed_columns(const CageCoordinates& coordinates, int order) {
  if (order > coordinates.max_order())
    throw InputError(fmt::format("{} by {} gives derivatives up to order {}, not {}", coordinates.kind().name,
                                 coordinates.evaluation(), coordinates.max_order(), order));
  CoordinateColumns table;
  for (const CoordinateBlock& block : coordinates.blocks())
    for (int o = 0; o <= order; ++o) add_columns(block, coordinates.elements(), o, table);
  return table;
}

std::size_t points_together(std::size_t columns) {
  // A block's numbers, and its rows once more.
  constexpr std::size_t bytes = std::size_t{1} << 26, least = 16, most = 64;
  return std::clamp(bytes / (sizeof(double) * columns), least, most);
}

void for_rows(const CageCoordinates& coordinates, std::span<const Vec3<double>> points, std::size_t first,
              std::size_t count, int order, int jobs, const TakeRows& take) {
  Reused<RowBuffer> buffers;
  const std::size_t columns = columns_of(coordinates, order), together = points_together(columns);
  for_each_parallel((count + together - 1) / together, jobs, [&](std::size_t part) {
    const std::size_t from = first + part * together, here = std::min(together, first + count - from);
    auto buffer = buffers.taken();
    auto& [tables, rows] = *buffer;
    coordinates.at(points.subspan(from, here), order, tables);
    rows.resize(here * columns);
    double* to = rows.data();
    for (std::size_t p = 0; p < here; ++p)
      for (const CoordinateTable<double>& block : tables)
        for (int o = 0; o <= order; ++o)
          to = std::copy_n(block.tensors[o].data() + p * block.stride[o], block.stride[o], to);
    take(from, here, rows);
  });
}

std::string csv_header(const CoordinateColumns& table) { return fmt::format("{}\n", fmt::join(table.names, ",")); }

void add_csv_rows(std::string& text, std::span<const double> rows, std::size_t columns) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // As format_scalar() writes it, without a string per number.
    if (std::isfinite(rows[i])) fmt::format_to(std::back_inserter(text), "{}", rows[i]);
    else text += format_scalar(rows[i]);
    text += (i + 1) % columns == 0 ? '\n' : ',';
  }
}

std::string csv_text(const CoordinateColumns& table) {
  std::string text = csv_header(table);
  add_csv_rows(text, table.values, table.names.size());
  return text;
}

std::string npy_header(std::size_t points, std::size_t columns) { return npy_header("<f8", {points, columns}); }

std::string npy_text(const CoordinateColumns& table) {
  static_assert(std::endian::native == std::endian::little);
  std::string text = npy_header(table.values.size() / table.names.size(), table.names.size());
  text.append(reinterpret_cast<const char*>(table.values.data()), table.values.size() * sizeof(double));
  return text;
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
