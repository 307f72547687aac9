// SPDX-License-Identifier: MIT
#include "deformation.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/inside.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::cli {

using namespace deformation;
namespace {

constexpr std::array axes{"x", "y", "z"};

CoordinateColumns columns_of(int dimension, int order) {
  CoordinateColumns table;
  static constexpr std::array labels{"image", "image gradient", "image Hessian"};
  for (int o = 0; o <= order; ++o) {
    const std::size_t before = table.names.size();
    for (int c = 0; c < dimension; ++c) {
      if (o == 0) table.names.emplace_back(axes[c]);
      for (int i = 0; o >= 1 && i < dimension; ++i) {
        if (o == 1) table.names.push_back(fmt::format("{}_d{}", axes[c], axes[i]));
        for (int j = 0; o == 2 && j < dimension; ++j)
          table.names.push_back(fmt::format("{}_d{}{}", axes[c], axes[i], axes[j]));
      }
    }
    table.groups.push_back({labels[o], table.names.size() - before});
  }
  return table;
}

// A point's numbers in a row of the table.
void put_row(const Images<double>& images, std::size_t p, int dimension, int order, std::span<double> row) {
  std::size_t column = 0;
  for (int o = 0; o <= order; ++o) {
    const std::size_t count = dimension * derivative_count(dimension, o);
    std::copy_n(&images.tensors[o][p * count], count, row.begin() + static_cast<std::ptrdiff_t>(column));
    column += count;
  }
}

// The point itself, and the derivatives of the identity.
void put_rest(const Vec3<double>& point, int dimension, int order, std::span<double> row) {
  std::ranges::fill(row, 0.0);
  for (int c = 0; c < dimension; ++c) {
    row[c] = point[c];
    if (order >= 1) row[dimension + c * dimension + c] = 1;
  }
}

// Points without coordinates are NaN.
bool has_coordinates(const std::vector<CoordinateTable<double>>& tables, std::size_t p) {
  return std::ranges::none_of(tables, [&](const CoordinateTable<double>& table) {
    const auto row = std::span(table.tensors[0]).subspan(p * table.stride[0], table.stride[0]);
    return std::ranges::any_of(row, [](double x) { return std::isnan(x); });
  });
}

}  // namespace

std::vector<Deformed> deform(const CageCoordinates& coordinates, const Cage& cage, const Mesh& mesh, const Maps& maps,
                             int order, OutsidePolicy outside, int jobs) {
  const int d = coordinates.dimension();
  std::vector<Deformed> all(maps.size());
  const CoordinateColumns empty = columns_of(d, order);
  const std::size_t columns = empty.names.size(), points = mesh.vertices.size();
  for (Deformed& one : all) {
    one.table = empty;
    one.table.values.resize(points * columns);
    one.mesh = mesh;
  }
  // Normalised coordinates sum to one everywhere.
  const std::optional<Inside> inside =
      coordinates.kind().normalised ? std::nullopt : std::optional<Inside>(coordinates.elements());
  std::vector<char> missing(points);
  std::vector<std::size_t> beyond(points);  // a map whose image is not finite, from 1 on
  constexpr std::size_t together = 128;
  for_each_parallel((points + together - 1) / together, jobs, [&](std::size_t block) {
    const std::size_t first = block * together, count = std::min(together, points - first);
    const auto tables = coordinates.at<double>(std::span(mesh.vertices).subspan(first, count), order);
    for (std::size_t p = 0; p < count; ++p)
      missing[first + p] = (inside && !inside->holds(mesh.vertices[first + p])) || !has_coordinates(tables, p);
    for (std::size_t k = 0; k < maps.size(); ++k) {
      Deformed& one = all[k];
      const Images<double> images = maps[k]->images(tables, count, order);
      for (std::size_t p = 0; p < count; ++p) {
        const std::span<double> row = std::span(one.table.values).subspan((first + p) * columns, columns);
        put_row(images, p, d, order, row);
        const bool lost = missing[first + p];
        // On the cage derivatives may be nan; values are not.
        if (!lost && !std::ranges::all_of(row.first(d), [](double x) { return std::isfinite(x); }))
          beyond[first + p] = k + 1;
        if (lost && outside == OutsidePolicy::Rest) put_rest(mesh.vertices[first + p], d, order, row);
        if (lost && outside != OutsidePolicy::Rest) std::ranges::fill(row, std::numeric_limits<double>::quiet_NaN());
        for (int c = 0; c < d; ++c) one.mesh.vertices[first + p][c] = row[c];
      }
    }
  });
  if (const auto which = std::ranges::find_if(beyond, [](std::size_t k) { return k > 0; }); which != beyond.end())
    throw InputError(fmt::format(
        "{}the image of point number {} is not finite: the pose or a parameter is beyond what the method can "
        "take",
        maps.size() > 1 ? fmt::format("map {}: ", *which) : "", which - beyond.begin()));
  const auto lost = static_cast<std::size_t>(std::ranges::count(missing, 1));
  if (lost > 0 && outside == OutsidePolicy::Error) {
    const auto which = std::ranges::find(missing, 1) - missing.begin();
    throw InputError(
        fmt::format("{} of {} points, the first of them number {}, are outside {} or have no coordinates "
                    "there; --outside rest leaves them where they are, --outside nan writes nan",
                    lost, points, which, cage.name()));
  }
  for (Deformed& one : all) one.without_image = missing;
  return all;
}

}  // namespace cageproof::cli
